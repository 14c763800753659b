#pragma once
#include <string>

#include "x3d_export/city_index.hpp"

/// The city as 3D Tiles 1.1 with its sectors as tiles.
///
/// Tree    groups by halves of the plan down to at most 8 sectors; then each sector far (sectors/ID.far.glb), refined
///         by its near file (sectors/ID.glb).
/// Errors  geometricError is what is missing, metres: of a group without content the tallest house in it; of a far
///         sector the largest opening it leaves out; of a near one 0.
/// Frame   the root's transform places the city's origin on WGS84, heights taken as above the ellipsoid; each sector
///         has its own, so the plan does not bend away from the globe. Boxes hold their content exactly.
/// Source  OGC 22-025r4 (3D Tiles 1.1).
namespace vicus {

std::string tileset_json(const CityIndex& index);

}  // namespace vicus
