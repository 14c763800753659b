#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "x3d_export/mesh.hpp"

/// Faces coded by Draco, behind plain types: the library's headers stay in one file.
namespace vicus {

/// Whole millimetres: what Draco's steps start from and how many there are.
struct LatticeBox {
  X3dPoint min, max;
  void add(const X3dPoint& p);
  bool is_empty() const { return min.x > max.x; }
};

/// One primitive: its bytes and what a glTF accessor says of it.
struct DracoMesh {
  std::string bytes;
  std::uint32_t points = 0, triangles = 0;
  std::uint32_t position_id = 0, normal_id = 0, extra_id = 0;  ///< of Draco's attributes; extra: colour or place
  LatticeBox box;
};

/// Triangles with flat normals and colours (linear, RGBA of 8 bits).
/// Error   half of `step_mm` in each coordinate; none at 1.
/// Needs   !faces.empty(), all corners in `lattice`, step_mm > 0 (assert).
DracoMesh draco_mesh(std::span<const Face> faces, const LatticeBox& lattice, std::uint32_t step_mm = 1);
/// Triangles with flat normals and places in an image (16 bits; glTF's run from the top).
DracoMesh draco_mesh(std::span<const TexturedFace> faces, const LatticeBox& lattice, std::uint32_t step_mm = 1);

}  // namespace vicus
