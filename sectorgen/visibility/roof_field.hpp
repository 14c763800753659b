#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/house_walls.hpp"

/// Sure heights on a grid, worn away from the edges: what a disc of some radius finds above itself wherever it lies.
namespace vicus {

inline constexpr double kHeightStep_m = 0.5;  ///< the finest; coarser where a city's ground rises by more than 100 m

/// One grid of the field. A value holds for every point of the cell and everything within `radius_m` of it. Kept in
/// blocks of 8 x 8 cells, one cache line each; blocks of open ground are the first one.
struct WornGrid {
  double cell_m = 0, per_cell = 0, radius_m = 0;  ///< per_cell: 1 / cell_m, exact: cells are powers of two
  std::int64_t columns = 0, rows = 0, block_columns = 0;
  std::vector<std::uint32_t> block;
  std::vector<std::uint8_t> height;  ///< in steps above the field's base, rounded down; 0: nothing sure
};

/// Error   heights are lower bounds: rounded down to a step, at most 255 steps; cells that a wall touches count as the
///         lower of its two sides. A disc of radius r is answered by a grid with radius >= r.
/// Cost    memory: 2 bytes per cell of the finest grid while it is made, at most `most_cells` of them; after it about
///         7 bytes per cell within houses.
class RoofField {
 public:
  RoofField(const HouseWalls& houses, std::size_t most_cells);

  /// The grid that answers for a radius; nullptr: none is so coarse.
  const WornGrid* grid_for(double radius) const {
    for (const auto& grid : grids_)
      if (grid.radius_m >= radius) return &grid;
    return nullptr;
  }
  /// The most one can be sure of: every point within the grid's radius of x is roofed up to this. kNoRoof_m: nothing.
  double sure_height(const WornGrid& grid, Spot x) const {
    const double across = (x.x - left_) * grid.per_cell, along = (x.y - bottom_) * grid.per_cell;
    if (!(across >= 0 && along >= 0 && across < static_cast<double>(grid.columns) &&
          along < static_cast<double>(grid.rows)))
      return kNoRoof_m;
    const auto column = static_cast<std::size_t>(across), row = static_cast<std::size_t>(along);
    const std::size_t block = grid.block[(row >> 3) * static_cast<std::size_t>(grid.block_columns) + (column >> 3)];
    return up_of(grid.height[64 * block + 8 * (row & 7) + (column & 7)]);
  }
  /// No roof anywhere reaches higher.
  double ceiling() const { return up_of(ceiling_); }
  /// From x in that direction nothing rises above up_m until this distance; 0: something may, here.
  double clear_way(Spot x, Spot direction, double up_m) const {
    const double across = (x.x - left_) / kTile_m, along = (x.y - bottom_) / kTile_m;
    if (!(across >= 0 && along >= 0 && across < static_cast<double>(tile_columns_) &&
          along < static_cast<double>(tile_rows_)))
      return 0;
    const double column = std::floor(across), row = std::floor(along);
    if (up_of(tiles_[static_cast<std::size_t>(row) * tile_columns_ + static_cast<std::size_t>(column)]) > up_m)
      return 0;
    const auto out = [](double in, double step) { return step > 0 ? (1 - in) / step : step < 0 ? -in / step : 1e9; };
    return kTile_m * std::min(out(across - column, direction.x), out(along - row, direction.y));
  }
  /// How far on a line from x meets no grid any more.
  double end_of(Spot x, Spot direction) const {
    const auto leaves = [](double at, double step, double low, double high) {
      if (step == 0) return at < low || at > high ? 0 : HUGE_VAL;
      return (step > 0 ? high - at : low - at) / step;
    };
    return std::min(leaves(x.x, direction.x, left_, right_), leaves(x.y, direction.y, bottom_, top_));
  }

 private:
  static constexpr double kTile_m = 32;
  double up_of(std::uint8_t steps) const { return steps == 0 ? double{kNoRoof_m} : base_m_ + step_m_ * steps; }
  std::uint8_t step_below(double up_m) const {
    return static_cast<std::uint8_t>(std::clamp(std::floor((up_m - base_m_) / step_m_), 0.0, 255.0));
  }
  std::vector<std::uint8_t> draw(const HouseWalls& houses, double cell_m, std::int64_t columns,
                                 std::int64_t rows) const;
  double left_ = 0, bottom_ = 0, right_ = 0, top_ = 0, base_m_ = 0, step_m_ = kHeightStep_m;
  std::uint8_t ceiling_ = 0;
  std::size_t tile_columns_ = 0, tile_rows_ = 0;
  std::vector<std::uint8_t> tiles_;  // the greatest of each
  std::vector<WornGrid> grids_;      // by radius
};

}  // namespace vicus
