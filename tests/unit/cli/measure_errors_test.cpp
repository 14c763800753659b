#include "cli/measure_errors.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace vicus::measure {
namespace {

constexpr float kSky = std::numeric_limits<float>::infinity();

/// Grey below row `skyline`, sky above.
View view_of(int skyline, float grey) {
  View view;
  view.colour = Picture(40, 30, Rgb{0.8f, 0.9f, 1});
  view.coverage = Coverage(40, 30);
  view.depth = DepthMap(40, 30, kSky);
  for (int row = skyline; row < 30; ++row)
    for (int column = 0; column < 40; ++column) {
      view.colour.at(column, row) = {grey, grey, grey};
      view.coverage.at(column, row) = 1;
      view.depth.at(column, row) = 10;
    }
  return view;
}

TEST(ViewErrors, AreNoneOfThePictureItself) {
  const View view = view_of(10, 0.5f);
  const ViewErrors e = errors_of(view, FlipReference(view.colour), view, PixelGrid<std::uint8_t>(40, 30, 1));
  EXPECT_EQ(e.depth_max_px, 0);
  EXPECT_EQ(e.silhouette_iou, 1);
  EXPECT_EQ(e.psnr_db, 99);
  EXPECT_NEAR(e.ssim, 1, 1e-12);
  EXPECT_EQ(e.flip, 0);
  EXPECT_EQ(e.flip_houses, 0);
}

TEST(ViewErrors, CountWhatStandsApart) {
  const View truth = view_of(10, 0.5f), other = view_of(12, 0.5f);
  PixelGrid<std::uint8_t> upper(40, 30), none(40, 30);
  for (int column = 0; column < 40; ++column) upper.at(column, 10) = 1;
  const ViewErrors e = errors_of(truth, FlipReference(truth.colour), other, upper);
  EXPECT_DOUBLE_EQ(e.skyline_mean_px, 2);
  EXPECT_NEAR(e.silhouette_iou, 18.0 / 20, 1e-9);
  EXPECT_GT(e.flip_houses, e.flip);  // the row that is missing is all that is told apart
  EXPECT_EQ(errors_of(truth, FlipReference(truth.colour), other, none).flip_houses, 0);
  // Two rows of a crop of 20: the sky above is left out of PSNR.
  const double square = (0.3 * 0.3 + 0.4 * 0.4 + 0.5 * 0.5) / 3 * 2 / 20;
  EXPECT_NEAR(e.psnr_db, -10 * std::log10(square), 1e-3);
}

TEST(Crop, HoldsAllThatIsNotSkyAndIsNeverSmallerThanAWindow) {
  Coverage a(40, 30), b(40, 30);
  a.at(5, 29) = 0.25f;
  b.at(20, 8) = 1;
  const Crop crop = crop_of(a, b);
  EXPECT_EQ(crop.column, 5);
  EXPECT_EQ(crop.row, 8);
  EXPECT_EQ(crop.width, 16);
  EXPECT_EQ(crop.height, 22);
  Coverage corner(40, 30);
  corner.at(39, 29) = 1;
  const Crop least = crop_of(corner, corner);
  EXPECT_EQ(least.width, 11);
  EXPECT_EQ(least.column, 29);
  EXPECT_EQ(least.row, 19);
}

TEST(Standing, IsWhatRisesAboveTheGround) {
  const Camera camera = camera_at({0, 0, 1.7}, {0, 10, 1.7}, 1, 40, 30);
  View truth = view_of(0, 0.5f);  // 10 m ahead, from top to bottom
  const auto mask = standing(truth, camera, {});
  EXPECT_EQ(mask.at(20, 0), 1);   // 7 m up
  EXPECT_EQ(mask.at(20, 29), 0);  // below the ground
  truth.depth = DepthMap(40, 30, kSky);
  EXPECT_EQ(standing(truth, camera, {}).at(20, 0), 0);
}

}  // namespace
}  // namespace vicus::measure
