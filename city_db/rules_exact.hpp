#pragma once
#include <cstdint>

#include "city_db/units.hpp"

/// Exact predicates of the checker: its own, so that an error of the generator's cannot hide itself.
namespace vicus::rules {

__extension__ using Int128 = __int128;

/// > 0: c is on the left of a -> b. orient(a,b,c) == -orient(b,a,c).
/// Needs   |coordinate| < 2^30: differences < 2^31, products < 2^62, their difference < 2^63.
inline std::int64_t orient(PlanPoint a, PlanPoint b, PlanPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

inline int sign(std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// Does p lie on segment ab but at neither end?
inline bool is_inside_segment(PlanPoint p, PlanPoint a, PlanPoint b) {
  const bool is_between = a < b ? a < p && p < b : b < p && p < a;
  return is_between && orient(a, b, p) == 0;
}

/// Do the segments share one point interior to both, and only that?
inline bool cross_properly(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) {
  return sign(orient(a, b, c)) * sign(orient(a, b, d)) < 0 && sign(orient(c, d, a)) * sign(orient(c, d, b)) < 0;
}

/// a.x * b.y - a.y * b.x: twice the signed area of triangle (0, a, b).
inline std::int64_t cross(PlanPoint a, PlanPoint b) { return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x; }

}  // namespace vicus::rules
