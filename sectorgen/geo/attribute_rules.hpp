#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "sectorgen/geo/raw_map.hpp"

/// What layers and attributes of files that are not OSM mean: recognised by name and translated to OSM-like tags once,
/// so that osm_rules.hpp holds for them too. The word lists stand in attribute_rules.cpp.
namespace vicus {

/// What a layer is for, as far as its name tells.
enum class LayerUse { unknown, buildings, streets, water, plots, parks, squares, barriers, objects, ignored };

/// `name`: the layer's, and the file's stem. tessellation, voronoi, enclosures, rail, contours, ... are ignored.
LayerUse layer_use(const std::string& name);

/// The features' tags from their attributes: height, building:levels, min_height, name, ... under whichever name or
/// language they come; vector-tile attributes (render_height, class, brunnel) as the tiles mean them. The attributes
/// themselves stay too, but for empty ones.
Tags tags_from_attributes(Tags attributes);

/// What a feature is, by its tags first, else by its layer's use; nothing: to be left out.
std::optional<Theme> theme_of_layer_polygon(const Tags& tags, LayerUse use);
std::optional<Theme> theme_of_layer_line(const Tags& tags, LayerUse use);
bool is_building_attribute(const std::string& lower_case_name);

/// way/123 where an `@id` attribute says so, else LAYER#FID.
std::string feature_source_id(const Tags& attributes, const std::string& layer, long long fid);

}  // namespace vicus
