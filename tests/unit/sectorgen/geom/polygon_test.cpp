#include "sectorgen/geom/polygon.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace vicus {
namespace {

TEST(SimpleRings, CancelsEdgesWalkedBothWays) {
  // A square with a spike on its right side.
  const auto rings = simple_rings({{0, 0}, {4, 0}, {4, 2}, {9, 2}, {4, 2}, {4, 4}, {0, 4}});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_TRUE(area2(rings[0]) == 32);
}

TEST(SimpleRings, PartsAWalkThatPassesAPointTwice) {
  // Outer square, and from its corner a clockwise triangle: a hole that touches it.
  const auto rings = simple_rings({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {2, 5}, {5, 2}});
  ASSERT_EQ(rings.size(), 2u);
  const auto polygons = assemble(rings);
  ASSERT_EQ(polygons.size(), 1u);
  ASSERT_EQ(polygons[0].holes.size(), 1u);
  EXPECT_TRUE(area2(polygons[0]) == 162 - 21);
}

TEST(SimpleRings, LosesNoArea) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::int32_t> draw(0, 5);
    Ring walk;
    for (int i = 0; i < 14; ++i) walk.push_back({draw(random), draw(random)});
    Int128 sum = 0;
    for (const auto& ring : simple_rings(walk)) sum += area2(ring);
    EXPECT_TRUE(sum == area2(walk));
  }
}

TEST(SimpleRings, OpensAHoleThatLiesOnTheOuterRing) {
  // A square; its hole, clockwise, has the square's right side for one of its own.
  const std::vector<Ring> walks{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{9, 0}, {5, 4}, {9, 9}}};
  const auto polygons = assemble(simple_rings(walks));
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_TRUE(polygons[0].holes.empty());
  EXPECT_EQ(polygons[0].outer, (Ring{{0, 0}, {9, 0}, {5, 4}, {9, 9}, {0, 9}}));
}

TEST(SimpleRings, LoseNoAreaAndWalkNoEdgeBothWays) {
  int cancelled = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::int32_t> draw(0, 3);
    std::vector<Ring> walks(3);
    Int128 expected = 0, sum = 0;
    std::size_t walked = 0, left = 0;
    for (Ring& walk : walks) {
      for (int i = 0; i < 8; ++i) walk.push_back({draw(random), draw(random)});
      expected += area2(walk);
      walked += walk.size();
    }
    std::set<std::pair<PlanPoint, PlanPoint>> edges;
    for (const Ring& ring : simple_rings(walks)) {
      sum += area2(ring);
      left += ring.size();
      for (std::size_t i = 0; i < ring.size(); ++i) edges.insert({ring[i], ring[(i + 1) % ring.size()]});
    }
    EXPECT_TRUE(sum == expected);
    for (const auto& [a, b] : edges) EXPECT_FALSE(edges.contains({b, a}));
    cancelled += left < walked;
  }
  EXPECT_GT(cancelled, 100);
}

TEST(Locate, TellsInsideOutsideAndBoundary) {
  const Polygon p{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{3, 3}, {3, 6}, {6, 6}, {6, 3}}}};
  EXPECT_EQ(locate(p, {1, 1}), Side::inside);
  EXPECT_EQ(locate(p, {4, 4}), Side::outside);
  EXPECT_EQ(locate(p, {3, 5}), Side::boundary);
  EXPECT_EQ(locate(p, {10, 10}), Side::boundary);
  EXPECT_EQ(locate(p, {11, 5}), Side::outside);
}

TEST(DiameterM, EqualsTheLargestDistanceOfAllPairs) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::int32_t> draw(-50'000, 50'000);
    std::vector<PlanPoint> points;
    for (int i = 0; i < 30; ++i) points.push_back({draw(random), draw(random)});
    std::int64_t most = 0;
    for (PlanPoint a : points)
      for (PlanPoint b : points) most = std::max(most, distance2(a, b));
    EXPECT_DOUBLE_EQ(diameter_m(convex_hull(points)), std::sqrt(static_cast<double>(most)) / 1000);
  }
}

}  // namespace
}  // namespace vicus
