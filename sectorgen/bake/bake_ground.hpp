#pragma once
#include "city_db/ground_tile.hpp"
#include "sectorgen/bake/bake_scene.hpp"

namespace vicus {

/// The ground of a square: heights of the terrain at 33 x 33 nodes (3 x 3 where it has none), and a picture of 256 x
/// 256 texels, each the mean of 16 samples of what lies on the ground, darkened by the houses around where
/// with_ambient. Below houses the ground beside them goes on.
///
/// Error   at the nodes half a step of height: 5 mm in tiles that rise less than 650 m. Between nodes not bounded.
GroundTile bake_ground(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm, bool with_ambient = true);

}  // namespace vicus
