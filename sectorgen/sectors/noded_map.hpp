#pragma once
#include <vector>

#include "sectorgen/sectors/obstacles.hpp"

/// Every feature that shapes the ground, noded once with all others. From here on topology never changes (DESIGN §2).
namespace vicus {

enum class MapLayer { house, wall, water, domain, overhead, kerb };

struct NodedPart {
  MapLayer layer = MapLayer::house;
  std::uint32_t feature = 0;  ///< index into the list of its layer: Blocks::houses, walls, water, the domain's polygons
  std::vector<PlanPoint> points;  ///< a ring, inside on the left (may touch itself after rounding), or a kerb's line
};

/// Parts in the order of Blocks, the rings of one feature together.
/// Error   as node_segments.
std::vector<NodedPart> node_map(const Blocks& blocks, const std::vector<Polygon>& domain,
                                const std::vector<std::vector<PlanPoint>>& kerbs);

}  // namespace vicus
