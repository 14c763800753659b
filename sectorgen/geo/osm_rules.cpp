#include "sectorgen/geo/osm_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>

#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

using Words = std::set<std::string, std::less<>>;

// Metres from facade to facade where nothing is tagged; measured by eye on European old towns, not normative.
struct KindWidth {
  std::string_view kind;
  double metres;
};
constexpr std::array kTypicalWidths = {
    KindWidth{"motorway", 24},     KindWidth{"trunk", 20},       KindWidth{"primary", 18},
    KindWidth{"secondary", 15},    KindWidth{"tertiary", 12},    KindWidth{"motorway_link", 8},
    KindWidth{"trunk_link", 8},    KindWidth{"primary_link", 7}, KindWidth{"secondary_link", 7},
    KindWidth{"tertiary_link", 7}, KindWidth{"unclassified", 9}, KindWidth{"residential", 10},
    KindWidth{"living_street", 8}, KindWidth{"road", 8},         KindWidth{"busway", 8},
    KindWidth{"pedestrian", 8},    KindWidth{"service", 5},      KindWidth{"track", 4},
    KindWidth{"cycleway", 3},      KindWidth{"footway", 3},      KindWidth{"path", 2.5},
    KindWidth{"bridleway", 3},     KindWidth{"steps", 3},
};
/// From kerb to kerb; kinds that are not here have no kerbs.
constexpr std::array kTypicalCarriageways = {
    KindWidth{"motorway", 16},     KindWidth{"trunk", 13},         KindWidth{"primary", 11},
    KindWidth{"secondary", 9},     KindWidth{"tertiary", 7},       KindWidth{"motorway_link", 6},
    KindWidth{"trunk_link", 6},    KindWidth{"primary_link", 5},   KindWidth{"secondary_link", 5},
    KindWidth{"tertiary_link", 5}, KindWidth{"unclassified", 5.5}, KindWidth{"residential", 5.5},
    KindWidth{"road", 5.5},        KindWidth{"busway", 6.5},       KindWidth{"unknown", 5.5},
    KindWidth{"service", 3},
};
constexpr double kUnknownWidthM = 8;
constexpr double kLaneM = 3;
constexpr double kPavementM = 2;
constexpr double kTramGaugeM = 1.435;
constexpr double kPathWidthM = 2;

const Words kRoads = {"motorway",      "trunk",       "primary",       "secondary",      "tertiary",
                      "motorway_link", "trunk_link",  "primary_link",  "secondary_link", "tertiary_link",
                      "unclassified",  "residential", "living_street", "road",           "busway",
                      "pedestrian",    "unknown"};
const Words kPaths = {"footway", "path", "cycleway", "bridleway", "track", "service"};
const Words kNoFootways = {"sidewalk", "crossing", "traffic_island", "link"};
const Words kNoServices = {"parking_aisle", "driveway", "drive-through"};

bool is_below_ground(const Tags& tags) {
  if (tag(tags, "location") == "underground") return true;
  const auto layer = parse_number(tag(tags, "layer"));
  return layer && *layer < 0;
}

bool is_inside_house(const Tags& tags) {
  return is_yes(tags, "indoor") || has_tag(tags, "level") || has_tag(tags, "conveying");
}

bool is_closed_to_visitors(const Tags& tags) {
  const std::string& foot = tag(tags, "foot");
  if (foot == "yes" || foot == "designated" || foot == "permissive") return false;
  const std::string& access = tag(tags, "access");
  return access == "private" || access == "no";
}

bool is_street(const Tags& tags) {
  const std::string& highway = tag(tags, "highway");
  if (highway.empty() || is_yes(tags, "area") || is_yes(tags, "indoor") || is_closed_to_visitors(tags)) return false;
  if (tag(tags, "tunnel") == "building_passage")
    return kRoads.count(highway) || kPaths.count(highway) || highway == "steps";
  if (is_below_ground(tags) || is_yes(tags, "tunnel")) return false;
  if (kNoFootways.count(tag(tags, "footway")) || kNoServices.count(tag(tags, "service"))) return false;
  if (highway == "steps") return !is_inside_house(tags);
  if (kRoads.count(highway)) return true;
  if (!kPaths.count(highway)) return false;
  return !tag(tags, "name").empty() || tag(tags, "service") == "alley" || is_passage(tags);
}

