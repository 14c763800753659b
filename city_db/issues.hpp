#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "city_db/units.hpp"

/// Numbered faults of the input (HOUSE_STYLE §5.2). Codes are permanent; city_db/FORMAT.md lists them, and each has a
/// fixture named after it.
namespace vicus {

enum class IssueCode {
  // 1xx the input as a whole
  unreadable_feature = 101,
  outside_limits = 102,  ///< farther than the lattice reaches from the origin
  unknown_attribute_value = 103,
  unknown_place = 104,  ///< an important sector's id, name or place that the city does not have
  terrain_hole = 105,   ///< no height here: taken from the nodes around
  unused_model = 106,   ///< an author's model of a kind of object that the city does not have
  // 2xx footprints
  ring_open = 201,
  ring_self_intersection = 202,
  ring_too_few_points = 203,
  duplicate = 204,
  sliver = 205,
  overlap = 206,             ///< two houses share ground
  gap = 207,                 ///< a gap of centimetres between two houses
  building_in_street = 208,  ///< a street's centre line runs into a house that has no passage
  no_height = 209,
  absurd_height = 210,
  hole_outside = 211,
  incomplete_relation = 212,
  part_outside = 213,    ///< a building:part outside of any building
  roof_flattened = 214,  ///< the roof that was asked for cannot be built on this footprint: flat instead
  model_unused = 215,    ///< the house's own roof cannot be used: one of ours instead
  // 3xx streets
  unmapped_street = 301,  ///< an opening between sectors that looks like a street without an axis
  street_too_short = 302,
  unmapped_passage = 303,  ///< a street leads below a long house whose map shows no passage
  // 4xx sectors
  over_budget = 401,        ///< a sector exceeds the byte budget and has no chord left to cut at
  yard_closed = 402,        ///< ground reached only by a gap too narrow to walk
  not_reached = 403,        ///< open ground that no street, path or square reaches
  sight_over_budget = 404,  ///< too many lines to follow: others tell the list, a superset among such sectors
  // 5xx interiors
  room_outside = 501,         ///< an indoor room that lies in no house
  room_too_small = 502,       ///< what the walls leave of it is no room
  room_without_door = 503,    ///< no door leads from the street to it: left out
  door_off_wall = 504,        ///< a door that stands on no wall between a room and another, or the street
  room_on_other_level = 505,  ///< rooms above or below the ground floor are left out
};

/// A short permanent name: `ring_self_intersection`.
const char* name_of(IssueCode);

struct Issue {
  IssueCode code = IssueCode::unreadable_feature;
  std::string message;    ///< a sentence: what is wrong and what was done about it
  std::string source_id;  ///< of the feature, as in the source: way/123, or layer#feature
  PlanPoint at;
};

/// The world failed (disk, corrupt file, unusable input): what, where, expected and found. Caught only in mains and
/// httpd/routes. `exit_code`: DESIGN §9 (1 failed, 4 nothing usable in the input).
class CityError : public std::runtime_error {
 public:
  explicit CityError(const std::string& what, int exit_code = 1) : std::runtime_error(what), exit_code(exit_code) {}
  int exit_code;
};

/// The city file was made by a vicus of another format version. A new build may replace it, but learns nothing from it.
class OtherVersionError : public CityError {
 public:
  using CityError::CityError;
};

}  // namespace vicus
