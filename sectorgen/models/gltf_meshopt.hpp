#pragma once
#include <filesystem>
#include <string>

namespace vicus {

/// A glTF or GLB whose buffer views are coded by EXT_meshopt_compression as a GLB with the same views in plain; "" for
/// a file that does not use it, or is no glTF that could. Images beside the file stay there.
/// Fails   CityError: streams that do not decode, or lie beyond their bytes; a buffer that cannot be read; more than
///         256 MB of plain bytes.
/// Source  EXT_meshopt_compression (Khronos), modes ATTRIBUTES, TRIANGLES, INDICES, filters OCTAHEDRAL, QUATERNION,
///         EXPONENTIAL.
std::string without_meshopt(const std::filesystem::path& path);

}  // namespace vicus
