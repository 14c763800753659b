#include "sectorgen/geo/layer_choice.hpp"

#include <algorithm>

#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a.lexically_normal() == b.lexically_normal() || (fs::equivalent(a, b, error) && !error);
}

LayerUse use_by_facts(const LayerFacts& layer) {
  LayerUse use = layer_use(layer.name);
  if (use == LayerUse::unknown) use = layer_use(layer.file.filename().string());
  if (use != LayerUse::unknown) return use;
  const bool has_building_attribute =
      std::any_of(layer.attributes.begin(), layer.attributes.end(),
                  [](const std::string& name) { return is_building_attribute(lower_case(name)); });
  const bool is_osm_like = std::any_of(layer.attributes.begin(), layer.attributes.end(), [](const std::string& name) {
    return name == "building" || name == "highway" || name == "natural" || name == "landuse";
  });
  // A layer with OSM's own keys holds all kinds of features: their tags decide.
  return has_building_attribute && !is_osm_like && layer.may_have_polygons ? LayerUse::buildings : LayerUse::unknown;
}

bool has_osm_key(const LayerFacts& layer) {
  return std::any_of(layer.attributes.begin(), layer.attributes.end(), [](const std::string& name) {
    return name == "building" || name == "highway" || name == "natural" || name == "class" || name == "cls";
  });
}

}  // namespace

LayerName LayerName::parse(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::error_code error;
  if (colon != std::string::npos && colon > 0 && !fs::exists(text, error) && fs::exists(text.substr(0, colon), error))
    return {text.substr(0, colon), text.substr(colon + 1)};
  return {text, ""};
}

bool LayerName::names(const LayerFacts& facts) const {
  return is_same_file(file, facts.file) && (layer.empty() || layer == facts.name);
}

std::vector<LayerChoice> choose_layers(const std::vector<LayerFacts>& layers, const std::optional<LayerName>& buildings,
                                       const std::optional<LayerName>& streets) {
  std::vector<LayerChoice> choices;
  bool has_buildings = false;
  for (const LayerFacts& layer : layers) {
    LayerChoice choice{layer, use_by_facts(layer), !buildings, !streets};
    if (buildings && buildings->names(layer)) {
      choice.takes_buildings = true;
      if (choice.use != LayerUse::buildings && !has_osm_key(layer)) choice.use = LayerUse::buildings;
    }
    if (streets && streets->names(layer)) {
      choice.takes_streets = true;
      if (choice.use != LayerUse::streets && !has_osm_key(layer)) choice.use = LayerUse::streets;
    }
    has_buildings = has_buildings || choice.use == LayerUse::buildings || has_osm_key(layer);
    choices.push_back(std::move(choice));
  }
  if (!has_buildings)
    for (LayerChoice& choice : choices)
      if (choice.use == LayerUse::unknown && choice.layer.may_have_polygons) choice.use = LayerUse::buildings;
  return choices;
}

std::optional<Theme> polygon_theme(const LayerChoice& choice, const Tags& tags) {
  const auto theme = theme_of_layer_polygon(tags, choice.use);
  const bool is_house = theme == Theme::building || theme == Theme::part;
  return is_house && !choice.takes_buildings ? std::nullopt : theme;
}

std::optional<Theme> line_theme(const LayerChoice& choice, const Tags& tags) {
  // A file of unknown use that has lines and says nothing about them: streets, as in most such files.
  const bool says_nothing = choice.use == LayerUse::unknown && !has_osm_key(choice.layer);
  const auto theme = theme_of_layer_line(tags, says_nothing ? LayerUse::streets : choice.use);
  return theme == Theme::street && !choice.takes_streets ? std::nullopt : theme;
}

}  // namespace vicus
