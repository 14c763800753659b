#pragma once
#include <optional>

#include "sectorgen/geo/raw_map.hpp"

/// Which OSM-tagged feature is what. Pure functions of the tags; files with other attributes are first translated
/// (attribute_rules.hpp). The tables stand in osm_rules.cpp.
namespace vicus {

/// What a closed way, a multipolygon or a polygon feature is; nothing: nothing we need.
/// Underground houses (location=underground, layer < 0) are nothing.
std::optional<Theme> theme_of_polygon(const Tags& tags);
/// street (an axis: research "which lines are axes"), barrier or track (only drawn); nothing: none of them.
std::optional<Theme> theme_of_line(const Tags& tags);
/// `level` is missing or has 0 in its list.
bool is_on_ground_floor(const Tags& tags);
/// The kind of a mapped point: tree, street_lamp, fountain, bench, door (an entrance), indoor_door, shop, ...; "" for
/// an untagged one, and for doors of other floors.
std::string kind_of_point(const Tags& tags);

/// True for a tagged node that lets people through the wall or fence it lies on.
bool is_opening(const Tags& tags);
/// True for ways people use, axis or not: a wall that shares a node with one is open there.
bool is_walked_way(const Tags& tags);

/// Carriageway and pavements: `width`, else lanes x 3 m + pavements, else typical for the kind.
double axis_width_m(const Tags& tags);
/// From kerb to kerb: `width` of a road, else lanes, else typical for the kind; 0: it has no kerbs.
double carriageway_m(const Tags& tags);
/// What a cover or a track is made of. Needs  theme_of_polygon says cover, or theme_of_line track.
SurfaceKind surface_of(const Tags& tags);
double track_width_m(const Tags& tags);  ///< of rails: their gauge
bool is_passage(const Tags& tags);
/// `layer`, else 1 for a bridge, else 0; -9 .. 9.
int axis_level(const Tags& tags);

bool is_wall(const Tags& tags);
double barrier_height_m(const Tags& tags);
double barrier_thickness_m(const Tags& tags);

/// Height above ground of the underside, 0 for a house that stands on the ground. A roof or carport without
/// min_height is given the underside that leaves room to walk.
double building_base_m(const Tags& tags, Theme theme, double height_m);
/// Room to walk: a house with a lower underside blocks the ground.
inline constexpr double kWalkableUnderM = 2.5;
inline constexpr double kStoreyM = 3.0;

/// building=bridge, viaduct, bridge=*, layer >= 1: a deck or a house above ground that one walks on below.
bool is_raised(const Tags& tags);
/// building=roof, canopy, carport: stands on posts.
bool is_open_below(const Tags& tags);
/// garage, shed, hut, ...: low where no height is tagged.
bool is_outbuilding(const Tags& tags);

}  // namespace vicus
