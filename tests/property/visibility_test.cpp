#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sectorgen/town/town.hpp"
#include "sectorgen/visibility/visible.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/sight_rays.hpp"

/// L_vis of random towns and real cities: nothing that a ray sees is missing (docs/visibility.md has the long runs).
namespace vicus::test {
namespace {

void expect_nothing_missing(City city, std::uint64_t rays, std::uint64_t seed) {
  list_visible(city, {});
  const RayReport report = shoot_rays(city, rays, seed);
  EXPECT_GT(report.pairs_seen, city.sectors.size());
  EXPECT_EQ(report.missing.size(), 0u) << "of " << report.pairs_seen << " pairs seen by " << report.rays << " rays";
  for (std::size_t i = 0; i < std::min<std::size_t>(5, report.missing.size()); ++i) ADD_FAILURE() << report.missing[i];
}

TEST(Visibility, MissesNothingThatARaySeesInRandomTowns) {
  for (const std::uint64_t seed : seeds(1, 40)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_nothing_missing(random_town_city(seed), 200'000, seed);
  }
}

TEST(Visibility, MissesNothingThatARaySeesInTownsWithTowers) {
  for (const std::uint64_t seed : seeds(1, 6)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    City city = random_town_city(seed);
    for (std::size_t i = 0; i < city.buildings.size(); i += 11)
      city.buildings[i].height_m = city.buildings[i].eave_m = 45;
    expect_nothing_missing(std::move(city), 400'000, seed);
  }
}

TEST(Visibility, MissesNothingThatARaySeesInTownsOnSlopes) {
  for (const std::uint64_t seed : seeds(1, 4)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    City city = random_town_city(seed);
    PlanBox box;
    for (const auto& s : city.sectors)
      for (const PlanPoint p : s.ground.outer) box.add(p);
    // A hill beside a slope, up to some 60 m, twice as steep above low houses: over those one sees streets. Nodes every
    // 10 m.
    constexpr std::int32_t kStep_mm = 10'000;
    constexpr double kLow_m = 3.5;
    const bool is_steep = seed % 2 == 0;
    if (is_steep)
      for (auto& b : city.buildings) {
        b.height_m = b.eave_m = kLow_m;
        for (auto& p : b.roof.points) p.up = kLow_m * kRoofStepsPerMetre;
      }
    Terrain& t = city.terrain;
    t = {box.min,
         kStep_mm,
         static_cast<std::uint32_t>((box.max.x - box.min.x) / kStep_mm + 2),
         static_cast<std::uint32_t>((box.max.y - box.min.y) / kStep_mm + 2),
         {}};
    for (std::uint32_t row = 0; row < t.rows; ++row)
      for (std::uint32_t column = 0; column < t.columns; ++column) {
        const double x = static_cast<double>(column) / t.columns - 0.3, y = static_cast<double>(row) / t.rows - 0.6;
        t.height_mm.push_back(static_cast<std::int32_t>((is_steep ? 2000 : 1000) *
                                                        (30 * std::exp(-12 * (x * x + y * y)) + 30 * x - 10 * y)));
      }
    for (std::size_t i = 0; i < city.buildings.size(); i += 11)
      city.buildings[i].height_m = city.buildings[i].eave_m = 30;
    expect_nothing_missing(std::move(city), 400'000, seed);
  }
}

class RealVisibility : public testing::TestWithParam<std::size_t> {};

TEST_P(RealVisibility, MissesNothingThatARaySees) {
  auto city = real_city(real_cities()[GetParam()]);
  if (!city) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  expect_nothing_missing(std::move(*city), 2'000'000, 1);
}
// Rochechouart, Soho, Bubenec: the large cities take minutes.
INSTANTIATE_TEST_SUITE_P(Cities, RealVisibility, testing::Range<std::size_t>(0, 3),
                         [](const auto& info) { return real_cities()[info.param].name; });

TEST(Visibility, IsSymmetricOnTheLevel) {
  for (const std::uint64_t seed : seeds(1, 60)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    City city = random_town_city(seed);
    VisibleOptions options;
    options.over_roofs = OverRoofs::no;
    list_visible(city, options);
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& v : city.visible)
      if (v.building_ids.empty()) pairs.push_back({v.sector_id, v.visible_sector_id});
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [from, to] : pairs)
      EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::pair(to, from)));
  }
}

}  // namespace
}  // namespace vicus::test
