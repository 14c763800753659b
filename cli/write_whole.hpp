#pragma once
#include <filesystem>
#include <string>

namespace vicus::cli {

/// The file appears whole or not at all: written beside its place, then renamed.
/// Fails   CityError: the disk is full, or the folder is not ours to write.
void write_whole(const std::filesystem::path& path, const std::string& bytes);

}  // namespace vicus::cli
