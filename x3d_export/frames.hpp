#pragma once
#include <cstdint>
#include <numbers>

#include "city_db/units.hpp"

/// The one place where plan axes become X3D axes: x = east, y = up, z = -north (DESIGN §2).
namespace vicus {

/// X3D axes, **millimetres**, in the frame of some sector: whole numbers, so that what is written is the lattice.
struct X3dPoint {
  std::int32_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const X3dPoint&, const X3dPoint&) = default;
};

/// Height in metres as whole millimetres.
inline std::int32_t height_mm(double up_m) { return lattice_mm(up_m); }

/// A plan point at a height, in the frame of the sector with that origin.
/// Needs   p within 2^31 mm of the origin: always so on the lattice.
inline X3dPoint x3d_from_plan(PlanPoint p, std::int32_t up_mm, PlanPoint origin) {
  return {p.x - origin.x, up_mm, origin.y - p.y};
}

/// Inverse of x3d_from_plan: plan_from_x3d(x3d_from_plan(p, u, o), o) == p.
inline PlanPoint plan_from_x3d(X3dPoint p, PlanPoint origin) { return {origin.x + p.x, origin.y - p.z}; }

/// Turn about the y axis that makes a Viewpoint (which looks along -z, that is north) look at `heading_deg`, clockwise
/// from north: X3D turns counter-clockwise seen from above.
inline double x3d_yaw_from_heading(double heading_deg) { return -heading_deg * std::numbers::pi / 180.0; }

}  // namespace vicus
