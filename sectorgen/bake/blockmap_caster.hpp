#pragma once
#include <array>
#include <vector>

#include "city_db/blockmap.hpp"
#include "sectorgen/bake/cast_hit.hpp"

namespace vicus {

/// Rays into one tile, fast and exact: a pyramid of the greatest height of 1, 2 x 2, 4 x 4 ... cells is walked until a
/// cell may be hit, then its plane, foot and line are met in the order that the ray passes them.
///
/// Error   32-bit: t within 1 mm of raycast_reference 3 km from the tile, but where a ray passes an edge.
/// Source  Tevs, Ihrke & Seidel, "Maximum mipmaps for fast, accurate, and scalable dynamic height field rendering",
///         I3D 2008; research/IMAGE_BASED.md §A1.4.
/// Differs from paper 000 §3.2: no distance map and no samples along the ray, which miss corners.
/// Cost    docs/blockmaps.md, "Speed".
class BlockMapCaster {
 public:
  explicit BlockMapCaster(const BlockMap& map);

  /// The nearest hit with t in (0, before), coming from outside or above.
  CastHit cast(const PlanRay& ray, double before = std::numeric_limits<double>::infinity()) const;

 private:
  struct Cell {
    float up, east, north, foot;      ///< plane at the middle, metres a cell; foot
    float line_east, line_north, at;  ///< the line, cells; at = 9: none, everything is on the plane's side
    float spare;
  };
  struct LocalRay;
  bool meet(const LocalRay& ray, float t0, float t1, std::uint32_t column, std::uint32_t row, CellSide side,
            CastHit& hit, float& t) const;

  int side_ = 0, levels_ = 0;
  double west_ = 0, south_ = 0, cell_m_ = 1, base_ = 0, base_east_ = 0, base_north_ = 0;
  float top_ = 0;
  std::vector<Cell> cells_;
  std::vector<float> tops_;      ///< of each cell, then of 2 x 2 cells, ...
  std::array<int, 16> first_{};  ///< of each level in tops_
};

}  // namespace vicus
