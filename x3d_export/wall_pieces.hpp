#pragma once
#include <vector>

#include "city_db/city.hpp"

namespace vicus {

struct WallPiece {
  double x0 = 0, x1 = 0, z0 = 0, z1 = 0;
  friend bool operator==(const WallPiece&, const WallPiece&) = default;
};

/// The rectangle [0, length] x [bottom, top] without the openings, as rectangles that do not overlap: cut level at each
/// opening's lower and upper edge, and put together again where nothing begins or ends.
/// Needs   openings apart from each other, within the rectangle.   Cost  openings squared.
std::vector<WallPiece> wall_pieces(double length_m, double bottom_m, double top_m,
                                   const std::vector<Opening>& openings);

}  // namespace vicus
