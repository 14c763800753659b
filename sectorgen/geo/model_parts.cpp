#include "sectorgen/geo/model_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace vicus {
namespace {

constexpr double kMeets_m = 0.15;
constexpr double kUpright = 0.5;          // the largest vertical part of a unit normal that a facade's opening has
constexpr int kGreyChroma = 4;            // channels so close are grey
constexpr std::uint8_t kPlainGrey = 125;  // and so bright nobody's choice

struct Box {
  ModelCorner low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  void add(const ModelCorner& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool meets(const Box& o) const {
    return low.x - kMeets_m <= o.high.x && o.low.x - kMeets_m <= high.x && low.y - kMeets_m <= o.high.y &&
           o.low.y - kMeets_m <= high.y && low.z - kMeets_m <= o.high.z && o.low.z - kMeets_m <= high.z;
  }
};

ModelCorner newell(const ModelSurface& surface) {
  ModelCorner n;
  const auto& ring = surface.rings[0];
  const ModelCorner o = ring[0];
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ModelCorner &p = ring[i], &q = ring[(i + 1) % ring.size()];
    n.x += (p.y - q.y) * (p.z + q.z - 2 * o.z);
    n.y += (p.z - q.z) * (p.x + q.x - 2 * o.x);
    n.z += (p.x - q.x) * (p.y + q.y - 2 * o.y);
  }
  return n;
}

double area(const ModelSurface& surface) {
  const ModelCorner n = newell(surface);
  return std::hypot(n.x, n.y, n.z) / 2;
}

/// Numbers of groups, the same for surfaces that meet directly or through others.
std::vector<std::size_t> joined(const std::vector<Box>& boxes) {
  std::vector<std::size_t> of(boxes.size());
  std::iota(of.begin(), of.end(), std::size_t{0});
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (of[i] != of[k] && boxes[i].meets(boxes[k])) std::replace(of.begin(), of.end(), of[i], of[k]);
  return of;
}

bool is_plain(Colour c) {
  const auto [low, high] = std::minmax({c.r, c.g, c.b});
  return high - low <= kGreyChroma && low >= kPlainGrey;
}

}  // namespace

ModelCorner unit_normal(const ModelSurface& surface) {
  const ModelCorner n = newell(surface);
  const double length = std::hypot(n.x, n.y, n.z);
  return length > 0 ? ModelCorner{n.x / length, n.y / length, n.z / length} : ModelCorner{};
}

std::vector<SurfaceGroup> opening_groups(const ModelObject& object) {
  std::map<std::pair<bool, std::size_t>, std::vector<const ModelSurface*>> elements;
  for (const ModelSurface& surface : object.surfaces)
    if (surface.part == ModelPart::door || surface.part == ModelPart::window)
      elements[{surface.part == ModelPart::door, surface.element}].push_back(&surface);
  std::vector<SurfaceGroup> groups;
  for (const auto& [key, surfaces] : elements) {
    std::vector<Box> boxes(surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      for (const ModelCorner& p : surfaces[i]->rings[0]) boxes[i].add(p);
    const auto of = joined(boxes);
    std::map<std::size_t, std::vector<const ModelSurface*>> members;
    for (std::size_t i = 0; i < surfaces.size(); ++i) members[of[i]].push_back(surfaces[i]);
    for (const auto& [number, list] : members) {
      const ModelSurface& largest = **std::max_element(
          list.begin(), list.end(), [](const ModelSurface* a, const ModelSurface* b) { return area(*a) < area(*b); });
      if (std::abs(unit_normal(largest).z) > kUpright) continue;
      SurfaceGroup& group = groups.emplace_back();
      group.is_door = key.first;
      for (const ModelSurface* surface : list)
        group.corners.insert(group.corners.end(), surface->rings[0].begin(), surface->rings[0].end());
    }
  }
  return groups;
}

void add_colours(const ModelObject& object, Tags& tags) {
  for (const auto& [part, key] : {std::pair(ModelPart::wall, "building:colour"), {ModelPart::roof, "roof:colour"}}) {
    std::map<std::tuple<std::uint8_t, std::uint8_t, std::uint8_t>, double> areas;
    for (const ModelSurface& surface : object.surfaces)
      if (surface.part == part && surface.colour)
        areas[{surface.colour->r, surface.colour->g, surface.colour->b}] += area(surface);
    if (areas.empty() || tags.contains(key)) continue;
    const auto& [r, g, b] = std::max_element(areas.begin(), areas.end(), [](const auto& x, const auto& y) {
                              return x.second < y.second;
                            })->first;
    if (!is_plain({r, g, b})) tags[key] = hex_of({r, g, b});
  }
}

}  // namespace vicus
