#pragma once
#include "city_db/prism_tile.hpp"
#include "sectorgen/bake/bake_scene.hpp"

/// Trees seen from the air.
namespace vicus {

/// Trees stand in tiles that are seen from near, and where they are few; else they are discs in the ground's colours.
bool has_standing_trees(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm);

/// The trees whose places lie in the tile, and their colours.
/// Needs   steps, base and palette of the tile; half of its side is a whole number of steps.
void set_trees(const BakeScene& scene, PrismTile& tile);

/// How far a disc is from its tree's crown, at most: the largest radius of a crown in the tile, metres. 0: none.
double flat_trees_error_m(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm);

}  // namespace vicus
