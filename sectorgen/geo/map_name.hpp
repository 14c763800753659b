#pragma once
#include <filesystem>
#include <string>

#include "sectorgen/geo/raw_map.hpp"

/// What a city is called.
namespace vicus {

/// The map's own name: of the boundary, else of its largest place (city, town, village, ... down to neighbourhood).
/// Empty where it has none, or several of that size: then no one of them names the map.
std::string name_in_map(const RawMap& map);

/// A file's name made readable: "old-town.osm.pbf" -> "Old Town". Where that is the name of a layer, its folder's:
/// "berlin-mitte/buildings.geojsonl.gz" -> "Berlin Mitte".
std::string name_from_file(const std::filesystem::path& file);

}  // namespace vicus
