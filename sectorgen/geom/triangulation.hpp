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

/// A value for each triangle, carried from outside the hull (`outside`) from neighbour to neighbour: enter(value, t, k)
/// is what the value becomes on stepping into triangle t over its side k.
/// Needs   the same value on every way to a triangle (covers counted at edges are).
template <class Value, class Enter>
std::vector<Value> flood_from_hull(const Mesh& mesh, const Value& outside, Enter enter) {
  std::vector<Value> values(mesh.triangles.size());
  std::vector<char> is_known(mesh.triangles.size(), 0);
  std::vector<std::uint32_t> queue;
  const auto step_into = [&](const Value& value, std::uint32_t t, int k) {
    values[t] = enter(value, t, k);
    is_known[t] = 1;
    queue.push_back(t);
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size() && queue.empty(); ++t)
    for (int k = 0; k < 3 && queue.empty(); ++k)
      if (mesh.triangles[t].neighbour[static_cast<std::size_t>(k)] == kNone) step_into(outside, t, k);
  while (!queue.empty()) {
    const std::uint32_t t = queue.back();
    queue.pop_back();
    for (int k = 0; k < 3; ++k)
      if (const std::uint32_t n = mesh.triangles[t].neighbour[static_cast<std::size_t>(k)]; n != kNone && !is_known[n])
        step_into(values[t], n, mesh.twin_side(t, k));
  }
  return values;
}

}  // namespace vicus
