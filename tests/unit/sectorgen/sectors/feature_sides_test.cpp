#include <gtest/gtest.h>

#include "sectorgen/sectors/tracing.hpp"

/// Rings that rounding folded: which of their sides are the feature's.
namespace vicus {
namespace {

using Pairs = std::vector<std::pair<PlanPoint, PlanPoint>>;

Pairs sides_of(std::vector<PlanPoint> ring) {
  const Ground ground;
  const Bends bends(ground, Boundaries{});
  Pairs out;
  for (const FeatureSide& s : feature_sides({{MapLayer::house, 7, std::move(ring)}}, MapLayer::house, bends)) {
    EXPECT_EQ(s.feature, 7u);
    out.push_back({s.a, s.b});
  }
  return out;
}

constexpr PlanPoint kA{0, 0}, kB{10, 0}, kC{10, 5}, kD{10, 10}, kE{0, 10}, kSpike{20, 5};

TEST(FeatureSides, AreThoseOfTheRing) {
  EXPECT_EQ(sides_of({kA, kB, kD, kE}), (Pairs{{kA, kB}, {kE, kA}, {kB, kD}, {kD, kE}}));
}

TEST(FeatureSides, DoNotHoldASpike) {
  EXPECT_EQ(sides_of({kA, kB, kC, kSpike, kC, kD, kE}), (Pairs{{kA, kB}, {kE, kA}, {kB, kC}, {kC, kD}, {kD, kE}}));
}

TEST(FeatureSides, HoldOnceWhatIsWalkedOnAndBackAndOnAgain) {
  EXPECT_EQ(sides_of({kA, kB, kC, kB, kC, kD, kE}), (Pairs{{kA, kB}, {kE, kA}, {kB, kC}, {kC, kD}, {kD, kE}}));
}

TEST(FeatureSides, AreOfTheLayerAskedFor) {
  const Ground ground;
  const Bends bends(ground, Boundaries{});
  EXPECT_TRUE(feature_sides({{MapLayer::water, 0, {kA, kB, kD}}}, MapLayer::house, bends).empty());
}

}  // namespace
}  // namespace vicus
