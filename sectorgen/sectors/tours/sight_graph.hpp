#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sectorgen/sectors/tours/sight.hpp"

/// Which corners see each other: the graph that every shortest walk runs along.
namespace vicus {

inline constexpr std::size_t kLandmarks = 16;

/// Nodes are the corners a walk may bend at; an edge joins two that see each other along a line which touches both
/// (a shortest walk is taut: it leaves a corner only along such a line). Undirected, each edge listed at both ends.
struct SightGraph {
  struct Corner {
    PlanPoint at, right_wall, left_wall;  ///< as the mesh has them, close together
    bool is_blind = false;                ///< all its ground is in blind alleys
  };
  std::vector<Corner> corner;          ///< per node
  std::vector<std::uint32_t> point;    ///< per node: of the mesh
  std::vector<std::uint32_t> node_of;  ///< per point of the mesh; kNone: no corner
  std::vector<std::uint32_t> begin, neighbour;
  /// Shortest walks from some corners far out to each node, mm; infinite where there is none. For lower bounds: two
  /// places are no nearer to each other than their distances from a third differ.
  std::vector<std::array<float, kLandmarks>> from_landmark;
  std::size_t landmarks = 0;
};

/// Error   from_landmark: rounded to float, below kLandmarkSlack_mm.
/// Cost    sides seen from all corners, then kLandmarks times all edges; shared out to all cores.
/// Source  landmarks: Goldberg & Harrelson, "Computing the shortest path: A* search meets graph theory", SODA 2005.
SightGraph make_sight_graph(const WalkMesh& walk);

inline constexpr double kLandmarkSlack_mm = 4;  ///< floats of up to 2^25 mm (33 km) are whole multiples of 2 mm

}  // namespace vicus
