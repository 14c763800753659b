#pragma once
#include <memory>
#include <vector>

#include "sectorgen/geom/triangulation.hpp"
#include "sectorgen/sectors/noded_map.hpp"

/// The walkable ground as a triangulation whose edges are all places where a cut may be.
///
/// Every vertex lies on an obstacle or a kerb, so the mesh's dual graph is a deformation retract of the ground less its
/// kerbs: reducing paths in it is exact homotopy (research/SECTORS.md §1).
namespace vicus {

/// What lies beyond a bounding edge of the ground.
enum class Beyond : char { house, wall, water, city_edge };

/// A bounding edge of the ground before T-vertices were put on it: an edge of the noded features.
struct GroundSide {
  PlanPoint a, b;  ///< ground on the left
  Beyond beyond = Beyond::house;
  std::vector<PlanPoint> added;  ///< T-vertices from a to b
};

struct GroundEdge {
  PlanPoint a, b;              ///< ground on the left
  std::uint32_t side = kNone;  ///< index into Ground::sides; kNone: a kerb, ground on both sides
  bool is_kerb() const { return side == kNone; }
};

struct Island {
  Polygon area;
  Beyond kind = Beyond::house;
};

struct Ground {
  Mesh mesh;                      ///< of everything; edge[] indexes `edges`
  std::vector<GroundEdge> edges;  ///< constrained edges
  std::vector<GroundSide> sides;
  std::vector<char> is_free;        ///< per triangle
  std::vector<char> is_added;       ///< per point: a T-vertex, not in the source
  std::vector<Island> islands;      ///< small free-standing obstacles, left out of the mesh
  std::vector<Ring> domain;         ///< outline of the city: simple rings, city on the left
  std::vector<Polygon> courtyards;  ///< shut ground, not in the mesh

  /// A number for each undirected edge, from either side; size of such numbers.
  std::uint32_t edge_id(std::uint32_t t, int k) const;
  std::size_t edge_ids() const { return mesh.triangles.size() * 3; }
  bool is_crossable(std::uint32_t t, int k) const;  ///< free on both sides, kerb or not
  bool is_city_edge(std::uint32_t t, int k) const;  ///< a free triangle's side where the city ends
  PlanPoint from(std::uint32_t t, int k) const { return mesh.points[mesh.corner(t, k + 1)]; }
  PlanPoint to(std::uint32_t t, int k) const { return mesh.points[mesh.corner(t, k + 2)]; }
  std::uint32_t beyond(std::uint32_t t, int k) const {
    return mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
  }
};

// Asked for every edge at every step: inline.
inline std::uint32_t Ground::edge_id(std::uint32_t t, int k) const {
  const std::uint32_t mine = 3 * t + static_cast<std::uint32_t>(k % 3);
  const std::uint32_t n = beyond(t, k % 3);
  if (n == kNone || n > t) return mine;
  return 3 * n + static_cast<std::uint32_t>(mesh.twin_side(t, k % 3));
}

inline bool Ground::is_crossable(std::uint32_t t, int k) const {
  const std::uint32_t n = beyond(t, k);
  if (n == kNone || !is_free[t] || !is_free[n]) return false;
  const std::uint32_t e = mesh.triangles[t].edge[static_cast<std::size_t>(k)];
  return e == kNone || edges[e].is_kerb();
}

/// The noded map triangulated, with how many features of each layer cover each triangle: the ground before small
/// obstacles are taken out and T-vertices put in. Made once, cut several times.
/// Source  research/SECTORS.md §4.1.
/// Differs no polygon union: a flood through the triangulation counts the covers.
///
/// Free ground that no point of `reach` lies in is shut: a courtyard, or outside where the city's edge is open to it.
/// With no points nothing is shut.
class CoverMesh {
 public:
  CoverMesh(const std::vector<NodedPart>& map, const std::vector<PlanPoint>& reach);
  ~CoverMesh();
  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

struct GroundOptions {
  double island_m2 = 60;              ///< smaller free-standing obstacles become islands
  std::vector<PlanPoint> no_islands;  ///< sorted: small obstacles with this first point stay in the mesh
  double piece_m = 6;                 ///< facades get a candidate vertex at least this often
};

/// Error   a facade bends by at most 0.71 mm at a T-vertex; else none.
/// Fails   CityError(exit 4): no ground at all.
/// Source  research/SECTORS.md §4.2.
Ground make_ground(const CoverMesh& first, const GroundOptions& options);

}  // namespace vicus
