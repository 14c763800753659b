#include "httpd/geo_json.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/TransverseMercatorExact.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace vicus {
namespace {

const std::vector<LatLon> kOrigins = {{48.8837, 2.3444}, {-33.9, 18.4},  {0, 0},
                                      {51.5, -0.13},     {52, 179.9999}, {85, -170}};

PlanPoint random_point(std::mt19937& random, std::int32_t reach_mm) {
  std::uniform_int_distribution<std::int32_t> at(-reach_mm, reach_mm);
  return {at(random), at(random)};
}

TEST(GeoFrame, AgreesWithExactTransverseMercatorWithinAMillimetre) {
  const GeographicLib::TransverseMercatorExact exact(6378137.0, 1 / 298.257223563, 1.0);
  for (const auto origin : kOrigins) {
    const GeoFrame frame(origin);
    double x0 = 0, y0 = 0;
    exact.Forward(origin.lon_deg, origin.lat_deg, origin.lon_deg, x0, y0);
    for (unsigned seed = 0; seed < 200; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const auto p = random_point(random, 50'000'000);
      const auto at = frame.lat_lon_from_plan(p);
      double x = 0, y = 0;
      exact.Forward(origin.lon_deg, at.lat_deg, at.lon_deg, x, y);
      EXPECT_NEAR(x, metres(p.x), 1e-3);
      EXPECT_NEAR(y - y0, metres(p.y), 1e-3);
      EXPECT_LE(std::abs(at.lon_deg - origin.lon_deg), 180);
    }
  }
}

TEST(GeoFrame, WrittenDecimalsKeepTheLattice) {
  const GeoFrame frame({48.8837, 2.3444});
  const auto json = frame.geometry_of(std::vector<PlanPoint>{{123456, -654321}, {1, 2}});
  EXPECT_EQ(json["type"], "LineString");
  const auto at = frame.lat_lon_from_plan({123456, -654321});
  EXPECT_NEAR(json["coordinates"][0][0].get<double>(), at.lon_deg, 6e-10);  // 0.07 mm
  EXPECT_NEAR(json["coordinates"][0][1].get<double>(), at.lat_deg, 6e-10);
}

TEST(GeoFrame, ClosesRings) {
  const auto json =
      GeoFrame({48, 2}).geometry_of(Polygon{{{0, 0}, {9000, 0}, {9000, 9000}}, {{{2, 1}, {5, 3}, {5, 1}}}});
  EXPECT_EQ(json["type"], "Polygon");
  ASSERT_EQ(json["coordinates"].size(), 2u);
  for (const auto& ring : json["coordinates"]) {
    EXPECT_EQ(ring.size(), 4u);
    EXPECT_EQ(ring.front(), ring.back());
  }
}

TEST(ParseGeoBox, TakesFourOrSixNumbers) {
  const auto box = parse_geo_box("2.3,48.8,2.4,48.9");
  ASSERT_TRUE(box);
  EXPECT_EQ(box->west, 2.3);
  EXPECT_EQ(box->north, 48.9);
  const auto high = parse_geo_box("-1,-2,0,1e0,2,300");
  ASSERT_TRUE(high);
  EXPECT_EQ(high->east, 1);
  EXPECT_EQ(high->north, 2);
  for (const char* text : {"", "1", "1,2,3", "1,2,3,4,5", "1,2,3,4,5,6,7", "1,2,3,4,", ",1,2,3", "a,2,3,4", "nan,2,3,4",
                           "1,2,inf,4", "1,2,3,91", "181,2,3,4", "1,5,3,4", "1, 2,3,4", "1,2,3,4 "})
    EXPECT_FALSE(parse_geo_box(text)) << text;
}

GeoBox random_box(std::mt19937& random, LatLon origin) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const double reach = std::pow(10.0, unit(random) * 3);
  const auto wrap = [](double lon) { return std::remainder(lon, 360.0); };
  const auto clamp = [](double lat) { return std::min(90.0, std::max(-90.0, lat)); };
  const double lon = origin.lon_deg + unit(random) * reach, lat = origin.lat_deg + unit(random) * reach;
  return {wrap(lon), clamp(lat), wrap(lon + std::abs(unit(random)) * std::min(reach, 100.0)),
          clamp(lat + std::abs(unit(random)) * reach)};
}

