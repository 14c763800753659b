#pragma once
#include <set>
#include <string>

#include "sectorgen/bake/render/render_mesh.hpp"
#include "x3d_export/city_index.hpp"
#include "x3d_export/glb.hpp"

/// A city as triangles for pictures: the faces that x3d_export writes into near sector files, placed in the plan frame.
namespace vicus {

struct CityMeshOptions {
  int level = 4;                  ///< Urban LOD of every facade, 1 ... 4 (paper 004 §4.2)
  bool is_as_sent = true;         ///< a sector whose files leave level 4 out comes in level 3
  bool has_city_ends = true;      ///< the solid faces in gates that lead out of the city
  bool marks_facades = false;     ///< all in black, facades with levels white, without light: to tell them apart
  std::set<std::string> sectors;  ///< empty: all
};

/// Frame   origin in the middle of the sectors' grounds.
/// Differs trees are shaded by face, browsers shade them as one ball; water and trams stand still; no tram is there.
/// Needs   level is 1 ... 4 (assert).
/// Fails   CityError: an image is missing or no PNG.
RenderMesh city_mesh(const CityIndex& index, const ImageSource& image, const CityMeshOptions& options);

/// An image source that takes what city.textures holds.   Needs   `city` outlives it.
ImageSource textures_of(const City& city);

}  // namespace vicus
