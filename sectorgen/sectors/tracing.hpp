#pragma once
#include <vector>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/ground.hpp"

/// From labelled triangles to rings: the boundary of every region, with what lies beyond each stretch.
namespace vicus {

struct HalfEdge {
  std::uint32_t triangle = 0;
  int side = 0;
};

/// One straight piece of a region's boundary, region on the left.
struct BoundaryPiece {
  PlanPoint a, b;
  std::uint32_t other = kNone;        ///< the region beyond; kNone: an obstacle or the city's edge
  std::uint32_t ground_side = kNone;  ///< index into Ground::sides where an obstacle or the city's edge lies beyond
  HalfEdge first, last;               ///< the mesh's edges it was made of
};

using BoundaryWalk = std::vector<BoundaryPiece>;

/// Boundaries of the regions 0 .. count-1. T-vertices that end no edge between two regions are left out again.
struct Boundaries {
  std::vector<std::vector<BoundaryWalk>> walks;  ///< per region, in the order of their smallest half-edge
  std::vector<char> is_kept;                     ///< per mesh point: false for a T-vertex that was left out
  std::vector<char> is_pinch;                    ///< per mesh point: some walk passes it more than once
};
Boundaries trace_regions(const Ground& ground, const std::vector<std::uint32_t>& region, std::uint32_t count);

/// The piece's twin is the next piece's twin's successor: both lie on one line between the same two regions.
bool continues(const Ground& ground, const std::vector<std::uint32_t>& region, const BoundaryPiece& a,
               const BoundaryPiece& b);

/// Islands by the region they lie in.
void locate_islands(const Ground& ground, const std::vector<std::uint32_t>& region,
                    std::vector<std::vector<std::uint32_t>>& islands);

/// Points of a walk.
Ring ring_of(const BoundaryWalk& walk);

/// Original feature rings with the T-vertices that were kept on their edges.
class Bends {
 public:
  Bends(const Ground& ground, const Boundaries& boundaries);
  Ring apply(const Ring& ring) const;

 private:
  struct Bend {
    PlanPoint a, b;  // a < b
    std::vector<PlanPoint> points;
  };
  std::vector<Bend> bends_;
};

/// A directed side of a feature, the feature on its left.
struct FeatureSide {
  PlanPoint a, b;
  std::uint32_t feature = 0;
  friend bool operator<(const FeatureSide& x, const FeatureSide& y) {
    return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.feature < y.feature;
  }
};

/// Sides of one layer's features with the bends of their edges, sorted. What a feature walks as often back (a
/// spike that rounding closed) is no side of it.
std::vector<FeatureSide> feature_sides(const std::vector<NodedPart>& map, MapLayer layer, const Bends& bends);

/// Features as they ended up: simple polygons with the bends of their edges. A ring that rounding pinched may give
/// several; one that vanished gives none.   visit(layer, feature, polygon)
template <class Visit>
void for_features(const std::vector<NodedPart>& map, const Bends& bends, Visit visit) {
  for (std::size_t i = 0; i < map.size();) {
    const MapLayer layer = map[i].layer;
    const std::uint32_t feature = map[i].feature;
    std::vector<Ring> walks;
    for (; i < map.size() && map[i].layer == layer && map[i].feature == feature; ++i)
      if (layer != MapLayer::kerb) walks.push_back(bends.apply(map[i].points));
    for (auto& polygon : assemble(simple_rings(walks))) visit(layer, feature, std::move(polygon));
  }
}

}  // namespace vicus
