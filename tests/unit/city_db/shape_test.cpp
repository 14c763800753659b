#include "city_db/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "city_db/shape_ground.hpp"
#include "tests/support/sample_city.hpp"

namespace vicus {
namespace {

PlanPlace metres_at(double east, double north) { return {east * kMmPerMetre, north * kMmPerMetre}; }

TEST(Spread, InterpolatesBetweenRanks) {
  const auto s = spread_of({4, 1, 3, 2, 5});
  EXPECT_DOUBLE_EQ(s.median, 3);
  EXPECT_DOUBLE_EQ(s.p05, 1.2);
  EXPECT_DOUBLE_EQ(s.p95, 4.8);
  EXPECT_DOUBLE_EQ(s.mean, 3);
  EXPECT_EQ(spread_of({}).count, 0u);
  EXPECT_DOUBLE_EQ(spread_of({7}).p95, 7);
}

TEST(GroundMap, FindsTheSectorOfAPlace) {
  const City city = test::sample_city();
  const GroundMap ground(city);
  const auto id_at = [&](double east, double north) {
    const auto s = ground.sector_at(metres_at(east, north));
    return s == kNoSector ? std::string() : city.sectors[s].id;
  };
  EXPECT_EQ(id_at(0, 0), "s-cross");
  EXPECT_EQ(id_at(-59, 4), "s-main-w");
  EXPECT_EQ(id_at(26, 10), "s-passage");
  EXPECT_EQ(id_at(29, 0), "s-main-e");
  EXPECT_EQ(id_at(31, 0), "");   // island
  EXPECT_EQ(id_at(10, 10), "");  // house
  EXPECT_EQ(id_at(61, 0), "");   // out of the city
  EXPECT_EQ(id_at(0, 41), "");
}

TEST(GroundMap, MeasuresClearanceToWhatStopsAWalker) {
  const GroundMap ground(test::sample_city());
  EXPECT_NEAR(ground.clearance_mm(metres_at(0, 0)), std::hypot(5000, 5000), 1e-6);  // the gates do not stop
  EXPECT_NEAR(ground.clearance_mm(metres_at(15, 0)), 5000, 1e-6);
  EXPECT_NEAR(ground.clearance_mm(metres_at(29, 0)), 1000, 1e-6);  // the island
  EXPECT_NEAR(ground.clearance_mm(metres_at(59, 0)), 5000, 1e-6);  // the end of the city does not stop
  EXPECT_NEAR(ground.clearance_mm(metres_at(26, 13)), 2000, 1e-6);
  EXPECT_NEAR(GroundMap(City{}).clearance_mm(metres_at(0, 0)), GroundMap::kFarMm, 1e-6);
}

TEST(Shape, MeasuresTheSampleCity) {
  const auto shape = measure_shape(test::sample_city());
  // Streets and crossroads: cross 4 gates, main-e 2 (cross, passage), main-w, north and south 1 each.
  EXPECT_EQ(shape.streets.gates_per_sector.count, 5u);
  EXPECT_DOUBLE_EQ(shape.streets.gates_per_sector.median, 1);
  EXPECT_DOUBLE_EQ(shape.streets.gates_per_sector.mean, 9.0 / 5);
  EXPECT_EQ(shape.all.gates_per_sector.count, 7u);
  EXPECT_DOUBLE_EQ(shape.all.gates_per_sector.mean, 12.0 / 7);
  // main-w's front bends inwards; main-e has an island of 6 m2 in 550 m2; the others are convex.
  EXPECT_DOUBLE_EQ(shape.all.convexity.median, 1);
  EXPECT_LT(shape.all.convexity.p05, 1 - 6.0 / 550 + 0.01);
  EXPECT_NEAR(shape.all.sector_length_m.p95, std::hypot(55, 10.0), 0.5);
  EXPECT_EQ(shape.gate_width_ratio.count, 6u);
  EXPECT_NEAR(shape.gate_width_ratio.median, 1, 1e-9);  // every gate runs from wall to wall
}

TEST(Shape, MeasuresWhatGatesAreTooWide) {
  City city = test::sample_city();
  // The crossroads and the main street in one; the gates to Kreuzgasse stay as wide as the street.
  for (auto& gate : city.gates)
    if (gate.kind == GateKind::passage) gate.kind = GateKind::yard;
  const auto shape = measure_shape(city);
  EXPECT_EQ(shape.gate_width_ratio.count, 4u);
  EXPECT_EQ(shape.yard_gate_width_ratio.count, 2u);
  EXPECT_EQ(shape.kerb_gate_width_ratio.count, 0u);
}

TEST(Shape, MeasuresNamedStreets) {
  City city = test::sample_city();
  const auto good = measure_shape(city).named_streets;
  // 120 m less the island's 3 m of the one street, 79.6 m of the other.
  EXPECT_NEAR(good.length_m, 117 + 79.6, 0.05);
  EXPECT_DOUBLE_EQ(good.share, 1);
  EXPECT_DOUBLE_EQ(good.share_all_names, 1);
  // The crossroads is called after the main street: 10 m of Kreuzgasse lie in a sector of another name.
  EXPECT_NEAR(good.share_strict, 1 - 10 / good.length_m, 1e-6);
  // The core: the crossroads, and the disc of 2 x 7.07 m round the crossing of the axes.
  EXPECT_NEAR(good.outside_cores_m, good.length_m - 4 * 2 * std::hypot(5, 5), 0.05);
  EXPECT_EQ(good.by_street.count, 2u);

  for (auto& sector : city.sectors)
    if (sector.id == "s-south") sector.name = "Elsewhere", sector.names = {"Elsewhere"};
  const auto bad = measure_shape(city).named_streets;
  const double lost = 39.6 - 2 * std::hypot(5, 5);
  EXPECT_NEAR(bad.share, 1 - lost / good.outside_cores_m, 1e-3);
  EXPECT_NEAR(bad.share_all_names, 1 - 34.6 / good.length_m, 1e-3);
}

TEST(Shape, OfAnEmptyCityIsNothing) {
  const auto shape = measure_shape(City{});
  EXPECT_EQ(shape.all.convexity.count, 0u);
  EXPECT_EQ(shape.named_streets.length_m, 0);
}

}  // namespace
}  // namespace vicus
