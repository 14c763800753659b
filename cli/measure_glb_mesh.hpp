#pragma once
#include <map>
#include <memory>
#include <string>

#include "city_db/units.hpp"
#include "sectorgen/bake/render/render_mesh.hpp"

namespace vicus::measure {

/// Images of GLB files by their PNG bytes, made ready for rays once.
using PngImages = std::map<std::string, std::shared_ptr<const RepeatedImage>>;

/// Adds to `mesh` what a GLB of x3d_export/glb.hpp holds, decoded by Draco's and meshoptimizer's own decoders, at the
/// sector's origin, but what shuts the gates at the city's end. Returns the CPU time of decoding the geometry, ms.
/// Fails   CityError: other bytes than sector_glb writes.
double add_glb(RenderMesh& mesh, const std::string& file, PlanPoint sector_origin, PngImages& images);

}  // namespace vicus::measure
