#pragma once
#include <cmath>
#include <optional>

#include "city_db/city.hpp"

/// Openings in walls.
namespace vicus {

/// A direction in plan, of length 1.
struct Heading {
  double x = 0, y = 0;
};
inline Heading heading_of(PlanPoint a, PlanPoint b) {
  const double x = double(b.x) - a.x, y = double(b.y) - a.y, length = std::hypot(x, y);
  return {x / length, y / length};
}
inline Heading right_of(Heading h) { return {h.y, -h.x}; }
inline Heading reversed(Heading h) { return {-h.x, -h.y}; }

inline PlanPoint moved(PlanPoint p, Heading h, double mm) {
  return {p.x + static_cast<std::int32_t>(std::lround(h.x * mm)),
          p.y + static_cast<std::int32_t>(std::lround(h.y * mm))};
}

/// Where a ray from `p` first meets an edge of the ring that it crosses inwards (the ring's inside is on its left).
struct RayHit {
  std::size_t edge = 0;  ///< from ring[edge] to the next
  double share = 0;      ///< of the edge
  double distance_mm = 0;
};
std::optional<RayHit> first_hit(const Ring& ring, PlanPoint p, Heading ray);

/// Joins the opening p-q to the room by a doorway along `ray`, which leads into the room. p and q become corners of the
/// ring, one after the other: true when p comes first.
/// Fails   nullopt: the doorway would be deeper than kDeepestDoorway_m, or not deep at all, or meet a corner of the
/// room, or another
///         doorway; the ring is as it was.
std::optional<bool> open_doorway(Ring& ring, PlanPoint p, PlanPoint q, Heading ray);

/// Closed: neither end is outside, and the segment crosses no edge.
bool is_segment_inside(PlanPoint a, PlanPoint b, const Polygon& polygon);

}  // namespace vicus
