#pragma once
#include <string>

#include "x3d_export/city_index.hpp"
#include "x3d_export/scene.hpp"

/// The root world of the city seen from above (paper 001 §6): a viewpoint over it, the shader of its tiles, and the
/// FLYER Script that fetches them as the visitor flies. The page of `vicus serve` takes the shader and leaves the
/// Script. Frame   the plan frame in X3D axes.
namespace vicus {

inline constexpr const char* kFlyoverName = "flyover.x3d";

/// Needs   meta "tile_levels" for a view of the whole city; without it the viewpoint is 500 m up.
Scene flyover_scene(const RecordSource& source);

}  // namespace vicus
