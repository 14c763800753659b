#pragma once
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// From rings as drawn to valid polygons on the lattice.
namespace vicus {

struct RingFault {
  IssueCode code = IssueCode::ring_self_intersection;
  std::string what;  ///< for a sentence: "its ring crosses itself"
  PlanPoint at;
};

/// The polygons that the rings (outer first, not closed by a repeated point) describe: one where nothing is wrong, none
/// where nothing is left, several where a ring crosses itself.
struct Repaired {
  std::vector<Polygon> polygons;   ///< valid (OGC) on the lattice, outer counter-clockwise, sorted by their first point
  std::optional<RingFault> fault;  ///< what was wrong; nothing where the rings were used as they came
};

/// Method  exact check first; only failures go to GEOS (makeValid, by structure), are rounded to the lattice and
/// checked
///         again until they stay valid.
/// Fails   never; at worst nothing is left.
Repaired repaired_polygons(std::vector<Ring> rings);

/// Valid polygons of the union, on the lattice, sorted by their first point. Nothing where GEOS fails.
std::vector<Polygon> united_polygons(const std::vector<Polygon>& polygons);

/// OGC validity of a lattice polygon: exact check first, else GEOS.
bool is_valid(const Polygon& polygon);

}  // namespace vicus