bool is_barrier(const Tags& tags) {
  static const Words kinds = {"wall", "city_wall", "retaining_wall", "fence", "hedge", "guard_rail"};
  return kinds.count(tag(tags, "barrier")) && !is_below_ground(tags) && !is_inside_house(tags) &&
         tag(tags, "location") != "roof";
}

bool is_building(const Tags& tags, const char* key) {
  static const Words absent = {"", "no", "proposed", "demolished", "razed", "false"};
  return !absent.count(tag(tags, key)) && !is_below_ground(tags);
}

bool is_water(const Tags& tags) {
  if (is_below_ground(tags) || is_yes(tags, "covered") || is_yes(tags, "tunnel")) return false;
  const std::string& waterway = tag(tags, "waterway");
  const std::string& landuse = tag(tags, "landuse");
  return tag(tags, "natural") == "water" || waterway == "riverbank" || waterway == "dock" || landuse == "basin" ||
         landuse == "reservoir" || tag(tags, "leisure") == "swimming_pool" || tag(tags, "amenity") == "fountain";
}

bool is_square(const Tags& tags) {
  if (is_below_ground(tags) || is_yes(tags, "tunnel") || is_yes(tags, "indoor")) return false;
  if (tag(tags, "place") == "square") return true;
  static const Words grounds = {"pedestrian", "footway", "living_street", "path"};
  return grounds.count(tag(tags, "highway")) && is_yes(tags, "area") && !is_closed_to_visitors(tags) &&
         !kNoFootways.count(tag(tags, "footway"));
}

std::optional<SurfaceKind> cover_of(const Tags& tags) {
  static const Words greens = {"grass",   "meadow",        "forest",    "village_green", "recreation_ground",
                               "orchard", "plant_nursery", "cemetery",  "grassland",     "scrub",
                               "wood",    "heath",         "shrubbery", "allotments",    "flowerbed"};
  static const Words earths = {"playground", "dog_park", "sand", "beach", "brownfield", "construction"};
  for (const char* key : {"landuse", "natural", "leisure"}) {
    if (greens.count(tag(tags, key))) return SurfaceKind::grass;
    if (earths.count(tag(tags, key))) return SurfaceKind::earth;
  }
  if (tag(tags, "leisure") == "pitch") return tag(tags, "surface") == "grass" ? SurfaceKind::grass : SurfaceKind::earth;
  if (tag(tags, "amenity") == "parking" && (tag(tags, "parking").empty() || tag(tags, "parking") == "surface"))
    return SurfaceKind::carriageway;
  return std::nullopt;
}

bool is_tram(const Tags& tags) {
  return tag(tags, "railway") == "tram" && !is_below_ground(tags) && !is_yes(tags, "tunnel") && !is_yes(tags, "bridge");
}

/// A path that people take and that is no axis, because it has no name.
bool is_drawn_path(const Tags& tags) {
  const std::string& highway = tag(tags, "highway");
  return (highway == "footway" || highway == "path" || highway == "cycleway" || highway == "track") &&
         !kNoFootways.count(tag(tags, "footway")) && !is_yes(tags, "area") && !is_below_ground(tags) &&
         !is_yes(tags, "tunnel") && !is_yes(tags, "bridge") && !is_inside_house(tags);
}

}  // namespace

std::optional<Theme> theme_of_polygon(const Tags& tags) {
  if (is_building(tags, "building")) return Theme::building;
  if (is_building(tags, "building:part")) return Theme::part;
  static const Words towers = {"tower", "water_tower", "chimney", "storage_tank", "silo", "gasometer"};
  if (towers.count(tag(tags, "man_made")) && !has_tag(tags, "building") && !is_below_ground(tags))
    return Theme::building;
  static const Words rooms = {"room", "corridor", "area"};
  if (rooms.count(tag(tags, "indoor"))) return Theme::room;
  if (is_water(tags)) return Theme::water;
  if (tag(tags, "man_made") == "bridge" && !is_below_ground(tags)) return Theme::deck;
  if (is_square(tags)) return Theme::square;
  const std::string& leisure = tag(tags, "leisure");
  if (leisure == "park" || leisure == "garden") return is_closed_to_visitors(tags) ? Theme::plot : Theme::park;
  if (tag(tags, "place") == "plot" || tag(tags, "boundary") == "lot") return Theme::plot;
  if (cover_of(tags) && !is_below_ground(tags) && !is_inside_house(tags)) return Theme::cover;
  return std::nullopt;
}

