#include "sectorgen/models/roof_crossings.hpp"

#include <algorithm>
#include <cmath>

namespace vicus {
namespace {

/// The line through (x, y) along (dx, dy), cut to the box of the two triangles beside the edge.
Segment within(const Mesh& mesh, std::uint32_t t, std::uint32_t n, double x, double y, double dx, double dy) {
  double least = -HUGE_VAL, most = HUGE_VAL, west = HUGE_VAL, east = -HUGE_VAL, south = HUGE_VAL, north = -HUGE_VAL;
  for (const std::uint32_t triangle : {t, n})
    for (int k = 0; k < 3; ++k) {
      const PlanPoint p = mesh.points[mesh.corner(triangle, k)];
      west = std::min(west, double(p.x)), east = std::max(east, double(p.x));
      south = std::min(south, double(p.y)), north = std::max(north, double(p.y));
    }
  const auto cut = [&](double at, double d, double low, double high) {
    if (std::abs(d) < 1e-12) return;
    const double s = (low - at) / d, e = (high - at) / d;
    least = std::max(least, std::min(s, e));
    most = std::min(most, std::max(s, e));
  };
  cut(x, dx, west, east);
  cut(y, dy, south, north);
  const auto at = [&](double s) {
    return PlanPoint{static_cast<std::int32_t>(std::lround(x + s * dx)),
                     static_cast<std::int32_t>(std::lround(y + s * dy))};
  };
  return {at(least), at(most)};
}

}  // namespace

std::vector<Segment> crossing_cuts(const PlanCover& cover, double least_m) {
  std::vector<Segment> cuts;
  for (std::uint32_t t = 0; t < cover.face.size(); ++t) {
    if (cover.face[t] == kNone) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = cover.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
      if (n == kNone || n < t || cover.face[n] == kNone || cover.face[n] == cover.face[t]) continue;
      const FacePlane &f = cover.planes[cover.face[t]], &g = cover.planes[cover.face[n]];
      const PlanPoint a = cover.mesh.points[cover.mesh.corner(t, k + 1)],
                      b = cover.mesh.points[cover.mesh.corner(t, k + 2)];
      const double at_a = f.up_at(a.x, a.y) - g.up_at(a.x, a.y), at_b = f.up_at(b.x, b.y) - g.up_at(b.x, b.y);
      if (at_a * at_b >= 0 || std::min(std::abs(at_a), std::abs(at_b)) <= least_m) continue;
      const double s = at_a / (at_a - at_b), gx = f.gx - g.gx, gy = f.gy - g.gy, length = std::hypot(gx, gy);
      if (length == 0) continue;
      const Segment cut = within(cover.mesh, t, n, a.x + s * (double(b.x) - a.x), a.y + s * (double(b.y) - a.y),
                                 -gy / length, gx / length);
      if (cut.a != cut.b) cuts.push_back(cut);
    }
  }
  return cuts;
}

std::vector<Segment> lozenge(PlanPoint middle, std::int32_t radius_mm) {
  const PlanPoint east{middle.x + radius_mm, middle.y}, north{middle.x, middle.y + radius_mm},
      west{middle.x - radius_mm, middle.y}, south{middle.x, middle.y - radius_mm};
  return {{east, north}, {north, west}, {west, south}, {south, east}};
}

}  // namespace vicus
