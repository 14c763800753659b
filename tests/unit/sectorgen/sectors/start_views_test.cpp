#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sectorgen/geom/polygon.hpp"
#include "tests/support/built_city.hpp"
#include "tests/unit/sectorgen/sectors/drawn_map.hpp"

/// Where visitors start.
namespace vicus::test {
namespace {

const Viewpoint& view_of(const City& city, const Sector& sector) {
  return *std::find_if(city.viewpoints.begin(), city.viewpoints.end(),
                       [&](const Viewpoint& v) { return v.sector_id == sector.id && v.kind == "start"; });
}

/// m to the next house that bounds ground, by brute force over all of them.
double to_the_next_house(const City& city, const Viewpoint& v) {
  const double turn = v.heading_deg * std::numbers::pi / 180, east = std::sin(turn), north = std::cos(turn);
  const auto side = [&](PlanPoint p) { return east * (double(p.y) - v.at.y) - north * (double(p.x) - v.at.x); };
  double least = 1e9;
  for (const Building& house : city.buildings) {
    const Ring& ring = house.footprint.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      const double of_a = side(a), of_b = side(b);
      if ((of_a < 0) == (of_b < 0)) continue;
      const double share = of_a / (of_a - of_b);
      const double mm =
          east * (a.x + share * (double(b.x) - a.x) - v.at.x) + north * (a.y + share * (double(b.y) - a.y) - v.at.y);
      if (mm > 0) least = std::min(least, mm / 1000);
    }
  }
  return least;
}

TEST(StartViews, LookAlongTheStreetAndIntoTheCity) {
  const City city = built(one_street());
  ASSERT_EQ(city.sectors.size(), 2u);
  for (const Sector& s : city.sectors) {
    const Viewpoint& v = view_of(city, s);
    EXPECT_NEAR(v.heading_deg, s.origin.x < lattice_mm(100) ? 90 : 270, 0.1) << "the other half lies there";
    EXPECT_NEAR(metres(v.at.y), 0, 0.5) << "on the axis";
    EXPECT_NEAR(metres(v.at.x - s.origin.x), 0, 20) << "near its middle";
  }
}

TEST(StartViews, StandOnTheirGroundAndSeldomBeforeAWall) {
  std::size_t all = 0, blind = 0;
  for (const std::uint64_t seed : seeds(4100, 12)) {
    const City city = random_town_city(seed);
    for (const Sector& s : city.sectors) {
      const Viewpoint& v = view_of(city, s);
      EXPECT_EQ(locate(s.ground, v.at), Side::inside) << "seed " << seed << " " << s.id;
      EXPECT_TRUE(v.heading_deg >= 0 && v.heading_deg < 360) << v.heading_deg;
      if (area_m2(s.ground) < 100) continue;
      ++all;
      blind += to_the_next_house(city, v) < 6;
    }
  }
  std::printf("%zu of %zu sectors of 100 m2 and more begin less than 6 m from a house ahead\n", blind, all);
  EXPECT_LT(blind * 50, all);
}

}  // namespace
}  // namespace vicus::test
