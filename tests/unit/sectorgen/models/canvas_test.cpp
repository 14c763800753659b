#include "sectorgen/models/canvas.hpp"

#include <gtest/gtest.h>

namespace vicus {
namespace {

TEST(NoiseLine, IsBetweenTheRandomValuesOfTheFourPlacesAround) {
  constexpr unsigned kSeed = 3;
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  for (double y = 0; y < 3; y += 0.13) {
    const NoiseLine line(y, 9.5, kSeed);
    for (double x = 0; x <= 9.5; x += 0.17) {
      const int column = static_cast<int>(x), row = static_cast<int>(y);
      const double tx = smooth(x - column), ty = smooth(y - row);
      const auto at = [&](int c, int r) { return steady_random(column + c, row + r, kSeed); };
      const double low = at(0, 0) * (1 - tx) + at(1, 0) * tx, high = at(0, 1) * (1 - tx) + at(1, 1) * tx;
      EXPECT_NEAR(line(x), low * (1 - ty) + high * ty, 1e-12) << x << " " << y;
    }
  }
}

TEST(NoiseLine, CoversItsWholeLength) {
  for (double most = 0; most < 4; most += 0.25) {
    const NoiseLine line(0.5, most, 1);
    EXPECT_GE(line(most), 0);
    EXPECT_LE(line(most), 1);
  }
}

}  // namespace
}  // namespace vicus
