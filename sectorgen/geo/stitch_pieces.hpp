#pragma once
#include <vector>

#include "sectorgen/geo/source_map.hpp"

namespace vicus {

/// Houses that vector tiles cut, put together again: tiles reach a little beyond their borders, so pieces of one house
/// from different tiles (tag `tile`) share ground. Pieces are joined where the other tags are equal and both are cut,
/// or one lies in the other. The tag `tile` goes. `is_cut` is kept in step.
/// Error   the joined outline is rounded to the lattice where edges cross.
void stitch_pieces(std::vector<Footprint>& footprints, std::vector<bool>& is_cut);

}  // namespace vicus
