#pragma once
#include <filesystem>

#include "sectorgen/geo/raw_map.hpp"

/// True for what libosmium reads: .osm, .pbf, .osm.gz, .osm.bz2, .o5m, .opl.
namespace vicus {

bool is_osm_file(const std::filesystem::path& path);

/// Every feature of osm_rules.hpp. Relations whose members are missing are read from what is there (issue 212).
/// Frame   WGS84 degrees, as in the file.   Cost  two passes over the file; locations of all nodes in memory.
/// Fails   CityError: not readable as OSM data.
void read_osm(const std::filesystem::path& path, RawMap& map);

}  // namespace vicus
