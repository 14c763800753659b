#include "sectorgen/geo/source_map.hpp"

#include <algorithm>

#include "sectorgen/geo/heights.hpp"
#include "sectorgen/geo/layer_choice.hpp"
#include "sectorgen/geo/place_features.hpp"
#include "sectorgen/geo/read_geojson_lines.hpp"
#include "sectorgen/geo/read_osm.hpp"

namespace vicus {

namespace {

namespace fs = std::filesystem;

void require_file(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw CityError(path.string() + ": no such file", 4);
  if (fs::is_directory(path, error) && path.extension() != ".gdb")
    throw CityError(path.string() + ": is a directory; name the files in it", 4);
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == 0)
    throw CityError(path.string() + ": is empty", 4);
}

}  // namespace

SourceMap load_source_map(const LoadOptions& options, std::vector<Issue>& issues) {
  RawMap raw;
  std::vector<LayerFacts> layers;
  for (const fs::path& input : options.inputs) {
    require_file(input);
    if (is_osm_file(input)) {
      read_osm(input, raw);
    } else if (is_geojson_lines_file(input)) {
      layers.push_back(geojson_lines_facts(input));
    }
  }
  const auto parse = [](const std::optional<std::string>& text) {
    return text ? std::optional(LayerName::parse(*text)) : std::nullopt;
  };
  for (const LayerChoice& choice : choose_layers(layers, parse(options.buildings_layer), parse(options.streets_layer)))
    read_geojson_lines(choice, raw);
  SourceMap map;
  map.origin = options.origin.value_or(default_origin(raw));
  map.licences = raw.licences;
  std::vector<bool> is_cut;
  place_features(std::move(raw), PlanFrame(map.origin), map, is_cut, issues);
  set_heights(map.footprints, is_cut, issues);
  return map;
}

}  // namespace vicus
