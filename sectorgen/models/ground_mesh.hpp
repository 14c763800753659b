#pragma once
#include <vector>

#include "sectorgen/geom/triangulation.hpp"
#include "sectorgen/models/ground_covers.hpp"

/// The ground of a whole city as one triangulation, each triangle of one sector and one kind.
namespace vicus {

/// What a triangle is. `sector` kNone: nobody's (houses, shut courtyards, out of the city).
struct GroundCell {
  std::uint32_t sector = kNone;
  SurfaceKind kind = SurfaceKind::pavement;
  bool is_walkable = false;        ///< else ground that belongs to the sector nearest to it, seen from there
  bool is_sunk = false;            ///< below the kerb, or rails within such a carriageway
  double raised_m = 0;             ///< the top of a low wall
  std::uint32_t obstacle = kNone;  ///< what it lies in, where nobody walks
  std::uint32_t tread = kNone;     ///< index of the patch that is one step
};

struct GroundMesh {
  Mesh mesh;
  std::vector<GroundCell> cells;  ///< one each triangle
};

/// Nodes sectors, obstacles and patches with each other and triangulates them; `free_points` become vertices.
/// Holds   every corner of a sector's ground is a vertex; sectors' edges move by at most 0.71 mm, where patches end on
///         them; the same edge serves both sides, so that nothing can be seen between two triangles.
/// Cost    n log n.
GroundMesh mesh_ground(const City& city, const std::vector<Patch>& patches, const std::vector<PlanPoint>& free_points);

}  // namespace vicus
