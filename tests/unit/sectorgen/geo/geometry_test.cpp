#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sectorgen/geo/box_pairs.hpp"
#include "sectorgen/geo/neighbours.hpp"
#include "sectorgen/geo/repair.hpp"
#include "sectorgen/geo/ring_check.hpp"
#include "sectorgen/geo/shared_area.hpp"
#include "tests/support/map_checks.hpp"

namespace vicus::test {
namespace {

using Random = std::mt19937_64;

std::int32_t between(Random& random, std::int32_t low, std::int32_t high) {
  return std::uniform_int_distribution<std::int32_t>(low, high)(random);
}

/// Points anywhere in a small square: crossing, touching and repeated ones are common.
Ring random_ring(Random& random, std::int32_t side) {
  Ring ring(static_cast<std::size_t>(between(random, 1, 8)));
  for (PlanPoint& p : ring) p = {between(random, 0, side), between(random, 0, side)};
  return ring;
}

/// Star-shaped, hence simple unless rounding spoils it.
Polygon random_star(Random& random, PlanPoint centre, double radius_mm) {
  const int corners = between(random, 3, 12);
  Polygon star;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / corners,
                 r = radius_mm * (0.3 + 0.7 * between(random, 0, 1000) / 1000);
    star.outer.push_back({centre.x + static_cast<std::int32_t>(r * std::cos(angle)),
                          centre.y + static_cast<std::int32_t>(r * std::sin(angle))});
  }
  return star;
}

TEST(StrictlySimple, ImpliesGeosValidAndOnlyTouchesMakeTheDifference) {
  int simple = 0, valid = 0;
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Polygon polygon{without_repeats(random_ring(random, 12)), {}};
    if (seed % 2) polygon.holes.push_back(without_repeats(random_ring(random, 12)));
    Polygon oriented = polygon;
    orient_rings(oriented);
    const bool is_simple = is_strictly_simple(polygon);
    EXPECT_TRUE(!is_simple || is_valid_by_geos(oriented));
    // A ring alone has no other ring to touch: there both agree.
    EXPECT_TRUE(!polygon.holes.empty() || is_simple == is_valid_by_geos(oriented));
    simple += is_simple;
    valid += is_valid_by_geos(oriented);
  }
  EXPECT_GT(simple, 500);
  EXPECT_GE(valid, simple);
}

TEST(Repair, WhateverComesOutIsValidAndNotLarger) {
  int repaired = 0;
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    // Alternately on a lattice so coarse that rounding hurts, and at the lattice's far end.
    const std::int32_t side = seed % 2 ? 10 : 2'000'000;
    std::vector<Ring> rings;
    for (int i = 0; i < 1 + static_cast<int>(seed % 3); ++i) rings.push_back(random_ring(random, side));
    const Repaired result = repaired_polygons(rings);
    PlanBox box;
    for (PlanPoint p : rings[0]) box.add(p);
    for (const Polygon& polygon : result.polygons) {
      EXPECT_TRUE(is_valid_by_geos(polygon));
      for (PlanPoint p : polygon.outer) EXPECT_TRUE(box.contains(p));
    }
    repaired += result.fault && !result.polygons.empty();
  }
  EXPECT_GT(repaired, 500);
}

TEST(Repair, LeavesValidRingsAsTheyAre) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Polygon star = random_star(random, {between(random, -1'000'000'000, 1'000'000'000), 0}, 20'000);
    const Repaired result = repaired_polygons({star.outer});
    ASSERT_EQ(result.polygons.size(), 1u);
    EXPECT_FALSE(result.fault);
    EXPECT_EQ(result.polygons[0].outer, star.outer);
  }
}

TEST(Repair, NamesTheFault) {
  const Ring square = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const auto code_of = [](const std::vector<Ring>& rings) { return repaired_polygons(rings).fault->code; };
  EXPECT_EQ(code_of({{{0, 0}, {9, 9}, {9, 0}, {0, 9}}}), IssueCode::ring_self_intersection);
  EXPECT_EQ(code_of({{{0, 0}, {9, 9}, {0, 0}}}), IssueCode::ring_too_few_points);
  EXPECT_EQ(code_of({square, {{20, 0}, {22, 0}, {22, 2}}}), IssueCode::hole_outside);
  EXPECT_FALSE(repaired_polygons({square, {{3, 3}, {3, 6}, {6, 6}}}).fault);
  // A hole that touches the outline in one point is valid.
  EXPECT_FALSE(repaired_polygons({square, {{0, 4}, {3, 6}, {3, 3}}}).fault);
}

