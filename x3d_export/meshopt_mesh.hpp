#pragma once
#include <span>
#include <string>

#include "x3d_export/draco_mesh.hpp"

/// Faces coded by meshoptimizer for EXT_meshopt_compression, behind plain types: the library's header stays in one
/// file.
namespace vicus {

/// One primitive as four streams. Positions: 16 bits each of three, 8 bytes a point, in steps from the lattice's least
/// corner. Normals: 8 bits, 4 bytes a point. Extra: colours (linear, RGBA of 8 bits) or places in an image (two
/// floats). Indices: 32 bits.
struct MeshoptMesh {
  std::string positions, normals, extras, indices;
  std::uint32_t points = 0, triangles = 0, extra_stride = 4;
  std::array<std::uint16_t, 3> least{}, most{};  ///< of the positions
};

/// The step, mm, in which such positions count: `wanted_mm`, or more where the lattice is longer than 65535 of these.
std::uint32_t meshopt_step_mm(const LatticeBox& lattice, std::uint32_t wanted_mm);

/// Error   half a step in each coordinate.
/// Needs   !faces.empty(), all corners in `lattice` (assert), a step of meshopt_step_mm.
MeshoptMesh meshopt_mesh(std::span<const Face> faces, const LatticeBox& lattice, std::uint32_t step_mm);
MeshoptMesh meshopt_mesh(std::span<const TexturedFace> faces, const LatticeBox& lattice, std::uint32_t step_mm);

}  // namespace vicus
