#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "city_db/units.hpp"

/// Constrained Delaunay triangulation on the lattice, as flat arrays.
namespace vicus {

inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

struct Edge {
  std::uint32_t a = 0, b = 0;  ///< indices of points
};

/// corner k is opposite edge k, which runs from corner k+1 to corner k+2 (mod 3), triangle on its left.
struct Triangle {
  std::array<std::uint32_t, 3> corner{};
  std::array<std::uint32_t, 3> neighbour{};  ///< kNone beyond the convex hull
  std::array<std::uint32_t, 3> edge{};       ///< index of the input edge lying there, kNone: a free edge
};

struct Mesh {
  std::vector<PlanPoint> points;
  std::vector<Triangle> triangles;

  std::uint32_t corner(std::uint32_t t, int k) const { return triangles[t].corner[static_cast<std::size_t>(k % 3)]; }
  /// Which edge of t has n beyond it.   Needs  n is a neighbour of t.
  int side_towards(std::uint32_t t, std::uint32_t n) const {
    return triangles[t].neighbour[0] == n ? 0 : triangles[t].neighbour[1] == n ? 1 : 2;
  }
  /// The side of `neighbour` across edge k of t.
  int twin_side(std::uint32_t t, int k) const;
};

/// Delaunay triangulation of the points' convex hull that keeps every edge.
///
/// Points may repeat: repeated ones are merged to the first. Cocircular points: the diagonal at the smallest vertex,
/// so the result depends on coordinates only, not on the order of the input (research/SECTORS.md §5, Determinism).
/// Triangles come in the order of their smallest corner, then the others.
/// Needs   edges noded: no two cross, no point lies inside an edge (sectorgen/geom/noding.hpp).
/// Fails   CityError when an edge is not noded.   Cost  n log n.
Mesh triangulate_edges(const std::vector<PlanPoint>& points, const std::vector<Edge>& edges);

}  // namespace vicus
