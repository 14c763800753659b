#pragma once
#include <filesystem>

#include "sectorgen/geo/raw_map.hpp"

/// CityJSON 0.8 to 2.0, and CityJSONSeq (one feature a line): houses as modelled.
namespace vicus {

/// By what the file begins with, or .city.json in its name.
bool is_cityjson_file(const std::filesystem::path& path);

/// Buildings and BuildingParts of the file, each in its finest level of detail up to 3. Faulty objects become issue
/// 101. `assumed_system`: taken where the file names none. Fails   CityError: no CityJSON, no coordinate system, no
/// house. Source  CityJSON Specifications 2.0.1 (cityjson.org), chapters 2 and 3.
void read_cityjson(const std::filesystem::path& path, const std::string& assumed_system, RawMap& map);

}  // namespace vicus
