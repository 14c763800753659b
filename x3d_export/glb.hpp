#pragma once
#include <functional>
#include <string>
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/sector_mesh.hpp"

/// Sectors as binary glTF 2.0 (GLB), images inside; geometry coded by Draco (KHR_draco_mesh_compression) or by
/// meshoptimizer (EXT_meshopt_compression, KHR_mesh_quantization).
///
/// Frame   the sector's own, metres: glTF's axes are X3D's.
/// Error   half of GlbOptions::step_mm. At Draco's 1 none on the lattice: its steps are made the lattice's millimetres,
/// so
///         that a decoder's floats are those of the X3D files (half a millimetre at most, as there). meshopt counts to
///         65535, so that its steps are 2 or 3 mm in sectors longer than 65 m.
/// Source  glTF 2.0, KHR_draco_mesh_compression; research/HOUSES.md §6.
namespace vicus {

/// PNG by texture id.   Fails  CityError: there is none.
using ImageSource = std::function<std::string(const std::string& id)>;

/// near: ground, houses with facades of level 3 (images), barriers, objects at rest and signs. far: as the far X3D
/// file. Its one node is named after the sector; extras: "sector", "name", "kind", "houses" (ids). Copyright: the
/// licences. Needs   detail is near or far.   Fails  CityError: an image is missing.
enum class GlbCoding { draco, meshopt };
struct GlbOptions {
  GlbCoding coding = GlbCoding::draco;
  std::uint32_t step_mm = 1;  ///< of positions
};
std::string sector_glb(const CityIndex& index, const Sector& sector, Detail detail, const ImageSource& image,
                       const GlbOptions& options = {});

/// Bounds of what sector_glb holds, metres in the sector's frame: min x, y, z, max x, y, z.
std::array<double, 6> glb_bounds(const CityIndex& index, const Sector& sector, Detail detail);

}  // namespace vicus
