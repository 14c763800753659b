#pragma once
#include "city_db/prism_tile.hpp"
#include "sectorgen/bake/bake_scene.hpp"

namespace vicus {

/// The houses that reach into the square, whole, with points rounded to 1/512 of its side (10 cm at least) on a lattice
/// that all tiles of one size share, and footprints simplified by as much: two tiles that both have a house have the
/// same.
///
/// Error   error_mm: rounding and simplification in plan, and how far the simple roof passes from the true one (corners
/// of
///         the true roof), both in full. Roofs that no kind fits are flat in the middle between eave and top.
///         A tree that is only painted on the ground counts by the radius of its crown.
/// Cost    0.02 ms a house.
PrismTile bake_prisms(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm);

}  // namespace vicus