std::optional<Theme> theme_of_line(const Tags& tags) {
  if (is_street(tags)) return Theme::street;
  if (is_barrier(tags)) return Theme::barrier;
  if (is_tram(tags) || is_drawn_path(tags)) return Theme::track;
  return std::nullopt;
}

SurfaceKind surface_of(const Tags& tags) {
  if (is_tram(tags)) return SurfaceKind::rail;
  return cover_of(tags).value_or(SurfaceKind::path);
}

double carriageway_m(const Tags& tags) {
  constexpr double kWidest = 60, kParkedM = 2;
  const std::string kind = has_tag(tags, "highway") ? tag(tags, "highway") : "unknown";
  double typical = 0;
  for (const KindWidth& row : kTypicalCarriageways)
    if (row.kind == kind) typical = row.metres;
  if (typical == 0) return 0;
  if (const auto width = parse_metres(tag(tags, "width")); width && *width > 0 && *width < kWidest) return *width;
  if (const auto lanes = parse_number(tag(tags, "lanes")); lanes && *lanes >= 1 && *lanes <= 12)
    return *lanes * kLaneM + (typical > kUnknownWidthM ? 0 : kParkedM);
  return is_yes(tags, "oneway") && typical < kUnknownWidthM ? typical - 1 : typical;
}

double track_width_m(const Tags& tags) {
  if (is_tram(tags)) return kTramGaugeM;
  const auto width = parse_metres(tag(tags, "width"));
  return width && *width > 0 && *width < 20 ? *width : kPathWidthM;
}

bool is_on_ground_floor(const Tags& tags) {
  std::istringstream levels(tag(tags, "level"));
  bool has_levels = false;
  for (std::string level; std::getline(levels, level, ';');) {
    has_levels = true;
    if (const auto number = parse_number(level); number && *number == 0) return true;
  }
  return !has_levels;
}

std::string kind_of_point(const Tags& tags) {
  if (tags.empty()) return "";
  if (tag(tags, "natural") == "tree") return "tree";
  if (has_tag(tags, "entrance") && tag(tags, "entrance") != "no") return "door";
  if (tag(tags, "indoor") == "door" || (has_tag(tags, "door") && tag(tags, "door") != "no"))
    return is_on_ground_floor(tags) ? "indoor_door" : "";
  for (const char* key : {"artwork_type", "memorial"})
    if (tag(tags, key) == "statue") return "statue";
  if (has_tag(tags, "shop")) return "shop";
  for (const char* key :
       {"amenity", "barrier", "tourism", "historic", "highway", "emergency", "man_made", "leisure", "railway",
        "public_transport", "natural", "advertising", "office", "craft", "healthcare", "power", "place"}) {
    const std::string& value = tag(tags, key);
    if (!value.empty() && value != "no") return value;
  }
  if (has_tag(tags, "addr:housenumber")) return "address";
  return has_tag(tags, "name") ? "place" : "";
}

bool is_opening(const Tags& tags) {
  static const Words open = {"gate",           "entrance",
                             "lift_gate",      "swing_gate",
                             "kissing_gate",   "stile",
                             "turnstile",      "bollard",
                             "sally_port",     "cycle_barrier",
                             "hampshire_gate", "toll_booth",
                             "wicket_gate",    "full-height_turnstile",
                             "sliding_gate",   "block",
                             "border_control"};
  return open.count(tag(tags, "barrier")) || (has_tag(tags, "entrance") && tag(tags, "entrance") != "no");
}

bool is_walked_way(const Tags& tags) {
  static const Words unwalked = {"", "proposed", "construction", "razed", "abandoned", "corridor", "platform"};
  return !unwalked.count(tag(tags, "highway")) && !is_below_ground(tags) &&
         (!is_yes(tags, "tunnel") || tag(tags, "tunnel") == "building_passage") && !is_yes(tags, "bridge");
}

