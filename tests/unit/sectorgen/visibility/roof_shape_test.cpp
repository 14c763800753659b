#include "sectorgen/visibility/roof_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sectorgen/visibility/house_walls.hpp"
#include "sectorgen/visibility/over_roofs.hpp"

namespace vicus::test {
namespace {

RoofPoint at(std::int32_t x, std::int32_t y, double up_m) {
  return {{x, y}, static_cast<std::int32_t>(std::lround(up_m * kRoofStepsPerMetre))};
}

/// A gabled house of 100 x 12 m at y0, its ridge along x.
Building gabled(std::int32_t y0, double eave_m, double ridge_m) {
  Building b;
  b.id = "gabled";
  b.footprint.outer = {{0, y0}, {100'000, y0}, {100'000, y0 + 12'000}, {0, y0 + 12'000}};
  b.eave_m = eave_m;
  b.height_m = ridge_m;
  b.roof.points = {at(0, y0, eave_m),          at(100'000, y0, eave_m),    at(100'000, y0 + 12'000, eave_m),
                   at(0, y0 + 12'000, eave_m), at(0, y0 + 6'000, ridge_m), at(100'000, y0 + 6'000, ridge_m)};
  b.roof.facets = {{FacetKind::slope, {{0, 1, 5, 4}}, {0, 1, 5, 0, 5, 4}},
                   {FacetKind::slope, {{2, 3, 4, 5}}, {2, 3, 4, 2, 4, 5}},
                   {FacetKind::gable, {{1, 2, 5}}, {1, 2, 5}},
                   {FacetKind::gable, {{3, 0, 4}}, {3, 0, 4}}};
  return b;
}

/// The street south of the first house, the yard between the two; each house 12 m deep. The yard owns the second.
City two_gabled_rows(double first_ridge_m, double second_eave_m, double second_ridge_m) {
  City city;
  for (const auto& [id, ring] :
       {std::pair<std::string, Ring>{"street", {{0, 0}, {100'000, 0}, {100'000, 10'000}, {0, 10'000}}},
        {"yard", {{0, 22'000}, {100'000, 22'000}, {100'000, 42'000}, {0, 42'000}}}}) {
    Sector sector;
    sector.id = id;
    sector.ground.outer = ring;
    city.sectors.push_back(std::move(sector));
  }
  city.buildings = {gabled(10'000, 8, first_ridge_m), gabled(42'000, second_eave_m, second_ridge_m)};
  city.buildings[1].id = "second";
  for (auto& b : city.buildings) b.sector_id = "yard";
  // No way round the first row.
  for (auto* corner : {&city.buildings[0].footprint.outer[0], &city.buildings[0].footprint.outer[3]})
    corner->x = -300'000;
  for (auto* corner : {&city.buildings[0].footprint.outer[1], &city.buildings[0].footprint.outer[2]})
    corner->x = 400'000;
  for (auto& p : city.buildings[0].roof.points) p.at.x = p.at.x == 0 ? -300'000 : 400'000;
  return city;
}

bool street_lists_second(const City& city, bool* is_proven = nullptr) {
  SightLists level;
  level.visible = {{0}, {1}};
  level.houses.resize(2);
  RoofOptions patient;
  patient.most_pairs = 1'000'000;
  const RoofLists lists = sights_over_roofs(city, level, patient);
  for (const RoofSight& s : lists.visible[0])
    if (s.house == 1) {
      if (is_proven != nullptr) *is_proven = s.is_proven;
      return true;
    }
  return false;
}

// Eyes at 2 m, 10 m south of the first eave (8 m), 16 m of its ridge: over the ridge at 16 m a line rises by 14 / 16,
// so it is 44 m high 48 m off, at the second ridge.
TEST(SightsOverRoofs, AreStoppedByTheRidgeAndReachTheRidge) {
  EXPECT_FALSE(street_lists_second(two_gabled_rows(16, 30, 40)));
  EXPECT_TRUE(street_lists_second(two_gabled_rows(8.5, 30, 40))) << "a low roof before it leaves the view free";
  bool is_proven = false;
  EXPECT_TRUE(street_lists_second(two_gabled_rows(16, 30, 46), &is_proven)) << "its ridge rises above the line";
  EXPECT_TRUE(is_proven);
}

TEST(RoofTriangles, AreNeverHigherThanAnyPlaceWithinReach) {
  std::mt19937_64 random(1);
  const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  int near = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto corner = [&](std::int32_t x, std::int32_t y) {
      return at(x + static_cast<std::int32_t>(4000 * share()), y + static_cast<std::int32_t>(4000 * share()),
                5 + 10 * share());
    };
    const RoofPoint a = corner(0, 0), b = corner(8000, 0), c = corner(4000, 8000);
    const RoofTriangle triangle(a, b, c);
    const Spot x{-2 + 14 * share(), -2 + 14 * share()};
    const double reach = 3 * share(), least = triangle.least_within(x, reach);
    for (int k = 0; k < 60; ++k) {
      double u = share(), v = share();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const auto mix = [&](double p, double q, double r) { return p + u * (q - p) + v * (r - p); };
      const Spot spot{mix(metres(a.at.x), metres(b.at.x), metres(c.at.x)),
                      mix(metres(a.at.y), metres(b.at.y), metres(c.at.y))};
      if (std::hypot(spot.x - x.x, spot.y - x.y) > reach) continue;
      ++near;
      ASSERT_LE(least, mix(a.up, b.up, c.up) / kRoofStepsPerMetre + 1e-5);
    }
  }
  EXPECT_GT(near, 5000);
}

TEST(RoofTriangles, AreLeftOutWhereTheyDoNotFitTheHouse) {
  EXPECT_EQ(roof_triangles(gabled(0, 8, 12)).size(), 4u);
  Building lifted = gabled(0, 8, 12);
  lifted.eave_m = lifted.height_m = 45;
  EXPECT_TRUE(roof_triangles(lifted).empty()) << "the roof was not lifted with the walls";
  Building holed = gabled(0, 8, 12);
  holed.roof.facets.erase(holed.roof.facets.begin());
  EXPECT_TRUE(roof_triangles(holed).empty()) << "half of the house has no roof";
}

TEST(RoofEdges, AtTheEaveCountForEyesAboveItOnly) {
  const Building b = gabled(0, 8, 12);
  EXPECT_EQ(roof_edges(b, true, true).size(), 9u);
  const auto high = roof_edges(b, true, false);
  EXPECT_EQ(high.size(), 5u) << "the ridge and four verges";
  for (const RoofEdge& e : high) EXPECT_EQ(std::max(e.up_a, e.up_b), 12);
}

/// A house's roof is roofed as high as it is, not more.
TEST(HouseWalls, CallADiscRoofedBelowASlope) {
  City city;
  city.buildings.push_back(gabled(0, 8, 14));
  const HouseWalls walls(city);
  for (const double reach : {0.5, 1.0, 2.0}) {
    const double least = 14 - reach - 0.01;  // the slope is 1
    EXPECT_TRUE(walls.is_roofed({50, 6}, reach, 0, least));
    EXPECT_FALSE(walls.is_roofed({50, 6}, reach, 0, least + 0.02));
  }
  EXPECT_FALSE(walls.is_clear({50, -10}, 2, {50, 22}, 26)) << "13.5 m high over the ridge, 0.5 m below it";
  EXPECT_TRUE(walls.is_clear({50, -10}, 2, {50, 22}, 27));
}

}  // namespace
}  // namespace vicus::test
