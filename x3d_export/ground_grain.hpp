#pragma once
#include <span>
#include <string>

#include "x3d_export/mesh.hpp"

namespace vicus {

/// shape_of, solid, under the image of the ground's grain (city_db/ground_grain.hpp) where the faces lie flat enough.
/// There are no texture coordinates: X3D's own run over the box around the Shape, along its longer side and across, and
/// a TextureTransform makes metres of them.   Needs   as shape_of.
/// Source  X3D 4.0, 19100-1 §13.3.6 (IndexedFaceSet, default texture coordinates).
/// Error   neighbouring Shapes do not meet in the grain; it has no pattern that would show it.
Node grained_shape(const std::string& def, std::span<const Face> faces, const std::string& url);

}  // namespace vicus
