#include "city_db/terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vicus {
namespace {

/// 3 columns, 2 rows, 10 m apart, from (-10, 20).
Terrain slope() { return {{-10'000, 20'000}, 10'000, 3, 2, {0, 1000, 4000, 2000, 2000, -500}}; }

TEST(TerrainHeight, IsZeroWithoutATerrain) { EXPECT_EQ(height_m(Terrain{}, {5, 7}), 0); }

TEST(TerrainHeight, IsExactAtEveryNode) {
  const Terrain t = slope();
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_EQ(height_m(t, {-10'000 + 10'000 * column, 20'000 + 10'000 * row}),
                t.height_mm[static_cast<std::size_t>(3 * row + column)] / 1000.0);
}

TEST(TerrainHeight, IsBilinearBetween) {
  EXPECT_DOUBLE_EQ(height_m(slope(), {-5'000, 20'000}), 0.5);
  EXPECT_DOUBLE_EQ(height_m(slope(), {-10'000, 25'000}), 1);
  EXPECT_DOUBLE_EQ(height_m(slope(), {5'000, 25'000}), (1 + 4 + 2 - 0.5) / 4);
  EXPECT_DOUBLE_EQ(height_m(slope(), {2'500, 27'500}), 0.25 * (0.75 * 1 + 0.25 * 4) + 0.75 * (0.75 * 2 - 0.25 * 0.5));
}

TEST(TerrainHeight, BeyondTheRimIsAsAtTheRim) {
  EXPECT_EQ(height_m(slope(), {-kPlanLimit + 1, -kPlanLimit + 1}), 0);
  EXPECT_EQ(height_m(slope(), {kPlanLimit - 1, kPlanLimit - 1}), -0.5);
  EXPECT_DOUBLE_EQ(height_m(slope(), {5'000, -99'000}), 2.5);
  EXPECT_DOUBLE_EQ(height_m(slope(), {99'000, 25'000}), 1.75);
}

TEST(TerrainHeight, LiesWithinTheRangeOfItsBox) {
  Terrain terrain{{0, 0}, 5'000, 8, 6, {}};
  for (std::int32_t i = 0; i < 48; ++i) terrain.height_mm.push_back(i * 7919 % 1000 * 20);
  for (std::int32_t i = 0; i < 200; ++i) {
    PlanBox box;
    box.add({i * 331 % 50'000 - 6'000, i * 577 % 40'000 - 6'000});
    box.add({box.min.x + i * 97 % 9'000, box.min.y + i * 61 % 9'000});
    const HeightRange range = height_range(terrain, box);
    for (std::int32_t k = 0; k <= 100; ++k) {
      const double h = height_m(terrain, {box.min.x + (box.max.x - box.min.x) / 10 * (k % 10),
                                          box.min.y + (box.max.y - box.min.y) / 10 * (k / 10)});
      ASSERT_GE(h, range.least_m - 1e-9);
      ASSERT_LE(h, range.greatest_m + 1e-9);
    }
  }
}

TEST(TerrainHeight, OfOneNodeIsThatEverywhere) {
  const Terrain t{{0, 0}, 5'000, 1, 1, {1234}};
  for (const PlanPoint p : {PlanPoint{0, 0}, {7'000, -9'000}, {-1, 1}}) EXPECT_EQ(height_m(t, p), 1.234);
}

TEST(TerrainHeight, LiesBetweenTheNodesAround) {
  std::mt19937 random(5);
  Terrain t{{-50'000, -30'000}, 5'000, 21, 13, {}};
  for (std::uint32_t i = 0; i < t.columns * t.rows; ++i)
    t.height_mm.push_back(static_cast<std::int32_t>(random() % 100'000) - 50'000);
  for (int i = 0; i < 10'000; ++i) {
    const int x = static_cast<int>(random() % 100'000), y = static_cast<int>(random() % 60'000);
    const auto node = [&](int dx, int dy) {
      return t.height_mm[static_cast<std::size_t>((y / 5'000 + dy) * 21 + x / 5'000 + dx)] / 1000.0;
    };
    const auto [least, most] = std::minmax({node(0, 0), node(1, 0), node(0, 1), node(1, 1)});
    const double height = height_m(t, {-50'000 + x, -30'000 + y});
    EXPECT_GE(height, least - 1e-12);
    EXPECT_LE(height, most + 1e-12);
  }
}

}  // namespace
}  // namespace vicus
