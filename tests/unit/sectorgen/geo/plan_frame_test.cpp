#include "sectorgen/geo/plan_frame.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <cmath>
#include <random>

namespace vicus::test {
namespace {

struct City {
  const char* name;
  LatLon origin;
};

/// Straight through the earth, so it shares nothing with the projection.
double distance_m(LatLon a, LatLon b) {
  const auto& earth = GeographicLib::Geocentric::WGS84();
  double ax, ay, az, bx, by, bz;
  earth.Forward(a.lat_deg, a.lon_deg, 0, ax, ay, az);
  earth.Forward(b.lat_deg, b.lon_deg, 0, bx, by, bz);
  return std::sqrt((ax - bx) * (ax - bx) + (ay - by) * (ay - by) + (az - bz) * (az - bz));
}

class PlanFrameIn : public testing::TestWithParam<City> {};

TEST_P(PlanFrameIn, ComesBackWithinAMillimetreAnywhereInACityOf100Km) {
  const PlanFrame frame(GetParam().origin);
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int32_t> at(-50'000'000, 50'000'000);
  double worst = 0;
  for (int i = 0; i < 20'000; ++i) {
    const PlanPoint point{at(random), at(random)};
    const LatLon position = frame.latlon_from_plan(point);
    ASSERT_EQ(frame.plan_from_latlon(position), point);
    // A position between lattice points, half a lattice step aside.
    const double off_deg = 0.4e-3 / 111'132;
    const LatLon moved{position.lat_deg + off_deg, position.lon_deg};
    const auto lattice = frame.plan_from_latlon(moved);
    ASSERT_TRUE(lattice);
    worst = std::max(worst, distance_m(frame.latlon_from_plan(*lattice), moved));
  }
  EXPECT_LE(worst, 1e-3);
}

TEST_P(PlanFrameIn, KeepsLengthsNearTheOrigin) {
  const PlanFrame frame(GetParam().origin);
  const LatLon a = frame.latlon_from_plan({0, 0}), b = frame.latlon_from_plan({300'000, 400'000});
  EXPECT_NEAR(distance_m(a, b), 500, 1e-3);
}

TEST_P(PlanFrameIn, HasEastRightAndNorthUp) {
  const LatLon origin = GetParam().origin;
  const PlanFrame frame(origin);
  const auto north = frame.plan_from_latlon({origin.lat_deg + 0.001, origin.lon_deg});
  const auto east = frame.plan_from_latlon({origin.lat_deg, origin.lon_deg + 0.001});
  ASSERT_TRUE(north && east);
  EXPECT_EQ(north->x, 0);
  EXPECT_GT(north->y, 100'000);
  EXPECT_GT(east->x, 0);
  EXPECT_LT(std::abs(east->y), 1000);
}

INSTANTIATE_TEST_SUITE_P(Cities, PlanFrameIn,
                         testing::Values(City{"Paris", {48.87, 2.35}}, City{"Quito", {-0.2, -78.5}},
                                         City{"DateLine", {-16.8, 179.99}}, City{"DateLineWest", {-16.8, -179.99}},
                                         City{"FarNorth", {85, 20}}, City{"FarSouth", {-85, -120}}),
                         [](const auto& info) { return info.param.name; });

TEST(PlanFrame, JoinsBothSidesOfTheDateLine) {
  const PlanFrame frame({-16.8, 179.999});
  const auto west = frame.plan_from_latlon({-16.8, 179.998}), east = frame.plan_from_latlon({-16.8, -179.999});
  ASSERT_TRUE(west && east);
  EXPECT_NEAR(metres(east->x - west->x), 3 * 106.6, 1);
}

TEST(PlanFrame, RefusesWhatTheLatticeDoesNotReach) {
  const PlanFrame frame({48.87, 2.35});
  EXPECT_TRUE(frame.plan_from_latlon({48.87, 12}));
  EXPECT_FALSE(frame.plan_from_latlon({48.87, 20}));
  EXPECT_FALSE(frame.plan_from_latlon({-48.87, 2.35}));
  EXPECT_FALSE(frame.plan_from_latlon({48.87, -177}));
  EXPECT_FALSE(frame.plan_from_latlon({std::nan(""), 2}));
  EXPECT_FALSE(frame.plan_from_latlon({48, std::nan("")}));
  EXPECT_FALSE(frame.plan_from_latlon({91, 2}));
}

}  // namespace
}  // namespace vicus::test
