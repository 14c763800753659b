#include "city_db/terrain.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vicus {
namespace {

/// A coordinate on the grid: the node at or before it and how far to the next, 0 ... 1.
struct Between {
  std::size_t node = 0, next = 0;
  double share = 0;
};

Between between(std::int64_t mm, std::int32_t step_mm, std::uint32_t nodes) {
  const std::int64_t last = nodes - 1;
  const std::int64_t clamped = std::clamp<std::int64_t>(mm, 0, last * step_mm);
  const std::int64_t node = std::min(clamped / step_mm, last);
  return {static_cast<std::size_t>(node), static_cast<std::size_t>(std::min(node + 1, last)),
          static_cast<double>(clamped - node * step_mm) / step_mm};
}

}  // namespace

double height_m(const Terrain& t, PlanPoint at) {
  if (t.height_mm.empty()) return 0;
  assert(t.step_mm > 0 && t.height_mm.size() == std::size_t{t.columns} * t.rows);
  const Between x = between(std::int64_t{at.x} - t.corner.x, t.step_mm, t.columns);
  const Between y = between(std::int64_t{at.y} - t.corner.y, t.step_mm, t.rows);
  const auto height = [&](std::size_t column, std::size_t row) {
    return static_cast<double>(t.height_mm[row * t.columns + column]);
  };
  const double south = std::lerp(height(x.node, y.node), height(x.next, y.node), x.share);
  const double north = std::lerp(height(x.node, y.next), height(x.next, y.next), x.share);
  return std::lerp(south, north, y.share) / kMmPerMetre;
}

HeightRange height_range(const Terrain& t, const PlanBox& box) {
  if (t.height_mm.empty()) return {};
  assert(!box.is_empty() && t.step_mm > 0 && t.height_mm.size() == std::size_t{t.columns} * t.rows);
  const Between west = between(std::int64_t{box.min.x} - t.corner.x, t.step_mm, t.columns);
  const Between east = between(std::int64_t{box.max.x} - t.corner.x, t.step_mm, t.columns);
  const Between south = between(std::int64_t{box.min.y} - t.corner.y, t.step_mm, t.rows);
  const Between north = between(std::int64_t{box.max.y} - t.corner.y, t.step_mm, t.rows);
  std::int32_t least = t.height_mm[south.node * t.columns + west.node], greatest = least;
  for (std::size_t row = south.node; row <= north.next; ++row)
    for (std::size_t column = west.node; column <= east.next; ++column) {
      const std::int32_t height = t.height_mm[row * t.columns + column];
      least = std::min(least, height);
      greatest = std::max(greatest, height);
    }
  return {least / static_cast<double>(kMmPerMetre), greatest / static_cast<double>(kMmPerMetre)};
}

}  // namespace vicus
