#include "sectorgen/geo/attribute_rules.hpp"

#include <array>
#include <set>
#include <string_view>

#include "sectorgen/geo/osm_rules.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

using Words = std::set<std::string, std::less<>>;

struct NamedUse {
  std::string_view part;  // how a word of the layer's name begins, lower case
  LayerUse use;
};
// The first match decides, so what is narrower stands first.
constexpr std::array kLayerWords = {
    NamedUse{"tessell", LayerUse::ignored},   NamedUse{"voronoi", LayerUse::ignored},
    NamedUse{"enclosure", LayerUse::ignored}, NamedUse{"contour", LayerUse::ignored},
    NamedUse{"rail", LayerUse::ignored},      NamedUse{"tram", LayerUse::ignored},
    NamedUse{"parking", LayerUse::ignored},   NamedUse{"metro", LayerUse::ignored},
    NamedUse{"bound", LayerUse::ignored},     NamedUse{"admin", LayerUse::ignored},
    NamedUse{"hull", LayerUse::ignored},      NamedUse{"building", LayerUse::buildings},
    NamedUse{"bati", LayerUse::buildings},    NamedUse{"gebaeud", LayerUse::buildings},
    NamedUse{"gebäud", LayerUse::buildings},  NamedUse{"bauwerk", LayerUse::buildings},
    NamedUse{"house", LayerUse::buildings},   NamedUse{"footprint", LayerUse::buildings},
    NamedUse{"budov", LayerUse::buildings},   NamedUse{"edific", LayerUse::buildings},
    NamedUse{"bldg", LayerUse::buildings},    NamedUse{"pand", LayerUse::buildings},
    NamedUse{"haeuser", LayerUse::buildings}, NamedUse{"haus", LayerUse::buildings},
    NamedUse{"umring", LayerUse::buildings},  NamedUse{"häuser", LayerUse::buildings},
    NamedUse{"water", LayerUse::water},       NamedUse{"wasser", LayerUse::water},
    NamedUse{"gewaess", LayerUse::water},     NamedUse{"river", LayerUse::water},
    NamedUse{"lake", LayerUse::water},        NamedUse{"hydro", LayerUse::water},
    NamedUse{"eau", LayerUse::water},         NamedUse{"plot", LayerUse::plots},
    NamedUse{"parcel", LayerUse::plots},      NamedUse{"cadast", LayerUse::plots},
    NamedUse{"flurst", LayerUse::plots},      NamedUse{"grundst", LayerUse::plots},
    NamedUse{"landuse", LayerUse::plots},     NamedUse{"square", LayerUse::squares},
    NamedUse{"plaza", LayerUse::squares},     NamedUse{"platz", LayerUse::squares},
    NamedUse{"park", LayerUse::parks},        NamedUse{"garden", LayerUse::parks},
    NamedUse{"wall", LayerUse::barriers},     NamedUse{"fence", LayerUse::barriers},
    NamedUse{"barrier", LayerUse::barriers},  NamedUse{"mauer", LayerUse::barriers},
    NamedUse{"tree", LayerUse::objects},      NamedUse{"baum", LayerUse::objects},
    NamedUse{"lamp", LayerUse::objects},      NamedUse{"street", LayerUse::streets},
    NamedUse{"road", LayerUse::streets},      NamedUse{"highway", LayerUse::streets},
    NamedUse{"strass", LayerUse::streets},    NamedUse{"straß", LayerUse::streets},
    NamedUse{"voie", LayerUse::streets},      NamedUse{"route", LayerUse::streets},
    NamedUse{"transport", LayerUse::streets}, NamedUse{"path", LayerUse::streets},
    NamedUse{"ulic", LayerUse::streets},
};

