#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "sectorgen/sectors/tours/walk_places.hpp"
#include "sectorgen/sectors/tours/walk_search.hpp"

/// The shortest walk between two places on the ground.
namespace vicus {

/// Ground of another sector begins so far along the walk.
struct SectorEntered {
  std::uint32_t sector = kNone;
  double at_mm = 0;
};

struct Walk {
  std::vector<PlanPoint> points;        ///< from, where it bends, to: straight between
  std::vector<std::int32_t> radius_mm;  ///< per point: it may be rounded with that radius (WalkMesh)
  std::vector<SectorEntered> sectors;   ///< in order; the first at 0
  double length_mm = 0;
  std::uint64_t steps = 0;  ///< edges of the graph followed: what it cost
};

/// Finds walks in one mesh; keeps its tables between calls. One per thread.
///
/// Exact   no walk in the mesh's ground is shorter: what can be seen is decided by integer predicates, lengths are sums
///         of square roots in double (relative error < 1e-12). Touching walls is allowed (closed semantics); where two
///         pieces of ground meet in a point only, nobody passes.
/// Proof   a shortest walk is taut: straight between corners, each of its lines touches both its corners. From `from`
///         and `to` all such corners are looked for, between corners they are the graph's edges, and the search along
///         them ends with the shortest (WalkSearch). It goes into blind alleys only where the walk begins or ends in
///         them, and turns only towards walls it touches.
class ShortestWalk {
 public:
  ShortestWalk(const WalkMesh& walk, const WalkPlaces& places, const SightGraph& graph);

  /// nullopt: `from` and `to` are not connected, or nobody stands there.
  std::optional<Walk> find(PlanPoint from, PlanPoint to);

 private:
  bool is_one_piece(const std::vector<std::uint32_t>& standing) const;
  void let_into_alleys(const std::vector<std::uint32_t>& triangles);
  void look_from(PlanPoint p, const std::vector<std::uint32_t>& triangles, WalkEnd& end);
  Walk walk_along(const std::vector<PlanPoint>& points, const std::vector<std::uint32_t>& nodes);

  const WalkMesh& walk_;
  const WalkPlaces& places_;
  const SightGraph& graph_;
  Sight sight_;
  WalkSearch search_;
  WalkEnd from_, to_;
};

}  // namespace vicus
