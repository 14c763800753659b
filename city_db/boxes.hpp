#pragma once
#include <algorithm>

#include "city_db/city.hpp"

/// Boxes of plan geometry.
namespace vicus {

/// Empty where there are no points.
inline PlanBox box_of(const std::vector<PlanPoint>& points) {
  PlanBox box;
  for (const PlanPoint p : points) box.add(p);
  return box;
}

/// Holes lie inside the outer ring.
inline PlanBox box_of(const Polygon& polygon) { return box_of(polygon.outer); }

inline PlanBox box_of(PlanPoint a, PlanPoint b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// Closed boxes: touching counts; an empty one meets nothing.
inline bool meet(const PlanBox& a, const PlanBox& b) {
  return !a.is_empty() && !b.is_empty() && a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y &&
         b.min.y <= a.max.y;
}

/// The box with `margin_mm` added on every side.
inline PlanBox grown(const PlanBox& box, std::int32_t margin_mm) {
  return {{box.min.x - margin_mm, box.min.y - margin_mm}, {box.max.x + margin_mm, box.max.y + margin_mm}};
}

}  // namespace vicus
