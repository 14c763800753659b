#include "sectorgen/visibility/sight_regions.hpp"

#include <algorithm>
#include <cmath>

namespace vicus {

Region region_of(const SegmentTree& tree, std::uint32_t node) {
  const SegmentNode& n = tree.nodes[node];
  Region region{n.centre, n.radius, {}, {}, node, n.segment, n.house, n.low_m, n.top_m};
  if (n.segment != kNowhere) {
    region.node = kNowhere;
    region.a = tree.segments[n.segment].a;
    region.b = tree.segments[n.segment].b;
    region.up_a = tree.segments[n.segment].up_a;
    region.up_b = tree.segments[n.segment].up_b;
  }
  return region;
}

std::pair<Region, Region> halves(const SegmentTree& tree, const Region& region) {
  if (!region.is_segment()) {
    const SegmentNode& n = tree.nodes[region.node];
    return {region_of(tree, n.left), region_of(tree, n.right)};
  }
  Region first = region, second = region;
  first.b = second.a = region.centre;
  first.up_b = second.up_a = (region.up_a + region.up_b) / 2;
  for (Region* half : {&first, &second}) {
    half->low_m = std::min(half->up_a, half->up_b);
    half->top_m = std::max(half->up_a, half->up_b);
    half->centre = {(half->a.x + half->b.x) / 2, (half->a.y + half->b.y) / 2};
    half->radius = region.radius / 2;
  }
  return {first, second};
}

Spot beside(const Region& segment, double left_m) {
  const double dx = segment.b.x - segment.a.x, dy = segment.b.y - segment.a.y, length = std::hypot(dx, dy);
  return {segment.centre.x - dy / length * left_m, segment.centre.y + dx / length * left_m};
}

}  // namespace vicus
