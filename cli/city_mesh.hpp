#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sectorgen/bake/render/render_mesh.hpp"
#include "x3d_export/city_index.hpp"
#include "x3d_export/glb.hpp"
#include "x3d_export/sector_mesh.hpp"

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
/// Differs the ground has no grain; trees are shaded by face, browsers shade them as one ball; water and trams stand
/// still; no tram is there. Needs   level is 1 ... 4 (assert). Fails   CityError: an image is missing or no PNG.
RenderMesh city_mesh(const CityIndex& index, const ImageSource& image, const CityMeshOptions& options);

/// Images ready for rays, by texture id: made once where several meshes share them.
using ReadyImages = std::function<std::shared_ptr<const RepeatedImage>(const std::string& id)>;
ReadyImages cached(ImageSource image);
RenderMesh city_mesh(const CityIndex& index, const ReadyImages& images, const CityMeshOptions& options);

/// One file of a sector.
struct SectorPart {
  const Sector* sector = nullptr;
  Detail detail = Detail::near;
  int level = 4;                 ///< near: of every facade that `levels` does not tell
  std::vector<int> levels = {};  ///< near: by sector_pieces, 1 ... 4
};
/// Some files of a city, as sent: a sector whose file leaves level 4 out comes in level 3.
/// `first_triangles`: where it is not null, becomes the first triangle of each part, and the number of all.
/// Frame   origin in the middle of all the city's ground, whatever the parts.   Fails   as above.
RenderMesh parts_mesh(const CityIndex& index, const ReadyImages& images, const std::vector<SectorPart>& parts,
                      bool has_city_ends = true, std::vector<std::uint32_t>* first_triangles = nullptr);

/// An image source that takes what city.textures holds.   Needs   `city` outlives it.
ImageSource textures_of(const City& city);

}  // namespace vicus
