#pragma once
#include <filesystem>

#include "sectorgen/geo/layer_choice.hpp"
#include "sectorgen/geo/raw_map.hpp"

/// Line-wise GeoJSON: one Feature per line, with or without record separators, plain or gzip.
namespace vicus {

/// True for .geojsonl, .geojsons, .geojsonseq, .ndjson, .jsonl, .ndgeojson, each also with .gz.
bool is_geojson_lines_file(const std::filesystem::path& path);

/// The layer, from the file's name and its first feature.
/// Fails   CityError: cannot be opened, or no line of it is a GeoJSON feature.
LayerFacts geojson_lines_facts(const std::filesystem::path& path);

/// Frame   WGS84 degrees, as RFC 8142 prescribes.
/// Cost    one pass, one line in memory: about 60 MB of text per CPU second.
/// Fails   CityError: cannot be opened; no feature; most coordinates are not degrees. A bad line is issue 101.
void read_geojson_lines(const LayerChoice& choice, RawMap& map);

}  // namespace vicus
