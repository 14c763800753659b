#include "sectorgen/geo/neighbours.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

#include "city_db/boxes.hpp"
#include "sectorgen/geo/box_pairs.hpp"
#include "sectorgen/geo/shared_area.hpp"
#include "sectorgen/geo/tag_values.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {

namespace {

constexpr double kSharedGroundM2 = 1;
constexpr double kInsideHouseM = 1;

bool is_house(const Footprint& footprint) { return !footprint.is_part && footprint.base_m <= 0; }

std::vector<PlanBox> boxes_of(const std::vector<Footprint>& footprints) {
  std::vector<PlanBox> boxes;
  boxes.reserve(footprints.size());
  for (const Footprint& footprint : footprints) boxes.push_back(box_of(footprint.area.outer));
  return boxes;
}

PlanPoint middle_of_common_box(const PlanBox& a, const PlanBox& b) {
  const auto middle = [](std::int32_t low, std::int32_t high) {
    return static_cast<std::int32_t>((std::int64_t{low} + high) / 2);
  };
  return {middle(std::max(a.min.x, b.min.x), std::min(a.max.x, b.max.x)),
          middle(std::max(a.min.y, b.min.y), std::min(a.max.y, b.max.y))};
}

std::string with_unit(double value, const char* format) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// What must be equal besides the rings for two footprints to be the same thing.
std::vector<std::string> identity_of(const Footprint& footprint) {
  std::vector<std::string> identity = {footprint.is_part ? "part" : "house"};
  for (const char* key : {"min_height", "building:min_level", "min_level"})
    identity.push_back(tag(footprint.tags, key));
  if (footprint.is_part)
    for (const char* key : {"height", "building:levels", "roof:shape", "roof:height"})
      identity.push_back(tag(footprint.tags, key));
  return identity;
}

Polygon canonical(Polygon polygon) {
  canonicalise(polygon.outer);
  for (Ring& hole : polygon.holes) canonicalise(hole);
  std::sort(polygon.holes.begin(), polygon.holes.end());
  return polygon;
}

bool is_same(const Footprint& a, const Footprint& b) {
  if (a.area.outer.size() != b.area.outer.size() || a.area.holes.size() != b.area.holes.size()) return false;
  if (identity_of(a) != identity_of(b)) return false;
  const Polygon p = canonical(a.area), q = canonical(b.area);
  return p.outer == q.outer && p.holes == q.holes;
}

}  // namespace

void drop_duplicates(std::vector<Footprint>& footprints, std::vector<bool>& is_cut, std::vector<Issue>& issues) {
  assert(footprints.size() == is_cut.size());
  const std::vector<PlanBox> boxes = boxes_of(footprints);
  std::vector<std::size_t> order(footprints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::tuple(boxes[i].min, boxes[i].max, i); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  std::vector<bool> is_gone(footprints.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    const PlanBox& box = boxes[order[first]];
    while (end < order.size() && boxes[order[end]].min == box.min && boxes[order[end]].max == box.max) ++end;
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t j = i + 1; j < end; ++j)
        if (!is_gone[order[i]] && !is_gone[order[j]] && is_same(footprints[order[i]], footprints[order[j]])) {
          is_gone[order[j]] = true;
          footprints[order[i]].tags.merge(Tags(footprints[order[j]].tags));
        }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (is_gone[i]) {
      issues.push_back({IssueCode::duplicate, "The same outline was there before; left out.", footprints[i].source_id,
                        footprints[i].area.outer[0]});
      continue;
    }
    if (kept != i) footprints[kept] = std::move(footprints[i]);
    is_cut[kept++] = is_cut[i];
  }
  footprints.resize(kept);
  is_cut.resize(kept);
}

void find_overlaps(const std::vector<Footprint>& footprints, std::vector<Issue>& issues) {
  const std::vector<PlanBox> boxes = boxes_of(footprints);
  for (const auto& [i, j] : box_pairs(boxes, 0)) {
    if (!is_house(footprints[i]) || !is_house(footprints[j])) continue;
    if (common_box_m2(boxes[i], boxes[j]) <= kSharedGroundM2) continue;
    const double shared = shared_area_m2(footprints[i].area, footprints[j].area);
    if (shared <= kSharedGroundM2) continue;
    issues.push_back({IssueCode::overlap,
                      "Shares " + with_unit(shared, "%.1f m²") + " of ground with " + footprints[i].source_id + ".",
                      footprints[j].source_id, middle_of_common_box(boxes[i], boxes[j])});
  }
}

void adopt_lost_parts(std::vector<Footprint>& footprints, std::vector<Issue>& issues) {
  std::vector<PlanBox> parts, houses;
  std::vector<std::size_t> part_index, house_index;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    (footprints[i].is_part ? parts : houses).push_back(box_of(footprints[i].area.outer));
    (footprints[i].is_part ? part_index : house_index).push_back(i);
  }
  std::vector<double> covered(parts.size(), 0);
  if (!parts.empty())
    for (const auto& [part, house] : box_pairs(parts, houses))
      covered[part] += shared_area_m2(footprints[part_index[part]].area, footprints[house_index[house]].area);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Footprint& part = footprints[part_index[i]];
    if (covered[i] * 2 >= area_m2(part.area)) continue;
    part.is_part = false;
    issues.push_back({IssueCode::part_outside, "A building:part outside of any building; taken as a building.",
                      part.source_id, part.area.outer[0]});
  }
}

void find_blocked_streets(const std::vector<Footprint>& footprints, const std::vector<Axis>& axes,
                          std::vector<Issue>& issues) {
  std::vector<PlanBox> segments, houses;
  std::vector<std::pair<std::size_t, std::size_t>> segment_of;  // axis, point
  std::vector<std::size_t> house_of;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].is_passage || axes[i].is_bridge) continue;
    for (std::size_t p = 0; p + 1 < axes[i].line.size(); ++p) {
      segments.push_back(box_of(Ring{axes[i].line[p], axes[i].line[p + 1]}));
      segment_of.emplace_back(i, p);
    }
  }
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (!is_house(footprints[i])) continue;
    houses.push_back(box_of(footprints[i].area.outer));
    house_of.push_back(i);
  }
  struct Inside {
    double length_m = 0;
    PlanPoint at;
  };
  std::map<std::pair<std::size_t, std::size_t>, Inside> inside_of;  // axis, footprint
  for (const auto& [segment, house] : box_pairs(segments, houses)) {
    const auto [axis, p] = segment_of[segment];
    PlanPoint at;
    const double length =
        inside_length_m(axes[axis].line[p], axes[axis].line[p + 1], footprints[house_of[house]].area, at);
    if (length <= 0) continue;
    Inside& inside = inside_of[{axis, house_of[house]}];
    if (inside.length_m == 0) inside.at = at;
    inside.length_m += length;
  }
  for (const auto& [pair, inside] : inside_of)
    if (inside.length_m > kInsideHouseM)
      issues.push_back({IssueCode::building_in_street,
                        "Runs " + with_unit(inside.length_m, "%.1f m") + " inside of " +
                            footprints[pair.second].source_id + " without a passage.",
                        axes[pair.first].source_id, inside.at});
}

}  // namespace vicus
