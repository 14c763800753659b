#include "sectorgen/bake/picture/silhouette.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vicus {
namespace {

int skyline_row(const Coverage& picture, int column) {
  for (int row = 0; row < picture.height; ++row)
    if (picture.at(column, row) >= 0.5f) return row;
  return picture.height;
}

}  // namespace

double silhouette_iou(const Coverage& a, const Coverage& b) {
  assert(a.width == b.width && a.height == b.height);
  double both = 0, either = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    both += std::min(a.pixels[i], b.pixels[i]);
    either += std::max(a.pixels[i], b.pixels[i]);
  }
  return either == 0 ? 1 : both / either;
}

SkylineDistance skyline_distance(const Coverage& a, const Coverage& b) {
  assert(a.width == b.width && a.height == b.height);
  SkylineDistance out;
  for (int column = 0; column < a.width; ++column) {
    const double d = std::abs(skyline_row(a, column) - skyline_row(b, column));
    out.mean_px += d / a.width;
    out.max_px = std::max(out.max_px, d);
  }
  return out;
}

}  // namespace vicus
