#pragma once
#include <string_view>

/// The one table from a file name's suffix to its media type; scenes as x3d_export/writers.hpp states them.
namespace vicus {

/// "" for a suffix that is not served.
std::string_view media_type_of_file(std::string_view file_name);

/// Text-like types, which gain from a content coding.
bool is_compressible(std::string_view media_type);

}  // namespace vicus
