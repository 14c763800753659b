#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "city_db/issues.hpp"
#include "sectorgen/bake/picture/depth_error.hpp"
#include "sectorgen/bake/picture/png.hpp"
#include "sectorgen/bake/picture/silhouette.hpp"
#include "sectorgen/bake/picture/similarity.hpp"

namespace vicus {
namespace {

constexpr float kSky = std::numeric_limits<float>::infinity();

Picture grey(float v) { return Picture(16, 12, {v, v, v}); }

TEST(Psnr, IsTheShareOfThePeakInDecibel) {
  EXPECT_NEAR(psnr_db(grey(0.5f), grey(0.6f)), 20, 1e-4);
  EXPECT_NEAR(psnr_db(grey(0.5f), grey(0.51f)), 40, 1e-3);
  EXPECT_TRUE(std::isinf(psnr_db(grey(0.5f), grey(0.5f))));
}

TEST(Ssim, OfPlainPicturesIsThatOfTheirMeans) {
  EXPECT_NEAR(ssim(grey(0.5f), grey(0.5f)), 1, 1e-12);
  EXPECT_NEAR(ssim(grey(0.2f), grey(0.6f)), (2 * 0.2 * 0.6 + 1e-4) / (0.04 + 0.36 + 1e-4), 1e-6);
}

TEST(Ssim, OfAPictureAndItsNegativeIsBelowZero) {
  Picture a = grey(0);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) a.at(x, y).fill((x + y) % 2 ? 0.8f : 0.2f);
  Picture b = a;
  for (Rgb& p : b.pixels)
    for (float& v : p) v = 1 - v;
  EXPECT_LT(ssim(a, b), -0.9);
}

TEST(Silhouette, SharesOfCoverageCount) {
  Coverage a(4, 1), b(4, 1);
  a.pixels = {1, 1, 0.5f, 0};
  b.pixels = {1, 0.5f, 0.5f, 0};
  EXPECT_NEAR(silhouette_iou(a, b), 2.0 / 2.5, 1e-7);
  EXPECT_EQ(silhouette_iou(a, a), 1);
  EXPECT_EQ(silhouette_iou(Coverage(4, 1), Coverage(4, 1)), 1);
}

TEST(Skyline, IsMeasuredColumnByColumn) {
  Coverage a(4, 10), b(4, 10);
  const auto fill = [](Coverage& c, int column, int from) {
    for (int row = from; row < c.height; ++row) c.at(column, row) = 1;
  };
  for (int column = 0; column < 3; ++column) fill(a, column, 4);
  fill(b, 0, 4);
  fill(b, 1, 6);
  fill(b, 2, 1);
  const auto distance = skyline_distance(a, b);
  EXPECT_EQ(distance.max_px, 3);
  EXPECT_NEAR(distance.mean_px, (0 + 2 + 3 + 0) / 4.0, 1e-12);
}

TEST(DepthError, AWallMovedByTwoPixelsIsTwoPixelsAway) {
  DepthMap a(12, 6, kSky), b(12, 6, kSky);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 12; ++x) {
      if (x >= 4) a.at(x, y) = 20;
      if (x >= 6) b.at(x, y) = 20;
    }
  const auto error = projected_depth_error_px(a, b);
  EXPECT_EQ(error.max, 2);
  EXPECT_NEAR(error.mean, (2 + 2) * 6 / 72.0, 1e-6);  // two columns of each row are wrong, each 2 px one way
  EXPECT_EQ(projected_depth_error_px(a, a).max, 0);
}

TEST(DepthError, WhatIsNowhereNearCountsOneMoreThanTheReach) {
  const DepthMap a(8, 8, 10), b(8, 8, 11);
  EXPECT_EQ(projected_depth_error_px(a, b).mean, kDepthReach_px + 1);
  EXPECT_EQ(projected_depth_error_px(a, DepthMap(8, 8, 10.09f)).mean, 0);
}

TEST(Png, ComesBackToTheByte) {
  Picture picture(5, 3);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = {static_cast<float>(i) / 255, static_cast<float>(2 * i) / 255, 1};
  const auto bytes = png_text(picture);
  EXPECT_EQ(png_text(picture), bytes);
  const Picture back = colours_of(read_png(bytes));
  ASSERT_EQ(back.width, 5);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back.pixels[i][k], picture.pixels[i][k], 1e-6);
}

TEST(Png, RefusesWhatIsNone) {
  EXPECT_THROW(read_png("no picture"), CityError);
  std::string cut = png_text(grey(0.5f));
  EXPECT_THROW(read_png(cut.substr(0, cut.size() / 2)), CityError);
}

TEST(Pfm, HasTheBottomRowFirst) {
  DepthMap depth(1, 2);
  depth.pixels = {1, kSky};
  EXPECT_EQ(pfm_text(depth), std::string("Pf\n1 2\n-1.0\n") + std::string("\x00\x00\x80\x7f\x00\x00\x80\x3f", 8));
}

}  // namespace
}  // namespace vicus
