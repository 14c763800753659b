#include "sectorgen/models/wall_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vicus {
namespace {

using Edges = std::vector<std::pair<PlanPoint, PlanPoint>>;

TEST(JoinedLines, GoOnWhereOneEdgeEndsAndAnotherBegins) {
  const Edges edges{{{1000, 0}, {2000, 0}}, {{5000, 5000}, {6000, 5000}}, {{0, 0}, {1000, 0}}, {{2000, 0}, {2000, 9}}};
  const auto lines = joined_lines(edges);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], (std::vector<PlanPoint>{{5000, 5000}, {6000, 5000}}));
  EXPECT_EQ(lines[1], (std::vector<PlanPoint>{{0, 0}, {1000, 0}, {2000, 0}, {2000, 9}}));
}

TEST(JoinedLines, ThatAreClosedBeginAtACorner) {
  const Edges square{{{500, 0}, {1000, 0}},
                     {{1000, 0}, {1000, 1000}},
                     {{1000, 1000}, {0, 1000}},
                     {{0, 1000}, {0, 0}},
                     {{0, 0}, {500, 0}}};
  const auto lines = joined_lines(square);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], (std::vector<PlanPoint>{{1000, 0}, {1000, 1000}, {0, 1000}, {0, 0}, {500, 0}, {1000, 0}}));
}

TEST(JoinedLines, HaveEveryEdgeOnceWhateverMeetsWhere) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 random(seed);
    Edges edges;
    for (int i = 0; i < 30; ++i) {
      const PlanPoint a{static_cast<std::int32_t>(random() % 4), static_cast<std::int32_t>(random() % 4)},
          b{static_cast<std::int32_t>(random() % 4), static_cast<std::int32_t>(random() % 4)};
      if (a != b && std::find(edges.begin(), edges.end(), std::pair(a, b)) == edges.end()) edges.emplace_back(a, b);
    }
    Edges got;
    for (const auto& line : joined_lines(edges))
      for (std::size_t i = 0; i + 1 < line.size(); ++i) got.emplace_back(line[i], line[i + 1]);
    std::sort(edges.begin(), edges.end());
    std::sort(got.begin(), got.end());
    EXPECT_EQ(got, edges) << "seed " << seed;
  }
}

}  // namespace
}  // namespace vicus
