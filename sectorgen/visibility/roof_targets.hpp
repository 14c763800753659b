#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/house_walls.hpp"
#include "sectorgen/visibility/sight_map.hpp"

/// Trees of short segments: the tops of walls that may be seen, and the rims that eyes stand on.
namespace vicus {

/// What one sector sends of one house.
struct Showing {
  std::uint32_t sector = 0, house = 0;
  bool is_owner = false;  ///< it sends the roof, and walls that are no facades
};

/// A disc around everything below. A leaf is one segment.
struct SegmentNode {
  Spot centre;
  double radius = 0, top_m = 0;
  double depth_m = 0;                               ///< of the houses whose walls these are, or more
  std::uint32_t left = kNowhere, right = kNowhere;  ///< children; kNowhere: a leaf
  std::uint32_t segment = kNowhere;                 ///< of a leaf
  std::uint32_t house = kNowhere;                   ///< all segments below are of this house
};

struct Segment {
  Spot a, b;
};

struct SegmentTree {
  std::vector<Segment> segments;
  std::vector<SegmentNode> nodes;
  std::uint32_t root = kNowhere;
};

/// The disc around some segments.
SegmentNode disc_around(const Segment* first, const Segment* last);
/// A tree over segments [first, last) in their order; returns its root.
std::uint32_t add_chain(SegmentTree& tree, std::uint32_t first, std::uint32_t last, double top_m, double depth_m,
                        std::uint32_t house);
/// A tree over trees, split where they lie apart.
std::uint32_t join_trees(SegmentTree& tree, std::vector<std::uint32_t>& roots);

struct RoofTargets {
  SegmentTree tree;                          ///< tops of walls, house on the left
  std::vector<Showing> showings;             ///< by house, then sector
  std::vector<std::uint32_t> first_of;       ///< per house its first showing, and one more
  std::vector<std::uint32_t> owner, facade;  ///< per segment: its showings; facade may be kNowhere
};

/// Walls that stand higher than what is behind them; on slopes, where one looks down on roofs, all walls.
/// Needs  `walls` of the same city.
RoofTargets make_roof_targets(const City& city, const HouseWalls& walls);

/// The rim of a sector's ground, islands' sides among it, ground on the left.
SegmentTree rim_of(const Sector& sector);

}  // namespace vicus
