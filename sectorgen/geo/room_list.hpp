#pragma once
#include <filesystem>

#include "sectorgen/geo/source_map.hpp"

/// An author's table of rooms behind doors, for houses whose map has no indoor rooms.
///
/// CSV     first line names the columns, in any order: house, outline, doors, name, height. house: a building's id or
/// its
///         name in the map's file (way/123); may be empty where an outline tells it. outline: WKT POLYGON, longitude
///         and latitude, as QGIS exports it; empty: all of the house. doors: WKT POINT or MULTIPOINT, on or near the
///         room's outline; empty: one in the middle of the longest facade that the room lies behind. name: what to call
///         it. height: of the ceiling, metres. Lines that begin with # are passed over.
namespace vicus {

/// Adds the rooms to the map, in its plan frame.
/// Fails   CityError, naming file and line.
void read_room_list(const std::filesystem::path& list, SourceMap& map);

}  // namespace vicus
