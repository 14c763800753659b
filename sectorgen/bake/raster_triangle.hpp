#pragma once
#include <algorithm>
#include <cmath>

/// Which points of a grid lie in a triangle.
namespace vicus {

/// Calls take(column, row) for every grid point (column + 0.5, row + 0.5) with 0 <= column < width, 0 <= row < height
/// in the triangle. Points on an edge that two triangles share belong to exactly one of them, up to rounding of the
/// edge.
template <class Take>
void raster_triangle(const double (&x)[3], const double (&y)[3], int width, int height, Take take) {
  const double low = std::min({y[0], y[1], y[2]}), high = std::max({y[0], y[1], y[2]});
  const int first = std::max(0, static_cast<int>(std::ceil(low - 0.5)));
  const int last = std::min(height - 1, static_cast<int>(std::ceil(high - 0.5)) - 1);
  for (int row = first; row <= last; ++row) {
    const double at = row + 0.5;
    double west = 1e300, east = -1e300;
    for (int k = 0; k < 3; ++k) {
      const int l = k == 2 ? 0 : k + 1;
      if ((y[k] <= at) == (y[l] <= at)) continue;
      // From the lower end always, so that both triangles of an edge round alike.
      const int p = y[k] <= y[l] ? k : l, q = p == k ? l : k;
      const double cut = x[p] + (at - y[p]) / (y[q] - y[p]) * (x[q] - x[p]);
      west = std::min(west, cut);
      east = std::max(east, cut);
    }
    if (west > east) continue;
    const int begin = static_cast<int>(std::ceil(std::max(west - 0.5, 0.0)));
    const int end = static_cast<int>(std::ceil(std::min(east - 0.5, double(width))));
    for (int column = begin; column < end; ++column) take(column, row);
  }
}

}  // namespace vicus
