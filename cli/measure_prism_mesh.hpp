#pragma once
#include "city_db/prism_tile.hpp"
#include "sectorgen/bake/render/render_mesh.hpp"

namespace vicus::measure {

/// The client's walls (client_scripts/core/prismMesh.js) and its shader's windows (x3d/flyover.frag), shares of a
/// window and the wall around it; measure_forms_test holds them to each other.
inline constexpr double kWindowWidth_m = 2.7, kStorey_m = 3.1, kBlind_m = 2.2;
inline constexpr double kWindowLow[] = {0.29, 0.3}, kWindowHigh[] = {0.71, 0.84}, kOpaque = 0.8;
inline constexpr double kGlass[] = {0.27, 0.31, 0.36};

/// Adds the houses and trees of a tile as a client draws them: walls from the ground with its shader's windows, simple
/// roofs (prism_tile.hpp). A house that several tiles hold is added by the one that owns it, unless `all`. Returns what
/// memory_of counts for the windows, bytes: a shader paints them, no card holds them.
/// Needs   a tile from decode_prisms or bake_prisms.
double add_prisms(RenderMesh& mesh, const PrismTile& tile, bool all);

}  // namespace vicus::measure
