#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geom/triangulation.hpp"

/// The ground one can walk on, as triangles: what shortest walks are found in.
namespace vicus {

/// Squares of lattice differences are far from overflow: no hypot.
inline double straight_mm(PlanPoint a, PlanPoint b) {
  const double x = double(b.x) - a.x, y = double(b.y) - a.y;
  return std::sqrt(x * x + y * y);
}

/// A place that a walk keeps off: a wedge with its point on a wall's corner (corner_caps.hpp). The walk may bend at
/// the points of the rim, and be rounded there with that radius.
struct CornerCap {
  PlanPoint corner;
  std::vector<PlanPoint> rim;  ///< counter-clockwise seen from the corner, >= 2 points
  std::int32_t radius_mm = 0;
};

/// A triangle and the number of a corner in it.
struct SideOfFan {
  std::uint32_t triangle = 0;
  int corner = 0;
};

/// Frame   the plan lattice.
struct WalkMesh {
  Mesh mesh;                          ///< of the whole plan; triangles that nobody walks on too
  std::vector<std::uint32_t> sector;  ///< per triangle: index of the sector; kNone: nobody walks there
  std::vector<std::uint8_t> open;     ///< per triangle: bit k: its side k can be passed
  std::vector<std::uint8_t> bends;    ///< per triangle: bit k: ground on more than half of the way round corner k
  std::vector<PlanPoint> right_wall,
      left_wall;                        ///< per point to bend at: the walls' next points on both sides of its ground
  std::vector<SideOfFan> corners;       ///< all places to bend at: where the ground round each begins on the right
  std::vector<std::int32_t> radius_mm;  ///< per point: of its cap; 0: a wall's own corner
  std::vector<std::uint32_t> part;      ///< per triangle: which connected part of the ground; kNone: none
  std::vector<std::uint32_t> way_out;   ///< per triangle in a blind alley: the next one towards its mouth; else kNone
  std::uint32_t part_count = 0;

  bool is_open(std::uint32_t t, int k) const { return (open[t] >> (k % 3)) & 1; }
  /// May a walk bend at corner k of t, passing it on this side?
  bool is_bend(std::uint32_t t, int k) const { return (bends[t] >> (k % 3)) & 1; }
  PlanPoint at(std::uint32_t t, int k) const { return mesh.points[mesh.corner(t, k)]; }
};

/// The ground of the sectors less the caps. Sides of triangles can be passed but where a sector ends without a gate.
///
/// Needs   a city that keeps rules 1 and 2 of DESIGN §3: grounds disjoint, gates on their edges.
/// Error   without caps none; with caps walls move by less than 1 mm (sectorgen/geom/noding.hpp).
/// Cost    n log n.
WalkMesh make_walk_mesh(const std::vector<Sector>& sectors, const std::vector<Gate>& gates,
                        const std::vector<CornerCap>& caps = {});

/// Triangle t, its corner j: the one across the side that is left (counter-clockwise) of that corner's ray, or right.
/// kNone where that side is closed. `j` becomes the same corner's number in it.
std::uint32_t turned_left(const WalkMesh& walk, std::uint32_t t, int& j);
std::uint32_t turned_right(const WalkMesh& walk, std::uint32_t t, int& j);

}  // namespace vicus