TEST(PlanBoxAround, HoldsEveryPointThatMeetsTheBox) {
  int met = 0;
  for (const auto origin : kOrigins) {
    const GeoFrame frame(origin);
    for (unsigned seed = 0; seed < 2000; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 random(seed);
      const auto box = random_box(random, origin);
      const auto p = random_point(random, 50'000'000);
      if (!frame.meets(std::vector<PlanPoint>{p, p}, box)) continue;
      ++met;
      EXPECT_TRUE(frame.plan_box_around(box).contains(p)) << p.x << ' ' << p.y;
    }
  }
  EXPECT_GT(met, 200);
}

TEST(PlanBoxAround, IsEmptyFarAwayAndWholeForTheWorld) {
  for (const auto origin : kOrigins) {
    const GeoFrame frame(origin);
    const double away = std::remainder(origin.lon_deg + 180, 360.0);
    EXPECT_TRUE(frame.plan_box_around({away, -10, away, 10}).is_empty());
    const auto world = frame.plan_box_around({-180, -90, 180, 90});
    EXPECT_TRUE(world.contains({50'000'000, 50'000'000}) && world.contains({-50'000'000, -50'000'000}));
  }
}

TEST(GeoFrameMeets, KnowsTouchingInsideHolesAndAround) {
  const LatLon origin{48, 2};
  const GeoFrame frame(origin);
  const Polygon square{{{-10000, -10000}, {10000, -10000}, {10000, 10000}, {-10000, 10000}},
                       {{{-5000, -5000}, {-5000, 5000}, {5000, 5000}, {5000, -5000}}}};
  const auto box_of = [&](double x0, double y0, double x1, double y1) {
    const auto a = frame.lat_lon_from_plan({lattice_mm(x0), lattice_mm(y0)});
    const auto b = frame.lat_lon_from_plan({lattice_mm(x1), lattice_mm(y1)});
    return GeoBox{a.lon_deg, a.lat_deg, b.lon_deg, b.lat_deg};
  };
  EXPECT_TRUE(frame.meets(square, box_of(6, 6, 7, 7)));         // in the ground
  EXPECT_FALSE(frame.meets(square, box_of(-1, -1, 1, 1)));      // in the hole
  EXPECT_TRUE(frame.meets(square, box_of(-1, -1, 6, 1)));       // over the hole's edge
  EXPECT_TRUE(frame.meets(square, box_of(-20, -20, 20, 20)));   // around
  EXPECT_TRUE(frame.meets(square, box_of(-20, -1, 20, 1)));     // across
  EXPECT_FALSE(frame.meets(square, box_of(10.01, -1, 20, 1)));  // beside
  EXPECT_TRUE(frame.meets(std::vector<PlanPoint>{{-10000, 0}, {10000, 0}}, box_of(-1, -1, 1, 1)));
  EXPECT_FALSE(frame.meets(std::vector<PlanPoint>{{-10000, -9000}, {9000, 10000}}, box_of(0, -9, 9, -1)));
}

TEST(GeoFrameMeets, SeesOverTheAntimeridian) {
  const GeoFrame frame({52, 179.9999});
  const Polygon square{{{-50000, -50000}, {50000, -50000}, {50000, 50000}, {-50000, 50000}}, {}};
  EXPECT_TRUE(frame.meets(square, {179, 51, -179, 53}));
  EXPECT_TRUE(frame.meets(square, {-180, 51, -179, 53}));
  EXPECT_TRUE(frame.meets(square, {179, 51, 180, 53}));
  EXPECT_FALSE(frame.meets(square, {-179, 51, 179, 53}));
}

}  // namespace
}  // namespace vicus
