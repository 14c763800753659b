#pragma once
#include <cassert>
#include <cmath>
#include <cstdint>

#include "city_db/units.hpp"

/// Exact predicates on the 1 mm lattice.
///
/// Needs   coordinates within kPlanLimit (2^30), so that every orientation fits 64 bits; in_circle needs points within
///         2^29 mm (537 km) of each other, so that it fits 128.
/// Error   none.
namespace vicus {

__extension__ typedef __int128 Int128;

/// Twice the signed area of the triangle abc: > 0 when c is left of a -> b.
/// orient(a,b,c) == -orient(c,b,a) == orient(b,c,a).
inline std::int64_t orient(PlanPoint a, PlanPoint b, PlanPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// Squared distance in mm2; dot product of ab and ac.
inline std::int64_t distance2(PlanPoint a, PlanPoint b) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  return dx * dx + dy * dy;
}
inline std::int64_t dot(PlanPoint a, PlanPoint b, PlanPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - a.x) + (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - a.y);
}

/// Floor of the square root.
inline std::int64_t integer_sqrt(std::int64_t n) {
  assert(n >= 0);
  auto r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
  while (r * r > n) --r;
  while ((r + 1) * (r + 1) <= n) ++r;
  return r;
}
/// Length in whole millimetres, rounded down; the only length that decisions depend on.
inline std::int64_t length_mm(PlanPoint a, PlanPoint b) { return integer_sqrt(distance2(a, b)); }

/// Sign of the in-circle determinant for counter-clockwise abc: > 0 when d is inside their circle.
inline int in_circle(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) {
  const std::int64_t ax = std::int64_t{a.x} - d.x, ay = std::int64_t{a.y} - d.y;
  const std::int64_t bx = std::int64_t{b.x} - d.x, by = std::int64_t{b.y} - d.y;
  const std::int64_t cx = std::int64_t{c.x} - d.x, cy = std::int64_t{c.y} - d.y;
  const Int128 det = Int128{ax * ax + ay * ay} * (bx * cy - by * cx) + Int128{bx * bx + by * by} * (cx * ay - cy * ax) +
                     Int128{cx * cx + cy * cy} * (ax * by - ay * bx);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

/// p lies on the closed segment ab.
inline bool on_segment(PlanPoint a, PlanPoint b, PlanPoint p) { return orient(a, b, p) == 0 && dot(p, a, b) <= 0; }

/// The open segments ab and cd cross in one point that is an end of neither.
inline bool cross_properly(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) {
  const auto side = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
  return side(orient(a, b, c)) * side(orient(a, b, d)) < 0 && side(orient(c, d, a)) * side(orient(c, d, b)) < 0;
}

}  // namespace vicus
