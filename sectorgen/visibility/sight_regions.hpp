#pragma once
#include <utility>

#include "sectorgen/visibility/roof_targets.hpp"

/// Stretches of rim and of walls, halved until two of them can be told hidden or seen.
namespace vicus {

/// A node of a tree, or a part of a leaf's segment.
struct Region {
  Spot centre;
  double radius = 0;
  Spot a, b;                      // of a segment
  std::uint32_t node = kNowhere;  // an inner node; else a segment
  std::uint32_t segment = kNowhere, house = kNowhere;
  double low_m = 0, top_m = 0, up_a = 0, up_b = 0;  // of a segment the heights of a and b
  bool is_segment() const { return node == kNowhere; }
};

Region region_of(const SegmentTree& tree, std::uint32_t node);
std::pair<Region, Region> halves(const SegmentTree& tree, const Region& region);
/// The middle of a segment, moved to its left (metres; negative: to its right).
Spot beside(const Region& segment, double left_m);

}  // namespace vicus
