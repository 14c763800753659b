#pragma once
#include "city_db/prism_tile.hpp"
#include "sectorgen/bake/render/render_mesh.hpp"

namespace vicus::measure {

/// Adds the houses and trees of a tile as a client draws them: walls from the ground with its shader's windows, simple
/// roofs (prism_tile.hpp). A house that several tiles hold is added by the one that owns it, unless `all`. Returns what
/// memory_of counts for the windows, bytes: a shader paints them, no card holds them.
/// Needs   a tile from decode_prisms or bake_prisms.
double add_prisms(RenderMesh& mesh, const PrismTile& tile, bool all);

}  // namespace vicus::measure
