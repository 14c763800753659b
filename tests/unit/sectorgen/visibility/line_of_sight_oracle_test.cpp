#include <gtest/gtest.h>

#include "sectorgen/visibility/line_of_sight.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/random_partition.hpp"
#include "tests/support/sight_oracle.hpp"

/// The search against brute force: nothing missing, nothing extra.
namespace vicus::test {
namespace {

Pairs pairs_of(const std::vector<std::vector<std::uint32_t>>& lists) {
  Pairs pairs;
  for (std::uint32_t a = 0; a < lists.size(); ++a)
    for (const std::uint32_t b : lists[a]) pairs.insert({a, b});
  return pairs;
}

void expect_equal(const Pairs& fast, const Pairs& slow) {
  std::size_t missing = 0, extra = 0;
  for (const auto& pair : slow) missing += !fast.contains(pair);
  for (const auto& pair : fast) extra += !slow.contains(pair);
  EXPECT_EQ(missing, 0u) << "of " << slow.size();
  EXPECT_EQ(extra, 0u) << "of " << fast.size();
}

struct Counts {
  std::size_t cells = 0, houses = 0;
};

void expect_exact(const City& city, Counts& counts) {
  const SightMap map = make_sight_map(city);
  const SightLists lists = lines_of_sight(map, {});
  EXPECT_TRUE(lists.over_budget.empty());
  const Sights slow = sights_by_brute_force(map);
  expect_equal(pairs_of(lists.visible), slow.sectors);
  expect_equal(pairs_of(lists.houses), slow.houses);
  counts.cells += map.cells.size();
  counts.houses += slow.houses.size();
}

/// Owned by any sector: mostly not one beside it.
void deal_out_houses(City& city, std::uint64_t seed) {
  for (std::size_t i = 0; i < city.buildings.size(); ++i)
    city.buildings[i].sector_id = city.sectors[(i * 7 + seed) % city.sectors.size()].id;
}

TEST(LineOfSight, IsExactOnRandomPartitions) {
  Counts counts;
  for (const std::uint64_t seed : seeds(1, 160)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto side = static_cast<std::uint32_t>(4 + seed % 9);
    RandomCity random = random_city(seed, side, side * side / 2);
    // Some houses and obstacles stop sight, some do not.
    for (std::size_t i = 0; i < random.city.buildings.size(); ++i) random.city.buildings[i].height_m = i % 4 ? 9 : 2;
    for (std::size_t i = 0; i < random.city.obstacles.size(); ++i) random.city.obstacles[i].height_m = i % 2 ? 3 : 1;
    if (!random.city.sectors.empty()) deal_out_houses(random.city, seed);
    expect_exact(random.city, counts);
  }
  EXPECT_GT(counts.houses, 100u);
  std::cout << counts.cells << " cells, " << counts.houses << " houses in sight, their owners not\n";
}

TEST(LineOfSight, IsExactOnRandomTowns) {
  Counts counts;
  int towns = 0;
  for (std::uint64_t seed = 1; towns < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    City city = random_town_city(seed);
    if (seed % 2 == 0) deal_out_houses(city, seed);
    if (make_sight_map(city).cells.size() > 400) continue;
    expect_exact(city, counts);
    ++towns;
  }
  EXPECT_GT(counts.houses, 100u);
  std::cout << counts.cells << " cells, " << counts.houses << " houses in sight, their owners not\n";
}

}  // namespace
}  // namespace vicus::test
