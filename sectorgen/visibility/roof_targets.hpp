#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/house_walls.hpp"
#include "sectorgen/visibility/sight_map.hpp"

/// Trees of short segments: the tops of walls that may be seen, and the rims that eyes stand on.
namespace vicus {

/// What one sector sends of one house, or its ground.
struct Showing {
  std::uint32_t sector = 0, house = 0;  ///< RoofTargets::houses and more: the sector's ground
  bool is_owner = false;                ///< it sends the roof, and walls that are no facades
};

/// A disc around everything below. A leaf is one segment.
struct SegmentNode {
  Spot centre;
  double radius = 0, low_m = 0, top_m = 0;          ///< the lowest and the highest point
  std::uint32_t left = kNowhere, right = kNowhere;  ///< children; kNowhere: a leaf
  std::uint32_t segment = kNowhere;                 ///< of a leaf
  std::uint32_t house = kNowhere;                   ///< all segments below are of this house
};

struct SightSegment {
  Spot a, b;
  double up_a = 0, up_b = 0;  ///< the most it may reach at its ends
};

struct SegmentTree {
  std::vector<SightSegment> segments;
  std::vector<SegmentNode> nodes;
  std::uint32_t root = kNowhere;
};

/// The disc around some segments.
SegmentNode disc_around(const SightSegment* first, const SightSegment* last);
/// A tree over segments [first, last) in their order; returns its root.
std::uint32_t add_chain(SegmentTree& tree, std::uint32_t first, std::uint32_t last, std::uint32_t house);
/// A tree over trees, split where they lie apart.
std::uint32_t join_trees(SegmentTree& tree, std::vector<std::uint32_t>& roots);

/// Tops of walls, edges of roofs and, on slopes, of ground: whoever sees something of a showing sees one of its
/// segments.
struct RoofTargets {
  SegmentTree tree;
  std::vector<Showing> showings;       ///< by house, then sector
  std::vector<std::uint32_t> showing;  ///< per segment
  std::vector<char> is_wall;           ///< per segment: of a wall, house on the left; else of a roof, or of ground
  std::uint32_t houses = 0;            ///< of the city
};

/// The tops of walls that stand higher than the house behind them: for the sector whose facade it is, else the owner.
/// For the owner the edges of roofs (roof_edges); on slopes, where one looks down on roofs, all, and the ground
/// (ground_targets.hpp).
/// Houses lower than least_m are left out, and, where that is not 0, the ground: landmarks alone.
/// Needs  `walls` of the same city.
RoofTargets make_roof_targets(const City& city, const HouseWalls& walls, double least_m);

/// The rim of a sector's ground, islands' sides among it, ground on the left.
SegmentTree rim_of(const Sector& sector);

}  // namespace vicus
