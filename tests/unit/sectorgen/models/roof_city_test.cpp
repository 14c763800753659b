#include "sectorgen/models/roof_city.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sectorgen/models/solid_check.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/unit/sectorgen/models/roof_plans.hpp"

/// Roofs of a city: where shapes and heights come from, and what follows for walls.
namespace vicus::test {
namespace {

/// A house of 12 x 8 m whose lower left corner is at (x, 0).
Building house(double x, double height_m, Tags tags) {
  Building b;
  b.id = "b" + std::to_string(static_cast<int>(x));
  b.source_id = b.id;
  b.footprint.outer = ring_of({{x, 0}, {x + 12, 0}, {x + 12, 8}, {x, 8}});
  b.height_m = b.eave_m = height_m;
  b.tags = std::move(tags);
  return b;
}

Building roofed(double height_m, Tags tags, HeightSource source = HeightSource::measured) {
  City city;
  city.buildings.push_back(house(0, height_m, std::move(tags)));
  city.buildings[0].height_source = source;
  roof_houses(city);
  return city.buildings[0];
}

TEST(RoofHouses, TakesTheRiseOffATotalHeight) {
  const Building b = roofed(10, {{"roof:shape", "gabled"}, {"roof:height", "3"}});
  EXPECT_EQ(b.roof_shape, "gabled");
  EXPECT_EQ(b.roof_source, RoofSource::tagged);
  EXPECT_NEAR(b.height_m, 10, 1e-3);
  EXPECT_NEAR(b.eave_m, 7, 2e-3);
}

TEST(RoofHouses, PutsTheRoofOnTopOfLevels) {
  const Building b = roofed(9, {{"roof:shape", "hipped"}}, HeightSource::levels);
  EXPECT_NEAR(b.eave_m, 9, 1e-3);
  EXPECT_GT(b.height_m, 11);
}

TEST(RoofHouses, GuessesByRuleAndByNeighbours) {
  EXPECT_EQ(roofed(8, {}).roof_shape, "gabled");
  EXPECT_EQ(roofed(8, {}).roof_source, RoofSource::rule);
  EXPECT_EQ(roofed(20, {}).roof_shape, "flat");
  City city;
  for (int i = 0; i < 5; ++i)
    city.buildings.push_back(house(20 * i, 8, {{"roof:shape", i == 4 ? "gabled" : "hipped"}}));
  city.buildings.push_back(house(100, 8, {}));
  roof_houses(city);
  EXPECT_EQ(city.buildings[5].roof_shape, "hipped");
  EXPECT_EQ(city.buildings[5].roof_source, RoofSource::neighbours);
}

TEST(RoofHouses, GivesParisItsMansards) {
  City city;
  city.origin = {48.88, 2.34};
  city.buildings.push_back(house(0, 20, {}));
  roof_houses(city);
  EXPECT_EQ(city.buildings[0].roof_shape, "mansard");
  EXPECT_EQ(city.buildings[0].roof_source, RoofSource::preset);
}

TEST(RoofHouses, LetsSideWallsFollowTheEaves) {
  City city;
  city.buildings = {house(0, 10, {{"roof:shape", "flat"}}),
                    house(12, 10, {{"roof:shape", "hipped"}, {"roof:height", "3"}})};
  roof_houses(city);
  ASSERT_EQ(city.buildings[0].side_walls.size(), 1u) << "3 m of its wall stand over the neighbour's eave";
  EXPECT_NEAR(city.buildings[0].side_walls[0].bottom_m, city.buildings[1].eave_m, 1e-9);
  EXPECT_TRUE(city.buildings[1].side_walls.empty());
}

/// A row of houses on a slope: at each height above the ground a party wall is either between two houses, or drawn.
TEST(UpdateSideWalls, LeaveNoHoleBetweenHousesAtDifferentLevels) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    City city;
    for (int i = 0; i < 6; ++i) {
      Building b = house(12 * i, 10, {});
      b.eave_m = b.height_m = pick(3, 15);
      b.ground_m = pick(0, 20);
      b.foot_m = pick(0, 4);
      city.buildings.push_back(b);
    }
    update_side_walls(city);
    for (std::size_t i = 0; i < city.buildings.size(); ++i)
      for (const int side : {-1, 1}) {
        const std::size_t k = i + static_cast<std::size_t>(side);
        if (k >= city.buildings.size()) continue;
        const Building &b = city.buildings[i], &other = city.buildings[k];
        const std::int32_t x = lattice_mm(12.0 * static_cast<double>(std::max(i, k)));
        for (int sample = 0; sample < 20; ++sample) {
          const double z = pick(std::max(b.ground_m - b.foot_m, other.ground_m - other.foot_m), b.ground_m + b.eave_m);
          if (z > b.ground_m + b.eave_m) continue;  // all of it below the other's foot
          const bool is_covered = z <= other.ground_m + other.eave_m + 0.06;
          const bool is_drawn = std::any_of(b.side_walls.begin(), b.side_walls.end(), [&](const SideWall& w) {
            return w.a.x == x && w.b.x == x && b.ground_m + w.bottom_m <= z;
          });
          EXPECT_TRUE(is_covered || is_drawn) << "seed " << seed << ", house " << i << " towards " << k;
          EXPECT_FALSE(is_drawn && z < other.ground_m + other.eave_m - 1e-9) << "seed " << seed;
        }
      }
  }
}

TEST(RoofHouses, LeavesEveryHouseOfTheSampleCitySound) {
  City city = sample_city();
  roof_houses(city);
  for (const auto& b : city.buildings) {
    EXPECT_EQ(fault_of_roof(b.footprint, b.eave_m, b.roof).value_or("none"), "none") << b.id;
    EXPECT_LE(b.base_m, b.eave_m);
    EXPECT_LE(b.eave_m, b.height_m);
  }
}

}  // namespace
}  // namespace vicus::test
