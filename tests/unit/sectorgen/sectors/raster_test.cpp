#include "sectorgen/sectors/raster.hpp"

#include <gtest/gtest.h>

#include <random>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"

namespace vicus {
namespace {

TEST(DistanceM, EqualsBruteForce) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Raster r;
    r.cell_mm = 1'000;
    r.columns = 23;
    r.rows = 17;
    Mask mask(r.size(), 0);
    for (int i = 0; i < 9; ++i) mask[random() % mask.size()] = 1;
    const auto d = distance_m(r, mask);
    for (int y = 0; y < r.rows; ++y)
      for (int x = 0; x < r.columns; ++x) {
        double least = 1e9;
        for (int v = 0; v < r.rows; ++v)
          for (int u = 0; u < r.columns; ++u)
            if (mask[r.index(u, v)]) least = std::min(least, std::hypot(u - x, v - y));
        EXPECT_NEAR(d[r.index(x, y)], least, 1e-4);
      }
  }
}

TEST(Outlines, GoRoundEveryMarkedCellAndFillHoles) {
  Raster r;
  r.cell_mm = 1'000;
  r.columns = r.rows = 12;
  Mask mask(r.size(), 0);
  for (int y = 2; y < 9; ++y)
    for (int x = 2; x < 9; ++x) mask[r.index(x, y)] = !(x == 5 && y == 5);
  const auto polygons = outlines(r, mask);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_TRUE(polygons[0].holes.empty());
  EXPECT_NEAR(area_m2(polygons[0]), 49, 8);  // corners are cut, one cell off at most
  EXPECT_EQ(locate(polygons[0], {5'500, 5'500}), Side::inside);
}

TEST(BoxIndex, FindsWhatBruteForceFinds) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<std::int32_t> draw(-100'000, 100'000), size(0, 9'000);
  std::vector<PlanBox> boxes;
  for (int i = 0; i < 400; ++i) {
    const PlanPoint p{draw(random), draw(random)};
    boxes.push_back({p, {p.x + size(random), p.y + size(random)}});
  }
  const BoxIndex index(boxes);
  for (int i = 0; i < 200; ++i) {
    const PlanPoint p{draw(random), draw(random)};
    const PlanBox query{p, {p.x + 2 * size(random), p.y + 2 * size(random)}};
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < boxes.size(); ++k)
      if (boxes[k].min.x <= query.max.x && boxes[k].max.x >= query.min.x && boxes[k].min.y <= query.max.y &&
          boxes[k].max.y >= query.min.y)
        expected.push_back(k);
    EXPECT_EQ(index.meeting(query), expected);
  }
}

}  // namespace
}  // namespace vicus