struct AttributeName {
  std::string_view attribute, key;  // attribute in lower case; the first with a value wins
};
constexpr std::array kAttributeNames = {
    AttributeName{"hauteur", "height"},
    AttributeName{"hoehe", "height"},
    AttributeName{"höhe", "height"},
    AttributeName{"measuredheight", "height"},
    AttributeName{"measured_height", "height"},
    AttributeName{"height_m", "height"},
    AttributeName{"bldg_height", "height"},
    AttributeName{"building_height", "height"},
    AttributeName{"height", "height"},
    AttributeName{"altura", "height"},
    AttributeName{"altezza", "height"},
    AttributeName{"vyska", "height"},
    AttributeName{"render_min_height", "min_height"},
    AttributeName{"min_height", "min_height"},
    AttributeName{"nb_etages", "building:levels"},
    AttributeName{"levels", "building:levels"},
    AttributeName{"building_levels", "building:levels"},
    AttributeName{"building:levels", "building:levels"},
    AttributeName{"storeys", "building:levels"},
    AttributeName{"stories", "building:levels"},
    AttributeName{"floors", "building:levels"},
    AttributeName{"num_floors", "building:levels"},
    AttributeName{"geschosse", "building:levels"},
    AttributeName{"storeysaboveground", "building:levels"},
    AttributeName{"roof_height", "roof:height"},
    AttributeName{"roof_shape", "roof:shape"},
    AttributeName{"nom", "name"},
    AttributeName{"name", "name"},
    AttributeName{"street_name", "name"},
    AttributeName{"strassenname", "name"},
    AttributeName{"width", "width"},
    AttributeName{"breite", "width"},
    AttributeName{"largeur", "width"},
    AttributeName{"lanes", "lanes"},
    AttributeName{"fclass", "highway"},
    AttributeName{"highway", "highway"},
};

// tilemaker writes one storey of 3.66 m where the source has no height.
constexpr double kTileUntaggedHeightM = 3.66;

const Words kTileRails = {"rail",
                          "subway",
                          "tram",
                          "light_rail",
                          "funicular",
                          "monorail",
                          "narrow_gauge",
                          "miniature",
                          "transit",
                          "disused",
                          "razed",
                          "abandoned",
                          "dismantled",
                          "station",
                          "platform",
                          "platform_edge",
                          "ferry",
                          "pier",
                          "turntable",
                          "traverser",
                          "roundhouse",
                          "subway_entrance",
                          "tram_stop",
                          "signal_box",
                          "depot",
                          "corridor",
                          "elevator",
                          "proposed",
                          "construction",
                          "bus_stop",
                          "waste_disposal",
                          "services",
                          "emergency_access_point",
                          "aerialway",
                          "shipway",
                          "raceway"};

void set_if_absent(Tags& tags, const char* key, const std::string& value) {
  if (!value.empty()) tags.emplace(key, value);
}

void translate_tile_building(Tags& tags) {
  const auto height = parse_number(tag(tags, "render_height"));
  if (height && *height != kTileUntaggedHeightM && *height != 0)
    set_if_absent(tags, "height", tag(tags, "render_height"));
  tags.erase("render_height");
  tags.erase("render_min_height");
}

bool is_tunnel_name(const std::string& name) {
  for (const char* part : {"tunnel", "souterrain", "unterführung", "parking "})
    if (contains_word_part(name, part)) return true;
  return false;
}

/// "Berliner Stadtbahn", "Südbahn", "Köflacherbahn", "Ligne 13", "Métro 2": no street, whatever class leaked to it.
bool is_rail_name(const std::string& name) {
  const std::string lower = lower_case(name);
  for (const char* start : {"ligne ", "métro ", "metro ", "rer ", "tramway ", "chemin de fer ", "line "})
    if (lower.rfind(start, 0) == 0) return true;
  static const Words at = {"an", "am", "auf", "bei", "hinter", "unter", "vor", "zum", "zur"};  // "An der Ostbahn"
  if (at.count(lower.substr(0, lower.find(' ')))) return false;
  const std::string word = lower.substr(lower.find_last_of(" -") + 1);  // npos + 1 == 0
  static const Words roads = {"bahn", "autobahn", "stadtautobahn", "reeperbahn", "rennbahn", "eisbahn", "kegelbahn"};
  return word.size() > 4 && word.compare(word.size() - 4, 4, "bahn") == 0 && !roads.count(word);
}

/// `class`, `subclass`, `brunnel`, `service` of vector tiles leak from one feature to the next: a name outweighs them.
/// Source  research SECTORS §2, §6.
void translate_tile_street(Tags& tags) {
  const std::string kind = tag(tags, "class"), name = tag(tags, "name");
  const bool is_tunnel = tag(tags, "brunnel") == "tunnel";
  const bool is_steps = kind == "path" && tag(tags, "subclass") == "steps";
  const bool is_bridge = tag(tags, "brunnel") == "bridge";
  for (const char* key : {"class", "subclass", "brunnel", "service", "tunnel", "layer"}) tags.erase(key);
  if (is_bridge) tags["bridge"] = "yes";
  tags["highway"] = "no";
  if (kTileRails.count(kind) || is_rail_name(name) || (is_tunnel && (name.empty() || is_tunnel_name(name)))) return;
  static const Words roads = {"motorway", "trunk", "primary", "secondary", "tertiary", "pedestrian", "busway"};
  if (roads.count(kind)) {
    tags["highway"] = kind;
  } else if (kind == "minor") {
    tags["highway"] = "residential";
  } else if (kind == "path" && !name.empty()) {
    tags["highway"] = is_steps ? "steps" : "path";
  } else if (!name.empty()) {
    tags["highway"] = "unknown";
  }
}

}  // namespace

