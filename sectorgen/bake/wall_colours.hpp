#pragma once
#include "city_db/blockmap.hpp"
#include "sectorgen/bake/cell_fit.hpp"
#include "sectorgen/bake/webp_image.hpp"

namespace vicus {

/// Where a wall's column begins and ends, metres above the base plane: at a line from the foot to the plane at the
/// middle; at a side from the neighbour's middle of that side (0 beyond the rim) to the cell's own.
struct WallSpan {
  double low_m = 0, high_m = 0;
};
WallSpan wall_span(const BlockMap& map, std::size_t cell, WallBit wall);

/// The picture of all wall columns of a tile, as the world's lights show them. A step between two cells where no wall
/// stands has the colour of the upper one in `roof`.
/// Needs   fits of all cells of `map`.
RgbImage wall_colours(const BakeScene& scene, const TileFrame& frame, const BlockMap& map, const CellPieces& pieces,
                      const std::vector<CellFit>& fits, const RgbImage& roof);

}  // namespace vicus
