#include "sectorgen/geo/source_map.hpp"

#include <algorithm>

#include "sectorgen/geo/heights.hpp"
#include "sectorgen/geo/layer_choice.hpp"
#include "sectorgen/geo/map_name.hpp"
#include "sectorgen/geo/neighbours.hpp"
#include "sectorgen/geo/place_features.hpp"
#include "sectorgen/geo/read_citygml.hpp"
#include "sectorgen/geo/read_cityjson.hpp"
#include "sectorgen/geo/read_gdal.hpp"
#include "sectorgen/geo/read_geojson_lines.hpp"
#include "sectorgen/geo/read_osm.hpp"
#include "sectorgen/geo/stitch_pieces.hpp"

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

std::vector<std::string> without_repeats(const std::vector<std::string>& lines) {
  std::vector<std::string> kept;
  for (const std::string& line : lines)
    if (std::find(kept.begin(), kept.end(), line) == kept.end()) kept.push_back(line);
  return kept;
}

std::optional<LayerName> parsed(const std::optional<std::string>& text) {
  return text ? std::optional(LayerName::parse(*text)) : std::nullopt;
}

/// `--buildings` and `--streets` may name files that are no input otherwise.
std::vector<fs::path> all_inputs(const LoadOptions& options) {
  std::vector<fs::path> inputs = options.inputs;
  for (const auto& named : {parsed(options.buildings_layer), parsed(options.streets_layer)}) {
    if (!named) continue;
    const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const fs::path& input) {
      return named->names({input, named->layer, true, true, {}});
    });
    if (!is_input) inputs.push_back(named->file);
  }
  return inputs;
}

/// Takes out the houses or streets that another layer was named for.
void drop_unwanted(const LoadOptions& options, const fs::path& input, std::size_t first, RawMap& raw) {
  const auto is_elsewhere = [&](const std::optional<std::string>& text) {
    const auto named = parsed(text);
    return named && !named->names({input, "", true, true, {}});
  };
  const bool without_houses = is_elsewhere(options.buildings_layer),
             without_streets = is_elsewhere(options.streets_layer);
  const auto is_unwanted = [&](const RawFeature& feature) {
    const bool is_house = feature.theme == Theme::building || feature.theme == Theme::part;
    return (without_houses && is_house) || (without_streets && feature.theme == Theme::street);
  };
  raw.features.erase(
      std::remove_if(raw.features.begin() + static_cast<std::ptrdiff_t>(first), raw.features.end(), is_unwanted),
      raw.features.end());
}

RawMap read_inputs(const LoadOptions& options) {
  RawMap raw;
  std::vector<LayerFacts> layers;
  for (const fs::path& input : all_inputs(options)) {
    require_file(input);
    if (is_osm_file(input)) {
      const std::size_t first = raw.features.size();
      read_osm(input, raw);
      drop_unwanted(options, input, first, raw);
    } else if (is_cityjson_file(input) || is_citygml_file(input)) {
      const std::size_t first = raw.features.size();
      is_cityjson_file(input) ? read_cityjson(input, options.assumed_system, raw)
                              : read_citygml(input, options.assumed_system, raw);
      drop_unwanted(options, input, first, raw);
    } else if (is_geojson_lines_file(input)) {
      layers.push_back(geojson_lines_facts(input));
    } else {
      for (LayerFacts& facts : gdal_facts(input)) layers.push_back(std::move(facts));
    }
  }
  const auto buildings = parsed(options.buildings_layer), streets = parsed(options.streets_layer);
  for (const auto& named : {buildings, streets})
    if (named && !named->layer.empty() &&
        std::none_of(layers.begin(), layers.end(), [&](const LayerFacts& facts) { return named->names(facts); }))
      throw CityError(named->file.string() + ": no layer " + named->layer, 2);
  for (const LayerChoice& choice : choose_layers(layers, buildings, streets)) {
    if (choice.use == LayerUse::ignored) continue;
    is_geojson_lines_file(choice.layer.file) ? read_geojson_lines(choice, raw) : read_gdal(choice, raw);
  }
  return raw;
}

}  // namespace

SourceMap load_source_map(const LoadOptions& options, std::vector<Issue>& issues) {
  RawMap raw = read_inputs(options);
  if (options.boundary) {
    require_file(*options.boundary);
    read_gdal_boundary(*options.boundary, raw);
  }
  SourceMap map;
  map.origin = options.origin ? *options.origin : default_origin(raw);
  map.licences = without_repeats(raw.licences);
  map.name = name_in_map(raw);
  std::vector<bool> is_cut;
  place_features(std::move(raw), PlanFrame(map.origin), map, is_cut, issues);
  drop_duplicates(map.footprints, is_cut, issues);
  stitch_pieces(map.footprints, is_cut);
  set_heights(map.footprints, is_cut, issues);
  adopt_lost_parts(map.footprints, issues);
  close_gaps(map.footprints, issues);
  find_overlaps(map.footprints, issues);
  find_blocked_streets(map.footprints, map.axes, issues);
  return map;
}

}  // namespace vicus
