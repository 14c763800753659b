#include "sectorgen/sectors/min_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vicus {
namespace {

struct Link {
  std::uint32_t a, b;
  std::int64_t cost;
};

/// Every cut of a small graph, the cheapest first, of those the one with the fewest nodes beside the source.
std::vector<char> brute_force(std::size_t nodes, const std::vector<Link>& links, std::uint32_t from, std::uint32_t to) {
  std::vector<char> best;
  std::int64_t least = INT64_MAX;
  int fewest = 0;
  for (std::uint32_t set = 0; set < 1u << nodes; ++set) {
    if ((set >> from & 1) == 0 || (set >> to & 1) != 0) continue;
    std::int64_t cost = 0;
    for (const Link& l : links)
      if ((set >> l.a & 1) != (set >> l.b & 1)) cost += l.cost;
    const int size = __builtin_popcount(set);
    if (cost > least || (cost == least && size >= fewest)) continue;
    least = cost;
    fewest = size;
    best.assign(nodes, 0);
    for (std::size_t i = 0; i < nodes; ++i) best[i] = static_cast<char>(set >> i & 1);
  }
  return best;
}

TEST(MinCut, IsTheCheapestOfAllCutsAndTheNearestToTheSource) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    constexpr std::uint32_t kNodes = 9;
    std::vector<Link> links;
    for (std::uint32_t a = 0; a < kNodes; ++a)
      for (std::uint32_t b = a + 1; b < kNodes; ++b)
        if (b == a + 1 || random() % 3 == 0) links.push_back({a, b, static_cast<std::int64_t>(1 + random() % 9)});
    std::shuffle(links.begin(), links.end(), random);
    MinCut cut(kNodes);
    for (const Link& l : links) cut.join(l.a, l.b, l.cost);
    EXPECT_EQ(cut.source_side({0}, {kNodes - 1}, 1'000), brute_force(kNodes, links, 0, kNodes - 1));
  }
}

TEST(MinCut, IsNoneWhereEveryCutIsTooDear) {
  MinCut cut(3);
  cut.join(0, 1, 100);
  cut.join(1, 2, 50);
  EXPECT_TRUE(cut.source_side({0}, {2}, 50).empty());
}

}  // namespace
}  // namespace vicus
