#include "sectorgen/bake/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vicus {

SurfaceDistance::SurfaceDistance(const BlockMap& map)
    : map_(map), cell_m_(metres(map.tile_side_mm) / map.side), step_m_(map.step_um * 1e-6) {}

double SurfaceDistance::plane_at(std::size_t cell, CellPoint p) const {
  return map_.height[cell] * step_m_ +
         (slope_of(map_.slope_east[cell]) * p.x + slope_of(map_.slope_north[cell]) * p.y) * cell_m_;
}

double SurfaceDistance::up_at(std::size_t cell, CellPoint p) const {
  if (map_.offset[cell] != 0) {
    const CellLine line = line_of(map_.angle[cell], map_.offset[cell]);
    if (line.east * p.x + line.north * p.y > line.distance) return map_.foot[cell] * step_m_;
  }
  return plane_at(cell, p);
}

double SurfaceDistance::at_most(std::size_t cell, CellPoint at, double up_m, double enough_m) const {
  const long n = static_cast<long>(map_.side), column = static_cast<long>(cell) % n, row = static_cast<long>(cell) / n;
  double least2 = std::numeric_limits<double>::infinity();
  const double enough2 = enough_m * enough_m;
  for (long r = std::max(0L, row - 2); r <= std::min(n - 1, row + 2); ++r)
    for (long c = std::max(0L, column - 2); c <= std::min(n - 1, column + 2); ++c) {
      const auto here = static_cast<std::size_t>(r * n + c);
      const CellPoint q{at.x - static_cast<double>(c - column), at.y - static_cast<double>(r - row)};
      const CellPoint inside{std::clamp(q.x, -0.5, 0.5), std::clamp(q.y, -0.5, 0.5)};
      const double ax = (inside.x - q.x) * cell_m_, ay = (inside.y - q.y) * cell_m_;
      if (ax * ax + ay * ay >= least2) continue;
      // A point of the surface over p, between two heights.
      const auto look = [&](CellPoint p, double a, double b) {
        const double dx = (p.x - q.x) * cell_m_, dy = (p.y - q.y) * cell_m_;
        const double dz = up_m - std::clamp(up_m, std::min(a, b), std::max(a, b));
        least2 = std::min(least2, dx * dx + dy * dy + dz * dz);
      };
      const double up = up_at(here, inside);
      look(inside, up, up);
      if (map_.offset[here] != 0) {
        const CellLine line = line_of(map_.angle[here], map_.offset[here]);
        const double beside = line.east * inside.x + line.north * inside.y - line.distance;
        const CellPoint on{inside.x - line.east * beside, inside.y - line.north * beside};
        if (std::abs(on.x) <= 0.5 && std::abs(on.y) <= 0.5) look(on, map_.foot[here] * step_m_, plane_at(here, on));
      }
      if (c + 1 < n) {
        const double y = inside.y;
        look({0.5, y}, up_at(here, {0.5, y}), up_at(here + 1, {-0.5, y}));
      }
      if (r + 1 < n) {
        const double x = inside.x;
        look({x, 0.5}, up_at(here, {x, 0.5}), up_at(here + static_cast<std::size_t>(n), {x, -0.5}));
      }
      if (least2 < enough2) return std::sqrt(least2);
    }
  return std::sqrt(least2);
}

}  // namespace vicus
