#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sectorgen/geo/attribute_rules.hpp"

/// Which layer of which file is read as what.
namespace vicus {

struct LayerFacts {
  std::filesystem::path file;
  std::string name;
  bool may_have_polygons = true, may_have_lines = true;
  std::vector<std::string> attributes;  ///< names, as in the file
};

/// `takes_*`: false where `--buildings` or `--streets` names another layer for them.
struct LayerChoice {
  LayerFacts layer;
  LayerUse use = LayerUse::unknown;
  bool takes_buildings = true, takes_streets = true;
};

/// "FILE" or "FILE:LAYER", for `--buildings` and `--streets`.
struct LayerName {
  std::filesystem::path file;
  std::string layer;  ///< empty: every layer of the file
  /// Needs   nothing; the text after the last ':' is a layer if the text before it names a file that exists.
  static LayerName parse(const std::string& text);
  bool names(const LayerFacts& facts) const;
};

/// By name, then by attributes; if no layer looks like buildings, the polygon layers that look like nothing are taken
/// for them.
std::vector<LayerChoice> choose_layers(const std::vector<LayerFacts>& layers, const std::optional<LayerName>& buildings,
                                       const std::optional<LayerName>& streets);

/// The theme of a polygon or line under this choice; nothing: leave it out.
std::optional<Theme> polygon_theme(const LayerChoice& choice, const Tags& tags);
std::optional<Theme> line_theme(const LayerChoice& choice, const Tags& tags);

}  // namespace vicus
