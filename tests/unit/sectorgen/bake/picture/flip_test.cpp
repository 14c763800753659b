#include "sectorgen/bake/picture/flip.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/flip_oracle.hpp"

namespace vicus {
namespace {

Picture plain(Rgb colour) { return Picture(40, 30, colour); }

Picture noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0, 1);
  Picture picture(width, height);
  for (Rgb& p : picture.pixels)
    for (float& v : p) v = unit(random);
  return picture;
}

TEST(Flip, EqualPicturesHaveNone) { EXPECT_EQ(flip_mean(noise(40, 30, 1), noise(40, 30, 1)), 0); }

// Without features only the colours count: HyAB of the two in CIELAB, 0.7th power, knee at 0.4 of green against blue,
// which is 41.276 with the published CIELAB of both (87.735, -86.183, 83.179; 32.297, 79.188, -107.860).
TEST(Flip, PlainPicturesHaveTheErrorOfTheirColours) {
  EXPECT_NEAR(flip_mean(plain({0, 0, 0}), plain({1, 1, 1})), 0.96738, 1e-4);
  EXPECT_NEAR(flip_mean(plain({0, 1, 0}), plain({0, 0, 1})), 1, 1e-6);
  // Grey of 50 % has L* 53.389: |100 - 53.389|^0.7 = 14.724.
  EXPECT_NEAR(flip_mean(plain({0.5f, 0.5f, 0.5f}), plain({1, 1, 1})), 0.95 * 14.724 / (0.4 * 41.276), 1e-3);
}

TEST(Flip, IsThatOfThePapersFormulas) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    const Picture a = noise(22, 17, seed);
    Picture b = a;
    for (int y = 4; y < 12; ++y)
      for (int x = 6; x < 15; ++x) b.at(x, y) = noise(1, 1, seed + 100).pixels[0];
    constexpr double kCoarse = 25;  // the matrices of both have different digits: 3e-5 were seen
    const auto map = flip_map(a, b, kCoarse);
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; x += 3)
        EXPECT_NEAR(map.at(x, y), test::slow_flip(a, b, x, y, kCoarse), 1e-4) << x << " " << y;
  }
}

TEST(Flip, IsEqualBothWaysAndGrowsWithTheDifference) {
  const Picture a = noise(40, 30, 5);
  double before = 0;
  for (const float share : {0.1f, 0.3f, 0.6f, 1.0f}) {
    Picture b = a;
    const Picture other = noise(40, 30, 6);
    for (std::size_t i = 0; i < b.pixels.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) b.pixels[i][k] += share * (other.pixels[i][k] - b.pixels[i][k]);
    const double error = flip_mean(a, b);
    EXPECT_GT(error, before);
    EXPECT_NEAR(error, flip_mean(b, a), 1e-9);
    before = error;
  }
}

TEST(ErrorSummary, TellsMeanAndTail) {
  std::vector<float> errors;
  for (int i = 0; i <= 100; ++i) errors.push_back(static_cast<float>(100 - i));
  const ErrorSummary s = summary_of(errors);
  EXPECT_EQ(s.mean, 50);
  EXPECT_EQ(s.p99, 99);
  EXPECT_EQ(s.max, 100);
}

}  // namespace
}  // namespace vicus
