#pragma once
#include "city_db/city.hpp"
#include "sectorgen/bake/render/render_mesh.hpp"

namespace vicus {

/// Adds the picture in its gate, as a browser shows it: not lit, seen from its front.
/// Fails   CityError: its image is no PNG.
void add_impostor(RenderMesh& mesh, const GateImpostor& impostor);
/// The same of all sides of a panorama.
void add_panorama(RenderMesh& mesh, const Panorama& panorama);

}  // namespace vicus
