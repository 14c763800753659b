#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/sectors/tours/sight.hpp"

/// Which corners see each other: the graph that every shortest walk runs along.
namespace vicus {

inline constexpr std::size_t kLandmarks = 16;

/// Nodes are the corners a walk may bend at; an edge joins two that see each other along a line which touches both
/// (a shortest walk is taut: it leaves a corner only along such a line). Undirected, each edge listed at both ends.
///
/// Seen from a corner, what a line that touches it comes from or goes to lies in one of two wedges: the first from the
/// right wall to straight on from the left one, the second from straight on from the right wall to the left one. A walk
/// that comes from the first wedge goes on into the second, turning left or not at all, and the other way round: else
/// it is not taut.
struct SightGraph {
  struct Corner {
    PlanPoint at, right_wall, left_wall;  ///< as the mesh has them, close together
    bool is_blind = false;                ///< all its ground is in blind alleys
    bool has_in_first(PlanPoint p) const { return orient(at, right_wall, p) >= 0 && orient(at, left_wall, p) >= 0; }
    bool has_in_second(PlanPoint p) const { return orient(at, right_wall, p) <= 0 && orient(at, left_wall, p) <= 0; }
  };
  std::vector<Corner> corner;          ///< per node
  std::vector<std::uint32_t> point;    ///< per node: of the mesh
  std::vector<std::uint32_t> node_of;  ///< per point of the mesh; kNone: no corner
  /// Of node n: neighbours in the first wedge are those from begin[n] to second[n], in the second those from there to
  /// begin[n + 1], each counter-clockwise; one in both is in both lists.
  std::vector<std::uint32_t> begin, second, neighbour;
  /// Shortest walks from some corners far out to each node, mm; infinite where there is none. For lower bounds: two
  /// places are no nearer to each other than their distances from a third differ.
  std::vector<std::array<double, kLandmarks>> from_landmark;
  std::size_t landmarks = 0;
};

/// Cost    sides seen from all corners, then kLandmarks times all edges; shared out to all cores.
/// Source  landmarks: Goldberg & Harrelson, "Computing the shortest path: A* search meets graph theory", SODA 2005.
SightGraph make_sight_graph(const WalkMesh& walk);

}  // namespace vicus
