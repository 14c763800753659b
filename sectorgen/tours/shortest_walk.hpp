#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "sectorgen/tours/walk_places.hpp"

/// The shortest walk between two places on the ground.
namespace vicus {

/// Ground of another sector begins so far along the walk.
struct SectorEntered {
  std::uint32_t sector = kNone;
  double at_mm = 0;
};

struct Walk {
  std::vector<PlanPoint> points;           ///< from, where it bends, to: straight between
  std::vector<std::int32_t> radius_mm;     ///< per point: it may be rounded with that radius (WalkMesh)
  std::vector<SectorEntered> sectors;      ///< in order; the first at 0
  double length_mm = 0;
  std::uint64_t steps = 0;  ///< sides of triangles looked through: what it cost
};

/// Finds walks in one mesh; keeps its tables between calls. One per thread.
///
/// Exact   no walk in the mesh's ground is shorter: what can be seen is decided by integer predicates, lengths are sums
///         of square roots in double (relative error < 1e-12). Touching walls is allowed (closed semantics); where two
///         pieces of ground meet in a point only, nobody passes.
/// Source  Cui, Harabor & Grastien, "Compromise-free pathfinding on a navigation mesh" (Polyanya), IJCAI 2017: A* over
///         intervals of sides seen from the last bend.
/// Differs an interval is kept as two rays with whole-number directions and never as points on a side: no rounding, no
///         tolerance. Blind alleys are entered only where the walk begins or ends in them.
class ShortestWalk {
 public:
  explicit ShortestWalk(const WalkMesh& walk, const WalkPlaces& places);

  /// nullopt: `from` and `to` are not connected, or nobody stands there.
  std::optional<Walk> find(PlanPoint from, PlanPoint to);

 private:
  struct Ray {
    std::int64_t x = 0, y = 0;
  };
  /// Through a side into a triangle: the rays from the root between which that side is seen.
  struct Look {
    double f = 0, g = 0;                    // shortest walk over it, at least; length up to the root
    std::uint32_t triangle = 0, before = kNone;
    std::uint32_t root = kNone;             // point of the mesh; kNone: the start
    std::int8_t side = 0;                   // 3: `to` is seen
    std::int8_t turn = 0;                   // 1, -1: bent to the left, right at the root; 0: seen from the start
    Ray left, right;
  };

  PlanPoint root_point(const Look& look) const;
  double rest_over(const Look& look) const;
  void push(Look look, double least_f);
  void push_end(const Look& seen_from, std::uint32_t index, double f);
  void start();
  void expand(std::uint32_t index);
  void turn(std::uint32_t index, int towards);
  bool is_let_in(std::uint32_t t) const { return walk_.way_out[t] == kNone || let_in_[t] == query_; }
  Walk walk_of(std::uint32_t last) const;

  const WalkMesh& walk_;
  const WalkPlaces& places_;
  PlanPoint from_, to_;
  std::vector<std::uint32_t> to_triangles_;
  std::vector<Look> looks_;
  std::vector<std::pair<double, std::uint32_t>> queue_;
  std::uint32_t query_ = 0;
  std::vector<std::uint32_t> let_in_;      // per triangle in a blind alley: the query that may enter it
  std::vector<std::uint32_t> known_[2];    // per point: the query that least_ is of; bent left, right
  std::vector<double> least_[2];           // per point: shortest way there
};

}  // namespace vicus
