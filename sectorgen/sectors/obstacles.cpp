#include "sectorgen/sectors/obstacles.hpp"

#include <algorithm>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"
#include "sectorgen/sectors/building_parts.hpp"
#include "sectorgen/sectors/overlay.hpp"

namespace vicus {
namespace {

constexpr double kPassageHalfWidthMin = 1.25, kPassageHalfWidthMax = 3.0;
// A street through a house without a passage: farther than a corner is cut, no farther than a broad viaduct, the house
// longer than that, and something of it on both sides.
constexpr double kThroughLeastM = 3, kThroughMostM = 60, kLongHouse = 2.5, kPierM2 = 6;
constexpr double kStreetHalfWidthMax = 9;
constexpr double kLeastOverM = 0.5;        // a deck is on the water; less is a way along the bank
constexpr double kOpeningHalfWidth = 1.5;  // a gate in a wall or fence
constexpr double kWallThicknessMin = 0.2;  // thinner ones would come out as slivers

/// Strokes along axes, found again by box.
struct Strokes {
  std::vector<Stroke> strokes;
  BoxIndex index;
  Strokes(std::vector<Stroke> s) : strokes(std::move(s)) {
    std::vector<PlanBox> boxes;
    for (const auto& stroke : strokes) boxes.push_back(grown(box_of(stroke.line), lattice_mm(stroke.radius_m + 1)));
    index = BoxIndex(std::move(boxes));
  }
  std::vector<Stroke> near(const PlanBox& box) const {
    std::vector<Stroke> out;
    for (std::uint32_t i : index.meeting(box)) out.push_back(strokes[i]);
    return out;
  }
};

/// Streets that are no passage and no bridge, to see which of them lead through a house.
struct Streets {
  std::vector<std::uint32_t> axes;
  BoxIndex index;
  explicit Streets(const SourceMap& map) {
    std::vector<PlanBox> boxes;
    for (std::uint32_t i = 0; i < map.axes.size(); ++i) {
      if (map.axes[i].is_passage || map.axes[i].is_bridge) continue;
      axes.push_back(i);
      boxes.push_back(box_of(map.axes[i].line));
    }
    index = BoxIndex(std::move(boxes));
  }
};

double length_inside_m(const Line& line, const Polygon& area) {
  double length = 0;
  PlanPoint middle;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += inside_length_m(line[i], line[i + 1], area, middle);
  return length;
}

Stroke street_stroke(const Axis& axis) {
  return {axis.line, std::clamp(axis.width_m / 2, kPassageHalfWidthMin, kStreetHalfWidthMax)};
}

/// Do the strokes part the house in pieces that count, or open a court in it?
bool part(const Polygon& house, const std::vector<Stroke>& strokes) {
  int large = 0;
  std::size_t holes = 0;
  for (const auto& p : subtract(house, stroke_outlines(strokes, Cap::square))) {
    large += area_m2(p) >= kPierM2;
    holes += p.holes.size();
  }
  return large >= 2 || (large == 1 && holes < house.holes.size());
}

/// Streets that lead right through a long house, ways that meet inside taken together. What cuts a corner or ends
/// inside does not.
std::vector<std::uint32_t> unmapped_passages(const SourceMap& map, const Streets& streets, const Polygon& house) {
  struct Chain {
    std::vector<std::uint32_t> axes;
    std::vector<Stroke> strokes;
    std::vector<PlanPoint> ends;  // inside the house
  };
  std::vector<Chain> chains;
  const double length = perimeter_m(house.outer) / 2;
  for (std::uint32_t k : streets.index.meeting(box_of(house))) {
    const Axis& axis = map.axes[streets.axes[k]];
    const double inside = length_inside_m(axis.line, house);
    if (inside < kThroughLeastM || inside > kThroughMostM || inside * kLongHouse > length) continue;
    Chain chain{{streets.axes[k]}, {street_stroke(axis)}, {}};
    for (PlanPoint end : {axis.line.front(), axis.line.back()})
      if (locate(house, end) == Side::inside) chain.ends.push_back(end);
    for (auto it = chains.begin(); it != chains.end();) {  // joins those that end where this one does
      const bool meets = std::any_of(chain.ends.begin(), chain.ends.end(), [&](PlanPoint p) {
        return std::find(it->ends.begin(), it->ends.end(), p) != it->ends.end();
      });
      if (!meets) {
        ++it;
        continue;
      }
      chain.axes.insert(chain.axes.end(), it->axes.begin(), it->axes.end());
      chain.strokes.insert(chain.strokes.end(), it->strokes.begin(), it->strokes.end());
      chain.ends.insert(chain.ends.end(), it->ends.begin(), it->ends.end());
      it = chains.erase(it);
    }
    chains.push_back(std::move(chain));
  }
  std::vector<std::uint32_t> through;
  for (const Chain& chain : chains)
    if (part(house, chain.strokes)) through.insert(through.end(), chain.axes.begin(), chain.axes.end());
  std::sort(through.begin(), through.end());
  return through;
}

/// The fault "the street stops at the house" becomes "a passage was made".
void report_passage(const Axis& axis, const Footprint& house, std::vector<Issue>& issues) {
  PlanPoint at = axis.line.front();
  std::erase_if(issues, [&](const Issue& issue) {
    const bool is_it = issue.code == IssueCode::building_in_street && issue.source_id == axis.source_id &&
                       locate(house.area, issue.at) != Side::outside;
    if (is_it) at = issue.at;
    return is_it;
  });
  issues.push_back({IssueCode::unmapped_passage,
                    "Leads right through " + house.source_id + ", which shows no passage; one was made.",
                    axis.source_id, at});
}

/// What stands over the footprint's ground: one column, or those of its parts.
std::vector<HouseColumn> columns_of(const SourceMap& map, const BuildingParts& parts, std::uint32_t footprint) {
  if (parts.has_parts(footprint)) return parts.columns_of(footprint);
  const Footprint& f = map.footprints[footprint];
  return {{footprint, f.area, f.base_m, f.height_m, f.eave_m, true}};
}

void add_houses(const SourceMap& map, Blocks& blocks, std::vector<Issue>& issues) {
  std::vector<Stroke> passages;
  for (const auto& axis : map.axes)
    if (axis.is_passage)
      passages.push_back({axis.line, std::clamp(axis.width_m / 2, kPassageHalfWidthMin, kPassageHalfWidthMax)});
  const Strokes strokes(std::move(passages));
  const Streets streets(map);
  const BuildingParts parts(map);
  for (std::uint32_t i = 0; i < map.footprints.size(); ++i) {
    const Footprint& f = map.footprints[i];
    if (f.is_part || parts.is_part(i)) continue;
    auto near = strokes.near(box_of(f.area));
    if (f.base_m <= kWalkUnderMetres)
      for (std::uint32_t k : unmapped_passages(map, streets, f.area)) {
        near.push_back(street_stroke(map.axes[k]));
        report_passage(map.axes[k], f, issues);
      }
    const auto ways = near.empty() ? std::vector<Polygon>{} : stroke_outlines(near, Cap::square);
    for (HouseColumn& column : columns_of(map, parts, i)) {
      House house{column.footprint, {}, false, 0, column.top_m, column.eave_m, i, column.is_main, parts.has_parts(i)};
      const auto add = [&](Polygon area, bool is_overhead, double base_m) {
        blocks.houses.push_back(house);
        blocks.houses.back().area = std::move(area);
        blocks.houses.back().is_overhead = is_overhead;
        blocks.houses.back().base_m = base_m;
      };
      if (column.base_m > kWalkUnderMetres) {
        add(std::move(column.area), true, column.base_m);
      } else if (ways.empty()) {
        add(std::move(column.area), false, 0);
      } else {
        const double headroom = std::min(kPassageHeadroom, 0.7 * column.top_m);
        for (auto& p : subtract(column.area, ways)) add(std::move(p), false, 0);
        for (auto& p : intersect(column.area, ways)) {
          blocks.passages.push_back(p);
          add(std::move(p), true, headroom);
        }
      }
    }
  }
}

/// Does the line run over the area, and not only along its rim? A bridge may begin and end just at the banks.
bool runs_over(const Line& line, const Polygon& area) { return length_inside_m(line, area) > kLeastOverM; }

void add_water(const SourceMap& map, Blocks& blocks) {
  std::vector<Stroke> decks;
  for (const auto& axis : map.axes)
    if (!axis.is_passage) decks.push_back({axis.line, axis.width_m / 2 + 1});
  const Strokes strokes(std::move(decks));
  const auto streets_over = [&](const Polygon& area) {
    auto near = strokes.near(box_of(area));
    std::erase_if(near, [&](const Stroke& s) { return !runs_over(s.line, area); });
    return near;
  };
  std::vector<Polygon> outlines;  // decks as they are drawn, where a street leads over them
  std::vector<PlanBox> boxes;
  for (const auto& area : map.areas)
    if (area.kind == AreaKind::deck && !streets_over(area.area).empty())
      outlines.push_back(area.area), boxes.push_back(box_of(area.area));
  const BoxIndex outline_index(std::move(boxes));
  for (const auto& area : map.areas) {
    if (area.kind != AreaKind::water) continue;
    const auto near = streets_over(area.area);
    if (near.empty()) {
      blocks.water.push_back(area.area);
      continue;
    }
    std::vector<Polygon> open = stroke_outlines(near, Cap::flat);
    for (const std::uint32_t i : outline_index.meeting(box_of(area.area))) open.push_back(outlines[i]);
    for (auto& p : subtract(area.area, open)) blocks.water.push_back(std::move(p));
  }
}

void add_walls(const SourceMap& map, Blocks& blocks) {
  std::vector<Stroke> ways;
  for (const auto& axis : map.axes) ways.push_back({axis.line, axis.width_m / 2 + 0.5});
  const Strokes strokes(std::move(ways));
  for (std::uint32_t i = 0; i < map.barriers.size(); ++i) {
    const Barrier& b = map.barriers[i];
    const double half = std::max(kWallThicknessMin, b.thickness_m) / 2;
    auto open = strokes.near(grown(box_of(b.line), lattice_mm(half)));
    for (PlanPoint p : b.openings) {
      const std::int32_t d = lattice_mm(kOpeningHalfWidth);
      open.push_back({{{p.x - d, p.y}, {p.x + d, p.y}}, kOpeningHalfWidth});
    }
    for (auto& area : stroke_outlines({{b.line, half}}, Cap::flat)) {
      if (open.empty()) {
        blocks.walls.push_back({i, std::move(area)});
        continue;
      }
      for (auto& p : subtract(area, stroke_outlines(open, Cap::flat))) blocks.walls.push_back({i, std::move(p)});
    }
  }
}

}  // namespace

Blocks make_blocks(const SourceMap& map, std::vector<Issue>& issues) {
  Blocks blocks;
  add_houses(map, blocks, issues);
  add_water(map, blocks);
  add_walls(map, blocks);
  return blocks;
}

}  // namespace vicus