LayerUse layer_use(const std::string& name) {
  // Words are runs of letters; beyond ASCII every byte counts as one.
  const std::string lower = lower_case(name);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; };
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < lower.size();) {
    std::size_t end = begin;
    while (end < lower.size() && is_letter(lower[end])) ++end;
    if (end > begin) words.push_back(std::string_view(lower).substr(begin, end - begin));
    begin = end + 1;
  }
  for (const NamedUse& row : kLayerWords)
    for (std::string_view word : words)
      if (word.substr(0, row.part.size()) == row.part) return row.use;
  return LayerUse::unknown;
}

bool is_building_attribute(const std::string& lower_case_name) {
  static const Words names = {"building",        "building:part", "render_height",  "hauteur",
                              "nb_etages",       "building_type", "measuredheight", "storeys",
                              "building:levels", "height",        "hoehe",          "roof:shape"};
  return names.count(lower_case_name) > 0;
}

Tags tags_from_attributes(Tags attributes) {
  Tags tags = std::move(attributes);
  for (auto entry = tags.begin(); entry != tags.end();)
    entry = entry->second.empty() ? tags.erase(entry) : std::next(entry);
  Tags found;
  for (const auto& [attribute, value] : tags) {
    const std::string lower = lower_case(attribute);
    for (const AttributeName& row : kAttributeNames)
      if (row.attribute == lower) found.emplace(row.key, value);
  }
  const bool has_class = has_tag(tags, "class") && !has_tag(tags, "highway");
  const bool is_tile_street =
      has_class && (has_tag(tags, "edge") || has_tag(tags, "tile") || has_tag(tags, "brunnel") ||
                    has_tag(tags, "subclass") || tag(tags, "class") == "minor");
  for (auto& [key, value] : found) tags.emplace(key, value);
  if (has_tag(tags, "render_height") || has_tag(tags, "render_min_height")) translate_tile_building(tags);
  if (is_tile_street) {
    translate_tile_street(tags);
  } else if (has_class) {
    tags.emplace("highway", tag(tags, "class"));
  }
  return tags;
}

std::optional<Theme> theme_of_layer_polygon(const Tags& tags, LayerUse use) {
  switch (use) {
    case LayerUse::ignored:
      return std::nullopt;
    case LayerUse::buildings:
      if (tag(tags, "building") == "no" || tag(tags, "location") == "underground") return std::nullopt;
      return has_tag(tags, "building:part") && !has_tag(tags, "building") ? Theme::part : Theme::building;
    case LayerUse::water:
      return is_yes(tags, "covered") ? std::nullopt : std::optional(Theme::water);
    case LayerUse::plots:
      return Theme::plot;
    case LayerUse::parks:
      return Theme::park;
    case LayerUse::squares:
      return Theme::square;
    case LayerUse::streets:
    case LayerUse::barriers:
    case LayerUse::objects:
    case LayerUse::unknown:
      break;
  }
  if (const auto theme = theme_of_polygon(tags)) return theme;
  static const Words waters = {"lake", "river", "pond", "ocean", "dock", "swimming_pool", "basin", "canal"};
  if (waters.count(tag(tags, "cls")) || waters.count(tag(tags, "class"))) return Theme::water;
  return std::nullopt;
}

std::optional<Theme> theme_of_layer_line(const Tags& tags, LayerUse use) {
  switch (use) {
    case LayerUse::streets:
      // Without any statement of what it is, a line of a street layer is a street.
      if (has_tag(tags, "highway")) return theme_of_line(tags);
      return has_tag(tags, "railway") ? std::nullopt : std::optional(Theme::street);
    case LayerUse::barriers:
      return Theme::barrier;
    case LayerUse::unknown:
      break;
    default:
      return std::nullopt;
  }
  return theme_of_line(tags);
}

std::string feature_source_id(const Tags& attributes, const std::string& layer, long long fid) {
  const std::string& osm_id = tag(attributes, "@id");
  return osm_id.empty() ? layer + "#" + std::to_string(fid) : osm_id;
}

}  // namespace vicus
