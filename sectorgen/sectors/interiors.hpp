#pragma once
#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// Rooms behind doors (paper 004 §5.2.3): sectors inside houses, joined to the street and to each other by doors.
///
/// Walls   a room as mapped is taken to reach to the middle of its walls: half of kInnerWall_m goes off all around, and
///         nothing comes nearer to the house's outline than kOuterWall_m. Doorways lead through what is left.
/// Doors   a door belongs to the room whose outline is nearest; it leads to the street where a facade is within reach,
///         else to the next room.
namespace vicus {

inline constexpr double kOuterWall_m = 0.3, kInnerWall_m = 0.15;
/// A door is mapped no farther from the wall that it stands in; a wall is no thicker than a doorway is deep.
inline constexpr double kDoorReach_m = 1.0, kDeepestDoorway_m = 1.5;

/// Fills interiors and doors, without heights of floors and sills. Only rooms on the ground floor, and of these only
/// such as one gets to from a street.
/// Needs   sectors, borders, buildings with their final ids.
/// Keeps   what check_rules asks of interiors, by construction but for roundings; what breaks it is left out.
/// Raises  501 room_outside, 502 room_too_small, 503 room_without_door, 504 door_off_wall, 505 room_on_other_level.
void add_interiors(const SourceMap& map, City& city);

/// Sills of doors to the street are as high as the ground before them, floors as the first such sill of their rooms;
/// a viewpoint in each room.
/// Needs   surfaces, or a terrain; on flat ground neither.
void level_interiors(City& city);

}  // namespace vicus
