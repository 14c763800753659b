#include "cli/measure_pareto.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vicus::measure {
namespace {

/// By definition, every pair looked at.
bool is_beaten(const std::vector<CostError>& points, std::size_t i) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& [cost, error] = points[k];
    const bool no_worse = cost <= points[i].first && error <= points[i].second;
    const bool is_better = cost < points[i].first || error < points[i].second;
    if (no_worse && (is_better || k < i)) return true;  // of equal points the first
  }
  return false;
}

TEST(ParetoFront, IsWhatNoOtherPointBeats) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<CostError> points;
    for (std::size_t n = random() % 40; n > 0; --n)  // few values: many ties
      points.emplace_back(static_cast<double>(random() % 12), static_cast<double>(random() % 12));
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_beaten(points, i)) expected.push_back(i);
    auto front = pareto_front(points);
    for (std::size_t k = 1; k < front.size(); ++k) {
      EXPECT_LT(points[front[k - 1]].first, points[front[k]].first) << "seed " << seed;
      EXPECT_GT(points[front[k - 1]].second, points[front[k]].second) << "seed " << seed;
    }
    std::sort(front.begin(), front.end());
    EXPECT_EQ(front, expected) << "seed " << seed;
  }
}

TEST(CostAt, GoesStraightInTheLogarithmBetweenNeighbours) {
  const std::vector<CostError> sweep{{1000, 0.2}, {100, 0.4}, {500, 0.9}, {10000, 0.05}};  // the third is beaten
  EXPECT_DOUBLE_EQ(cost_at(sweep, 0.2).value(), 1000);
  EXPECT_NEAR(cost_at(sweep, 0.3).value(), std::sqrt(100.0 * 1000.0), 1e-6);
  EXPECT_DOUBLE_EQ(cost_at(sweep, 0.4).value(), 100);
  EXPECT_FALSE(cost_at(sweep, 0.04));  // never reached
  EXPECT_FALSE(cost_at(sweep, 0.5));   // the cheapest is better
  EXPECT_FALSE(cost_at({}, 0.5));
}

}  // namespace
}  // namespace vicus::measure
