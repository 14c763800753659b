#pragma once
#include <vector>

#include "city_db/city.hpp"

namespace vicus {

struct WallRectangle {
  double x0 = 0, x1 = 0, z0 = 0, z1 = 0;
  friend bool operator==(const WallRectangle&, const WallRectangle&) = default;
};

/// The rectangle [0, length] x [bottom, top] without the openings, as rectangles that do not overlap: cut level at each
/// opening's lower and upper edge, and put together again where nothing begins or ends.
/// Needs   openings apart from each other, within the rectangle.   Cost  openings squared.
std::vector<WallRectangle> wall_pieces(double length_m, double bottom_m, double top_m,
                                       const std::vector<Opening>& openings);

}  // namespace vicus
