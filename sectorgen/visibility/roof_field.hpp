#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/house_walls.hpp"

/// Sure heights on a grid, worn away from the edges: what a disc of some radius finds above itself wherever it lies.
namespace vicus {

inline constexpr double kHeightStep_m = 0.5;

/// One grid of the field. A value holds for every point of the cell and everything within `radius_m` of it. Kept in
/// blocks of 8 x 8 cells, one cache line each; blocks of open ground are the first one.
struct WornGrid {
  double cell_m = 0, radius_m = 0;
  std::int64_t columns = 0, rows = 0, block_columns = 0;
  std::vector<std::uint32_t> block;
  std::vector<std::uint8_t> height;  ///< in steps of kHeightStep_m, rounded down
};

/// Error   heights are lower bounds: rounded down to 0.5 m, at most 127.5 m; cells that a wall touches count as the
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
  /// The most one can be sure of: every point within the grid's radius of x is roofed up to this. 0: nothing sure.
  double sure_height(const WornGrid& grid, Spot x) const {
    const double across = (x.x - left_) / grid.cell_m, along = (x.y - bottom_) / grid.cell_m;
    if (!(across >= 0 && along >= 0 && across < static_cast<double>(grid.columns) &&
          along < static_cast<double>(grid.rows)))
      return 0;
    const auto column = static_cast<std::size_t>(across), row = static_cast<std::size_t>(along);
    const std::size_t block = grid.block[(row >> 3) * static_cast<std::size_t>(grid.block_columns) + (column >> 3)];
    return kHeightStep_m * grid.height[64 * block + 8 * (row & 7) + (column & 7)];
  }
  /// A line at x with that direction meets no grid any more.
  bool is_left_for_good(Spot x, Spot direction) const {
    return (x.x < left_ && direction.x <= 0) || (x.x > right_ && direction.x >= 0) ||
           (x.y < bottom_ && direction.y <= 0) || (x.y > top_ && direction.y >= 0);
  }

 private:
  std::vector<std::uint8_t> draw(const HouseWalls& houses, double cell_m, std::int64_t columns,
                                 std::int64_t rows) const;
  double left_ = 0, bottom_ = 0, right_ = 0, top_ = 0;
  std::vector<WornGrid> grids_;  // by radius
};

}  // namespace vicus
