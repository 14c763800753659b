#pragma once
#include <cstdint>
#include <vector>

#include "city_db/city.hpp"

/// A coarse bitmap of the plan: where is anything near, and how far. Decides what belongs to the city and which ground
/// is open; never where an edge lies to the millimetre.
///
/// Frame   cell (0,0)'s lower left corner at `min`; row-major, south to north.
/// Error   distances are between cell centres: off by at most 1.5 cells.
namespace vicus {

struct Raster {
  PlanPoint min;
  std::int32_t cell_mm = 8000;
  int columns = 0, rows = 0;

  /// Covers the box with `margin_m` around it, at most kMaxCells cells.
  static Raster over(const PlanBox& box, double cell_m, double margin_m);
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  int column_of(std::int32_t x) const;  ///< clamped
  int row_of(std::int32_t y) const;     ///< clamped
  std::size_t cell_at(PlanPoint p) const { return index(column_of(p.x), row_of(p.y)); }
};

using Mask = std::vector<char>;

/// Marks every cell whose centre is inside and every cell its edges pass.
void paint(const Raster& raster, const Polygon& polygon, Mask& mask);
void paint(const Raster& raster, const std::vector<PlanPoint>& line, Mask& mask);

/// Metres from each cell to the nearest marked one (0 inside; a large number when none is).
/// Source  Felzenszwalb & Huttenlocher, "Distance transforms of sampled functions", Theory of Computing 8 (2012).
std::vector<float> distance_m(const Raster& raster, const Mask& mask);

/// Outer outlines of the marked cells (8-connected holes filled), corners cut, simplified to one cell.
std::vector<Polygon> outlines(const Raster& raster, const Mask& mask);

}  // namespace vicus
