#pragma once
#include <array>
#include <filesystem>
#include <vector>

/// A glTF file as triangles: the one place that knows tinygltf.
namespace vicus {

struct GltfTriangle {
  std::array<std::array<double, 3>, 3> corners;  ///< glTF's axes: x right, y up, front along +z; metres
  std::array<double, 3> colour;                  ///< linear, 0 ... 1
};

/// The triangles of the file's default scene (else its first, else all nodes), in order.
/// Fails   CityError: what tinygltf cannot read, with its words; indices beyond their data; an extension that is
/// required
///         and unknown here.
std::vector<GltfTriangle> read_gltf(const std::filesystem::path& path);

}  // namespace vicus
