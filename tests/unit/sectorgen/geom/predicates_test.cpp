#include "sectorgen/geom/predicates.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vicus {
namespace {

PlanPoint random_point(std::mt19937_64& random, std::int32_t range) {
  std::uniform_int_distribution<std::int32_t> draw(-range, range);
  return {draw(random), draw(random)};
}

TEST(Orient, ChangesSignWithOrderAndKeepsItWhenTurned) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const PlanPoint a = random_point(random, kPlanLimit - 1), b = random_point(random, kPlanLimit - 1),
                    c = random_point(random, kPlanLimit - 1);
    EXPECT_EQ(orient(a, b, c), -orient(c, b, a));
    EXPECT_EQ(orient(a, b, c), orient(b, c, a));
    const Int128 wide = (Int128{b.x} - a.x) * (Int128{c.y} - a.y) - (Int128{b.y} - a.y) * (Int128{c.x} - a.x);
    EXPECT_TRUE(wide == orient(a, b, c)) << "overflow";
  }
}

TEST(InCircle, IsZeroForTheFourthCornerOfARectangle) {
  EXPECT_EQ(in_circle({0, 0}, {7'000, 0}, {7'000, 4'000}, {0, 4'000}), 0);
  EXPECT_GT(in_circle({0, 0}, {7'000, 0}, {7'000, 4'000}, {1, 3'999}), 0);
  EXPECT_LT(in_circle({0, 0}, {7'000, 0}, {7'000, 4'000}, {-1, 4'001}), 0);
}

TEST(IntegerSqrt, IsTheFloor) {
  for (std::int64_t n : {std::int64_t{0}, std::int64_t{1}, std::int64_t{3}, std::int64_t{4}, std::int64_t{99},
                         std::int64_t{100}, (std::int64_t{1} << 62) - 1, std::int64_t{1} << 62}) {
    const std::int64_t r = integer_sqrt(n);
    EXPECT_LE(Int128{r} * r, n);
    EXPECT_GT(Int128{r + 1} * (r + 1), n);
  }
}

TEST(CrossProperly, NeedsACommonInnerPoint) {
  EXPECT_TRUE(cross_properly({0, 0}, {10, 10}, {0, 10}, {10, 0}));
  EXPECT_FALSE(cross_properly({0, 0}, {10, 10}, {10, 10}, {20, 0}));  // share an end
  EXPECT_FALSE(cross_properly({0, 0}, {10, 0}, {5, 0}, {5, 9}));      // touch
  EXPECT_FALSE(cross_properly({0, 0}, {10, 0}, {5, 0}, {15, 0}));     // overlap
}

}  // namespace
}  // namespace vicus
