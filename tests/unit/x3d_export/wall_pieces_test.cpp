#include "x3d_export/wall_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vicus {
namespace {

template <class Rectangle>
bool holds(const Rectangle& r, double x, double z) {
  return x > r.x0 && x < r.x1 && z > r.z0 && z < r.z1;
}

TEST(WallPieces, CoverTheWallOnceAndNoOpening) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    std::vector<Opening> openings;
    for (int i = 0; i < 25; ++i) {
      Opening o;
      o.x0 = pick(0, 9), o.x1 = o.x0 + pick(0.2, 1);
      o.z0 = pick(1, 6), o.z1 = o.z0 + pick(0.2, 1);
      if (std::none_of(openings.begin(), openings.end(),
                       [&](const Opening& p) { return o.x0 < p.x1 && p.x0 < o.x1 && o.z0 < p.z1 && p.z0 < o.z1; }))
        openings.push_back(o);
    }
    const auto pieces = wall_pieces(10, 1, 7.5, openings);
    for (int i = 0; i < 300; ++i) {
      const double x = pick(0, 10), z = pick(1, 7.5);
      const auto in = [&](const auto& r) { return holds(r, x, z); };
      const auto covered = std::count_if(pieces.begin(), pieces.end(), in);
      EXPECT_EQ(covered, std::any_of(openings.begin(), openings.end(), in) ? 0 : 1) << "seed " << seed;
    }
  }
}

TEST(WallPieces, OfARowOfWindowsAreTwoBandsAndThePiersBetween) {
  std::vector<Opening> row(3);
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i].x0 = 1 + 2 * static_cast<double>(i), row[i].x1 = row[i].x0 + 1;
    row[i].z0 = 1, row[i].z1 = 2;
  }
  EXPECT_EQ(wall_pieces(7, 0, 3, row).size(), 2u + 4);
  EXPECT_EQ(wall_pieces(7, 0, 3, {}), (std::vector<WallRectangle>{{0, 7, 0, 3}}));
}

}  // namespace
}  // namespace vicus
