#include <gtest/gtest.h>

#include "sectorgen/visibility/line_of_sight.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/random_partition.hpp"
#include "tests/support/sight_oracle.hpp"

/// The search against brute force: nothing missing, nothing extra.
namespace vicus::test {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs_of(const SightLists& lists) {
  Pairs pairs;
  for (std::uint32_t a = 0; a < lists.visible.size(); ++a)
    for (const std::uint32_t b : lists.visible[a]) pairs.insert({a, b});
  return pairs;
}

void expect_exact(const City& city, std::size_t& cells) {
  const SightMap map = make_sight_map(city);
  cells += map.cells.size();
  const SightLists lists = lines_of_sight(map, {});
  EXPECT_TRUE(lists.over_budget.empty());
  const Pairs fast = pairs_of(lists), slow = sectors_in_sight_by_brute_force(map);
  std::size_t missing = 0, extra = 0;
  for (const auto& pair : slow) missing += !fast.contains(pair);
  for (const auto& pair : fast) extra += !slow.contains(pair);
  EXPECT_EQ(missing, 0u) << "of " << slow.size();
  EXPECT_EQ(extra, 0u) << "of " << fast.size();
}

TEST(LineOfSight, IsExactOnRandomPartitions) {
  std::size_t cells = 0;
  for (const std::uint64_t seed : seeds(1, 160)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto side = static_cast<std::uint32_t>(4 + seed % 9);
    RandomCity random = random_city(seed, side, side * side / 2);
    // Some houses and obstacles stop sight, some do not.
    for (std::size_t i = 0; i < random.city.buildings.size(); ++i) random.city.buildings[i].height_m = i % 4 ? 9 : 2;
    for (std::size_t i = 0; i < random.city.obstacles.size(); ++i) random.city.obstacles[i].height_m = i % 2 ? 3 : 1;
    expect_exact(random.city, cells);
  }
  std::cout << cells << " cells\n";
}

TEST(LineOfSight, IsExactOnRandomTowns) {
  std::size_t cells = 0;
  int towns = 0;
  for (std::uint64_t seed = 1; towns < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const City city = random_town_city(seed);
    if (make_sight_map(city).cells.size() > 400) continue;
    expect_exact(city, cells);
    ++towns;
  }
  std::cout << cells << " cells\n";
}

}  // namespace
}  // namespace vicus::test
