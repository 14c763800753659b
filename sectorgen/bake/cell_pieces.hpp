#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sectorgen/bake/bake_scene.hpp"

/// Houses cut to the cells of a tile, exactly: convex pieces of roof and stretches of wall.
///
/// Frame   in plan: cells from the tile's south-west corner; a piece's and stretch's points count from the middle of
///         its cell, so they lie within +-0.5. Heights: metres above the tile's base plane.
namespace vicus {

/// Where a tile lies and how fine it is.
struct TileFrame {
  PlanPoint corner;  ///< south-west
  std::uint32_t side = 0, tile_side_mm = 0;
  UpPlane base;  ///< in plan metres
  double cell_m() const { return metres(tile_side_mm) / side; }
  double west_m() const { return metres(corner.x); }
  double south_m() const { return metres(corner.y); }
  PlanBox box() const {
    return {corner,
            {static_cast<std::int32_t>(std::int64_t{corner.x} + tile_side_mm),
             static_cast<std::int32_t>(std::int64_t{corner.y} + tile_side_mm)}};
  }
};

struct CellPoint {
  double x = 0, y = 0;
};

/// A part of a roof facet in one cell.
struct RoofPiece {
  std::uint32_t cell = 0, house = 0;
  std::uint32_t first_point = 0, points = 0;  ///< convex, counter-clockwise
  double area = 0;                            ///< cells
  double x = 0, y = 0;                        ///< centroid
  double up = 0, east = 0, north = 0;         ///< at the centroid; metres a cell
  Colour shown;                               ///< as the world's lights show it
  double up_at(CellPoint p) const { return up + east * (p.x - x) + north * (p.y - y); }
};

/// A part of a wall in one cell, house on the left of a -> b.
struct WallPiece {
  std::uint32_t cell = 0, house = 0, wall = 0;
  CellPoint a, b;
  double from = 0, to = 0;  ///< along the wall, 0 ... 1
};

struct CellPieces {
  std::vector<RoofPiece> roofs;  ///< by cell
  std::vector<CellPoint> points;
  std::vector<WallPiece> walls;                       ///< by cell
  std::vector<std::uint32_t> first_roof, first_wall;  ///< of each cell, and one more
  std::span<const RoofPiece> roofs_of(std::size_t cell) const {
    return std::span(roofs).subspan(first_roof[cell], first_roof[cell + 1] - first_roof[cell]);
  }
  std::span<const WallPiece> walls_of(std::size_t cell) const {
    return std::span(walls).subspan(first_wall[cell], first_wall[cell + 1] - first_wall[cell]);
  }
  std::span<const CellPoint> points_of(const RoofPiece& p) const {
    return std::span(points).subspan(p.first_point, p.points);
  }
};

/// Of the houses `which` of the scene.   Cost  proportional to the cells that houses cover and touch.
CellPieces cut_to_cells(const BakeScene& scene, const std::vector<std::uint32_t>& which, const TileFrame& frame);

}  // namespace vicus