double axis_width_m(const Tags& tags) {
  constexpr double kWidest = 200;
  double pavements = 0;
  const std::string& sidewalk = tag(tags, "sidewalk");
  if (sidewalk == "both") pavements = 2 * kPavementM;
  if (sidewalk == "left" || sidewalk == "right") pavements = kPavementM;
  if (const auto width = parse_metres(tag(tags, "width")); width && *width > 0 && *width < kWidest)
    return *width + pavements;
  const std::string& kind = tag(tags, "highway");
  double typical = kUnknownWidthM;
  for (const KindWidth& row : kTypicalWidths)
    if (row.kind == kind) typical = row.metres;
  if (const auto lanes = parse_number(tag(tags, "lanes")); lanes && *lanes >= 1 && *lanes <= 20) {
    if (sidewalk.empty() && typical >= kUnknownWidthM) pavements = 2 * kPavementM;
    return *lanes * kLaneM + pavements;
  }
  return typical;
}

bool is_passage(const Tags& tags) {
  const std::string& covered = tag(tags, "covered");
  return tag(tags, "tunnel") == "building_passage" || covered == "yes" || covered == "arcade" || covered == "colonnade";
}

int axis_level(const Tags& tags) {
  if (const auto layer = parse_number(tag(tags, "layer")); layer && std::abs(*layer) < 10)
    return static_cast<int>(*layer);
  return is_yes(tags, "bridge") ? 1 : 0;
}

bool is_wall(const Tags& tags) {
  const std::string& kind = tag(tags, "barrier");
  return kind == "wall" || kind == "city_wall" || kind == "retaining_wall";
}

double barrier_height_m(const Tags& tags) {
  constexpr double kHighest = 100;
  if (const auto height = parse_metres(tag(tags, "height")); height && *height > 0 && *height < kHighest)
    return *height;
  const std::string& kind = tag(tags, "barrier");
  if (kind == "city_wall") return 6;
  if (kind == "fence" || kind == "hedge") return 1.5;
  if (kind == "guard_rail") return 0.8;
  return 2;
}

double barrier_thickness_m(const Tags& tags) {
  constexpr double kThickest = 20;
  if (const auto width = parse_metres(tag(tags, "width")); width && *width > 0 && *width < kThickest) return *width;
  const std::string& kind = tag(tags, "barrier");
  if (kind == "city_wall") return 2;
  if (kind == "hedge") return 0.8;
  if (kind == "fence" || kind == "guard_rail") return 0.1;
  return 0.3;
}

bool is_open_below(const Tags& tags) {
  for (const char* key : {"building", "building:part"}) {
    const std::string& kind = tag(tags, key);
    if (kind == "roof" || kind == "canopy" || kind == "carport") return true;
  }
  return false;
}

bool is_raised(const Tags& tags) {
  const std::string& kind = tag(tags, "building");
  if (kind == "bridge" || kind == "viaduct" || is_yes(tags, "bridge") || tag(tags, "man_made") == "bridge") return true;
  const auto layer = parse_number(tag(tags, "layer"));
  return layer && *layer >= 1;
}

bool is_outbuilding(const Tags& tags) {
  static const Words low = {"garage",
                            "garages",
                            "shed",
                            "hut",
                            "carport",
                            "kiosk",
                            "cabin",
                            "roof",
                            "canopy",
                            "greenhouse",
                            "service",
                            "toilets",
                            "bunker",
                            "outbuilding",
                            "allotment_house",
                            "transformer_tower",
                            "container",
                            "tent",
                            "boathouse",
                            "stable"};
  return low.count(tag(tags, "building")) > 0;
}

// A bridge, a viaduct or a house above the ground, where no underside is tagged: room for a lorry, and a deck.
constexpr double kUnderDeckM = 4.5, kDeckM = 1, kLeastRaisedM = 4;

double building_base_m(const Tags& tags, Theme theme, double height_m) {
  double base = 0;
  if (const auto min_height = parse_metres(tag(tags, "min_height"))) {
    base = *min_height;
  } else if (const auto min_level =
                 parse_number(tag(tags, has_tag(tags, "building:min_level") ? "building:min_level" : "min_level"))) {
    base = *min_level * kStoreyM;
  } else if (is_open_below(tags)) {
    // The roof itself is taken as half a metre thick.
    base = std::max(height_m - 0.5, height_m / 2);
  } else if (theme == Theme::building && is_raised(tags) && height_m >= kLeastRaisedM) {
    base = std::min(height_m - kDeckM, kUnderDeckM);
  }
  if (!(base > 0)) return 0;
  // A house on a plinth blocks the ground; a part keeps its underside, its building's outline blocks.
  if (theme == Theme::building && base <= kWalkableUnderM && !is_open_below(tags)) return 0;
  return base;
}

}  // namespace vicus
