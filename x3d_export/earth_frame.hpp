#pragma once
#include <array>

#include "city_db/units.hpp"

/// Where a place of the plan is on the Earth: for formats that place models on a globe.
namespace vicus {

/// Columns of a rigid motion: the images of the x, y and z axes, then of the origin.
struct Placement {
  std::array<std::array<double, 3>, 4> columns{};
  std::array<double, 3> operator()(const std::array<double, 3>& p) const;
};

/// The frame at a plan point (metres: x = plan east, y = plan north, z = up) as WGS84 earth-centred coordinates.
/// `height_m` above the ellipsoid.
/// Error   the plan's scale, 1 at the city's origin, is taken as 1: 0.3 mm over a sector of 200 m, 10 km from there.
Placement earth_from_plan(LatLon origin, PlanPoint at, double height_m);

/// a then b^-1: what takes coordinates of frame `a` to frame `b`, both placed in a third one.
Placement relative(const Placement& a, const Placement& b);

}  // namespace vicus
