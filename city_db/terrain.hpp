#pragma once
#include "city_db/city.hpp"

/// The height of the ground anywhere.
namespace vicus {

/// Metres above the plan frame's 0: bilinear between the nodes, beyond the rim as at the nearest point of the rim; 0
/// without a terrain.
/// Needs   height_mm.size() == columns * rows, step_mm > 0 where there are nodes.
/// Exact   at every node; elsewhere continuous, between the least and the greatest height of the four nodes around.
double height_m(const Terrain& terrain, PlanPoint at);

struct HeightRange {
  double least_m = 0, greatest_m = 0;
};
/// Bounds of height_m within the box: the least and the greatest node of all cells that it touches.
/// Needs   as height_m; box not empty.
HeightRange height_range(const Terrain& terrain, const PlanBox& box);

}  // namespace vicus
