#pragma once
#include <algorithm>
#include <cmath>

#include "city_db/units.hpp"

namespace vicus {

/// Distance of p from the segment a-b, ends included, mm. a == b is allowed.
inline double distance_to_segment_mm(PlanPoint p, PlanPoint a, PlanPoint b) {
  const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(px - t * dx, py - t * dy);
}

}  // namespace vicus
