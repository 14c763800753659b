#pragma once
#include <filesystem>
#include <vector>

#include "sectorgen/geo/layer_choice.hpp"
#include "sectorgen/geo/raw_map.hpp"

/// GeoPackage, GeoJSON, Shapefile, FlatGeobuf and whatever else GDAL reads as vectors, also inside .gz and .zip.
namespace vicus {

/// The file's layers that have geometry.
/// Fails   CityError: no vector file, or one without such layers.
std::vector<LayerFacts> gdal_facts(const std::filesystem::path& path);

/// One layer, transformed from its own coordinate system to WGS84 degrees.
/// Cost    transforms run in batches.
/// Fails   CityError, naming file and layer: no coordinate system where the coordinates are no degrees; most positions
///         outside of where the declared system is defined. A single such feature is issue 101.
void read_gdal(const LayerChoice& choice, RawMap& map);

/// Every polygon of the file, as themes `boundary`.
void read_gdal_boundary(const std::filesystem::path& path, RawMap& map);

}  // namespace vicus
