#pragma once
#include <set>
#include <utility>

#include "sectorgen/visibility/sight_map.hpp"

/// Brute force beside sectorgen/visibility: no chains, no pivots, nothing shared but the map.
namespace vicus::test {

/// Every pair (a, b) of sectors such that some line through two of the map's points leaves a through its rim and enters
/// b, touching allowed: the lines that any set of stabbing lines has at its corners.
/// Cost   points squared x sides.
std::set<std::pair<std::uint32_t, std::uint32_t>> sectors_in_sight_by_brute_force(const SightMap& map);

}  // namespace vicus::test
