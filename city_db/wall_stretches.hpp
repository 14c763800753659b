#pragma once
#include <vector>

#include "city_db/city.hpp"

namespace vicus {

/// A straight part of a wall; with a door, the part that the door stands in.
struct WallStretch {
  PlanPoint a, b;
  const Door* door = nullptr;
};

/// The stretch a-b of a wall, ground on the left, taken apart at those of the doors that stand in it.
/// Error   a piece's ends are off the stretch by as much as the doors are: doors within kWallReach_mm count.
inline constexpr double kWallReach_mm = 12;
std::vector<WallStretch> wall_stretches(PlanPoint a, PlanPoint b, const std::vector<const Door*>& doors);

}  // namespace vicus
