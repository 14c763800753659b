#pragma once
#include "city_db/city.hpp"
#include "sectorgen/visibility/roof_targets.hpp"

/// Ground that is seen over lower houses, where a city has slopes.
namespace vicus {

/// Adds the ground of each sector as a showing of the pseudo-house `first_house` + its index, and the root of its tree
/// to `roots`. Nothing on flat ground: there one sees ground along streets only.
///
/// The ground is taken in convex pieces, each with the height H of its highest ground. Whoever sees a place G of a
/// piece over houses sees a point of the piece's edge no higher than H over the same houses: from above, the line to
/// the edge beyond G at height H runs above the line to G; from below, the line to G enters the piece below H. No house
/// stands between G and either edge. So the edges at H are what is looked for.
///
/// Frame   plan, metres.
/// Error   a superset: pieces rise by up to 1.5 m, more where shorter than 6 m.
void add_ground_targets(const City& city, std::uint32_t first_house, RoofTargets& targets,
                        std::vector<std::uint32_t>& roots);

}  // namespace vicus
