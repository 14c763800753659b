#pragma once
#include <filesystem>
#include <vector>

#include "city_db/city.hpp"

/// An author's own models in place of ours: trees, lamps, fountains, ... (paper 004 §4.1.5).
///
/// List    CSV, one a line: KIND,FILE[,HEIGHT_M]. KIND is a kind of object as in the city file (tree, street_lamp,
///         fountain, bench, ...), FILE a glTF or GLB beside the list, HEIGHT_M how tall it shall be (else as modelled,
///         in metres). Empty lines and lines that begin with # are passed over.
/// Source  glTF 2.0 (ISO/IEC 12113), KHR_draco_mesh_compression, EXT_meshopt_compression,
///         KHR_mesh_quantization, KHR_texture_transform.
namespace vicus {

inline constexpr std::size_t kMostModelTriangles = 5'000;  ///< it is sent with every sector that has one

/// The default scene of a glTF or GLB as one prototype: triangles in one colour each, the base colour times the vertex
/// colours times the texture in the middle of the triangle. `height_m` 0: as modelled.
/// Fails   CityError, naming the file: no glTF, nothing that is triangles, more than kMostModelTriangles, no height.
Prototype read_model(const std::filesystem::path& path, const std::string& kind, double height_m);

/// All of a list.   Fails  CityError, naming file and line; a kind that is named twice.
std::vector<Prototype> read_model_list(const std::filesystem::path& list);

/// Puts them into the city. A kind that the city has no object of is issue 106.
void add_author_models(std::vector<Prototype> models, City& city);

}  // namespace vicus
