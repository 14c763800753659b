#include "sectorgen/bake/picture/depth_error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vicus {
namespace {

constexpr double kLeast_m = 0.02;

bool is_same(float a, float b) {
  if (std::isinf(a) || std::isinf(b)) return std::isinf(a) && std::isinf(b);
  return std::abs(double{a} - b) <= std::max(kLeast_m, kDepthShare * std::max(a, b));
}

float distance_px(const DepthMap& from, const DepthMap& to, int column, int row) {
  const float depth = from.at(column, row);
  if (is_same(depth, to.at(column, row))) return 0;
  int least2 = (kDepthReach_px + 1) * (kDepthReach_px + 1);
  for (int y = std::max(0, row - kDepthReach_px); y <= std::min(to.height - 1, row + kDepthReach_px); ++y)
    for (int x = std::max(0, column - kDepthReach_px); x <= std::min(to.width - 1, column + kDepthReach_px); ++x) {
      const int away2 = (x - column) * (x - column) + (y - row) * (y - row);
      if (away2 < least2 && is_same(depth, to.at(x, y))) least2 = away2;
    }
  return static_cast<float>(std::sqrt(least2));
}

}  // namespace

ErrorSummary projected_depth_error_px(const DepthMap& a, const DepthMap& b) {
  assert(a.width == b.width && a.height == b.height);
  std::vector<float> errors;
  errors.reserve(a.pixels.size());
  for (int row = 0; row < a.height; ++row)
    for (int column = 0; column < a.width; ++column)
      errors.push_back(std::max(distance_px(a, b, column, row), distance_px(b, a, column, row)));
  return summary_of(std::move(errors));
}

}  // namespace vicus
