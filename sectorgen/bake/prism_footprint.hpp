#pragma once
#include <vector>

#include "city_db/city.hpp"

/// Footprints as prism tiles have them: simplified, and rounded to a lattice that all tiles of one size share.
namespace vicus {

/// Indices of the corners that stay, ascending from the first; no dropped one is farther than the tolerance from the
/// ring that is left (Douglas and Peucker). Those of `forced` stay; where a ring begins does not matter.
/// Needs   `forced` as long as the ring, or empty.
std::vector<std::size_t> simplified_ring(const Ring& ring, double tolerance_mm, const std::vector<bool>& forced);

/// A place in whole steps from a tile's corner. Rounded on a lattice through the plan's origin: the corner is on it.
PlanPoint steps_from(PlanPoint p, PlanPoint corner, std::int64_t step_mm);

/// Rings of at least three points with an area; no outer one: nothing at all.
std::vector<std::vector<PlanPoint>> rounded_rings(const Polygon& footprint, PlanPoint corner, std::int64_t step_mm);

double doubled_area(const std::vector<PlanPoint>& ring);  ///< positive: counter-clockwise

}  // namespace vicus
