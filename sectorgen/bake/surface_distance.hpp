#pragma once
#include "city_db/blockmap.hpp"
#include "sectorgen/bake/cell_pieces.hpp"

namespace vicus {

/// How far a point lies from the surface of a tile, at most: the nearest of some points of the surface in the 5 x 5
/// cells around, on planes, feet, lines and sides.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const BlockMap& map);  ///< needs the planes; keeps a reference
  /// `at` from the middle of the cell; `up_m` above the base plane. Below `enough_m` any bound will do.
  double at_most(std::size_t cell, CellPoint at, double up_m, double enough_m = 0) const;

 private:
  double up_at(std::size_t cell, CellPoint p) const;
  double plane_at(std::size_t cell, CellPoint p) const;
  const BlockMap& map_;
  double cell_m_, step_m_;
};

}  // namespace vicus
