#pragma once
#include <vector>

#include "sectorgen/sectors/tours/shortest_walk.hpp"

/// A walk with its bends rounded.
namespace vicus {

struct RoundedPoint {
  double east_mm = 0, north_mm = 0;
  double walked_mm = 0;
  double straight_mm = 0;  ///< the same place along the walk before it was rounded
};

/// Each bend becomes an arc of its radius that touches both legs, or of a smaller one where a leg is too short; a bend
/// of radius 0 stays. Arcs turn at most kArcStep_deg from point to point.
///
/// Clearance  the arc cuts off what no disc of that radius reaches inside the bend: a circle of that radius around the
///            wall's corner, which the legs do not enter, is not entered by the arc.
std::vector<RoundedPoint> round_bends(const Walk& walk);

inline constexpr double kArcStep_deg = 10;

}  // namespace vicus
