#include "sectorgen/visibility/betweenness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace vicus {
namespace {

/// Every shortest way written out, counted node by node.
std::vector<double> brute_force(const Graph& graph) {
  const auto n = graph.nodes;
  constexpr int kFar = 1 << 20;
  std::vector<std::vector<int>> steps(n, std::vector<int>(n, kFar));
  std::vector<std::vector<std::uint32_t>> next(n);
  for (std::size_t i = 0; i < n; ++i) steps[i][i] = 0;
  for (const auto& [a, b] : graph.edges) {
    steps[a][b] = steps[b][a] = 1;
    next[a].push_back(b);
    next[b].push_back(a);
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) steps[i][j] = std::min(steps[i][j], steps[i][k] + steps[k][j]);
  std::vector<double> sums(n, 0.0);
  for (std::uint32_t s = 0; s < n; ++s)
    for (std::uint32_t t = s + 1; t < n; ++t) {
      if (steps[s][t] >= kFar) continue;
      std::vector<std::vector<std::uint32_t>> ways;
      std::vector<std::uint32_t> way{s};
      const std::function<void()> go_on = [&] {
        if (way.back() == t) return ways.push_back(way);
        for (const auto node : next[way.back()])
          if (steps[s][node] == static_cast<int>(way.size()) && steps[s][node] + steps[node][t] == steps[s][t]) {
            way.push_back(node);
            go_on();
            way.pop_back();
          }
      };
      go_on();
      for (const auto& found : ways)
        for (std::size_t i = 1; i + 1 < found.size(); ++i) sums[found[i]] += 1.0 / static_cast<double>(ways.size());
    }
  return sums;
}

Graph random_graph(std::mt19937& random, std::size_t nodes, std::size_t edges) {
  Graph graph{nodes, {}};
  for (std::size_t i = 0; i < edges; ++i) {
    const auto a = static_cast<std::uint32_t>(random() % nodes), b = static_cast<std::uint32_t>(random() % nodes);
    if (a != b) graph.edges.push_back(std::minmax(a, b));
  }
  std::sort(graph.edges.begin(), graph.edges.end());
  graph.edges.erase(std::unique(graph.edges.begin(), graph.edges.end()), graph.edges.end());
  return graph;
}

TEST(Betweenness, OfAPathAndAStarIsKnown) {
  EXPECT_EQ(betweenness({5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}}, 100), (std::vector<double>{0, 3, 4, 3, 0}));
  EXPECT_EQ(betweenness({5, {{0, 1}, {0, 2}, {0, 3}, {0, 4}}}, 100), (std::vector<double>{6, 0, 0, 0, 0}));
  EXPECT_EQ(betweenness({4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}}, 100), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(betweenness({0, {}}, 100), std::vector<double>{});
  EXPECT_EQ(betweenness({2, {}}, 100), (std::vector<double>{0, 0}));
}

TEST(Betweenness, IsWhatCountingEveryShortestWayGives) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::size_t nodes = 2 + random() % 12;
    const Graph graph = random_graph(random, nodes, random() % (3 * nodes));
    const auto fast = betweenness(graph, 100), slow = brute_force(graph);
    ASSERT_EQ(fast.size(), slow.size());
    for (std::size_t i = 0; i < nodes; ++i) EXPECT_NEAR(fast[i], slow[i], 1e-9) << i;
  }
}

TEST(Betweenness, IsNearlyTheSameFromAFewSources) {
  // A grid of 40 x 40 with one bridge in the middle of a wall: the bridge's ends stand out.
  constexpr std::uint32_t kSide = 40;
  Graph graph{kSide * kSide, {}};
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x) {
      if (x + 1 < kSide && (x + 1 != kSide / 2 || y == kSide / 2))
        graph.edges.push_back({y * kSide + x, y * kSide + x + 1});
      if (y + 1 < kSide) graph.edges.push_back({y * kSide + x, (y + 1) * kSide + x});
    }
  const auto exact = betweenness(graph, 10'000), sampled = betweenness(graph, 200);
  const auto top = [](const std::vector<double>& sums) {
    return std::max_element(sums.begin(), sums.end()) - sums.begin();
  };
  const auto bridge = static_cast<long>(kSide / 2 * kSide + kSide / 2);
  EXPECT_TRUE(top(exact) == bridge || top(exact) == bridge - 1);
  EXPECT_TRUE(top(sampled) == bridge || top(sampled) == bridge - 1);
  EXPECT_NEAR(sampled[static_cast<std::size_t>(bridge)] / exact[static_cast<std::size_t>(bridge)], 1, 0.1);
  EXPECT_EQ(sampled, betweenness(graph, 200)) << "the draw is always the same";
}

}  // namespace
}  // namespace vicus
