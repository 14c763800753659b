#pragma once
#include <set>
#include <utility>

#include "sectorgen/visibility/sight_map.hpp"

/// Brute force beside sectorgen/visibility: no chains, no pivots, nothing shared but the map.
namespace vicus::test {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

struct Sights {
  Pairs sectors;  ///< (a, b): a line leaves a through its rim and enters b
  Pairs houses;   ///< (a, h): such a line, or one within a, meets h; its owner is not in sight of a
};

/// By all lines through two of the map's points, touching allowed: the lines that any set of stabbing lines has at its
/// corners.
/// Cost   points squared x sides.
Sights sights_by_brute_force(const SightMap& map);

}  // namespace vicus::test