TEST(SharedArea, IsThatOfTheIntersection) {
  double worst = 0;
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Polygon a = random_star(random, {0, 0}, 30'000);
    const Polygon b = random_star(random, {between(random, -40'000, 40'000), between(random, -40'000, 40'000)}, 20'000);
    if (seed % 4 == 0) {
      Polygon hole = random_star(random, {0, 0}, 5'000);
      std::reverse(hole.outer.begin(), hole.outer.end());
      a.holes.push_back(hole.outer);
      if (!is_valid_by_geos(a)) continue;
    }
    const double shared = shared_area_m2(a, b);
    EXPECT_NEAR(shared, shared_area_m2(b, a), 1e-6);
    worst = std::max(worst, std::abs(shared - shared_area_by_geos_m2(a, b)));
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(BoxPairs, AreThoseOfBruteForce) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<PlanBox> boxes(40), others(30);
    for (auto* list : {&boxes, &others})
      for (PlanBox& box : *list) {
        if (between(random, 0, 9) == 0) continue;  // empty
        box.add({between(random, 0, 300), between(random, 0, 300)});
        box.add({box.min.x + between(random, 0, 40), box.min.y + between(random, 0, 40)});
      }
    const auto meet = [](const PlanBox& a, const PlanBox& b, std::int32_t margin) {
      return !a.is_empty() && !b.is_empty() && a.min.x - margin <= b.max.x && b.min.x - margin <= a.max.x &&
             a.min.y - margin <= b.max.y && b.min.y - margin <= a.max.y;
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> within, across;
    for (std::uint32_t j = 0; j < boxes.size(); ++j)
      for (std::uint32_t i = 0; i < j; ++i)
        if (meet(boxes[i], boxes[j], 5)) within.emplace_back(i, j);
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      for (std::uint32_t j = 0; j < others.size(); ++j)
        if (meet(boxes[i], others[j], 0)) across.emplace_back(i, j);
    EXPECT_EQ(box_pairs(boxes, 5), within);
    EXPECT_EQ(box_pairs(boxes, others), across);
  }
}

Footprint house(const Ring& ring) {
  Footprint footprint;
  footprint.source_id = "way/1";
  footprint.area.outer = ring;
  footprint.height_m = footprint.eave_m = 9;
  return footprint;
}

TEST(CloseGaps, MovesNothingByMoreThanItSaysAndKeepsEveryHouseValid) {
  int closed = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    // Three houses in a row on a slope, a random gap of up to 15 cm between them, corners at random heights.
    std::vector<Footprint> houses;
    std::int32_t east = 0;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t width = between(random, 200, 12'000), low = between(random, -200, 200);
      const std::int32_t lean = between(random, -150, 150);
      houses.push_back(
          house({{east, low}, {east + width, low}, {east + width + lean, 9'000}, {east + lean, 9'000 + low}}));
      east += width + between(random, -20, 150);
    }
    const std::vector<Footprint> before = houses;
    std::vector<Issue> issues;
    close_gaps(houses, issues);
    for (std::size_t i = 0; i < houses.size(); ++i) {
      EXPECT_TRUE(is_valid_by_geos(houses[i].area));
      // Every vertex there was is still within reach of one that is.
      for (PlanPoint p : before[i].area.outer) {
        double nearest = 1e9;
        for (PlanPoint q : houses[i].area.outer) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
        EXPECT_LE(nearest, 101);
      }
      closed += houses[i].area.outer != before[i].area.outer;
    }
    EXPECT_EQ(houses[0].area.outer, before[0].area.outer);
  }
  EXPECT_GT(closed, 500);
}

TEST(CloseGaps, LeavesHousesThatTouchAlready) {
  std::vector<Footprint> houses = {house({{0, 0}, {9000, 0}, {9000, 9000}, {0, 9000}}),
                                   house({{9000, 0}, {18000, 0}, {18000, 9000}, {9000, 9000}})};
  const std::vector<Footprint> before = houses;
  std::vector<Issue> issues;
  close_gaps(houses, issues);
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(houses[1].area.outer, before[1].area.outer);
}

}  // namespace
}  // namespace vicus::test
