#include "sectorgen/models/paint_grain.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <vector>

#include "city_db/ground_grain.hpp"

namespace vicus {
namespace {

TEST(PaintGrain, IsGreyAsBrightAsItSaysAndMeetsItselfAtItsRims) {
  const Texture texture = paint_grain();
  EXPECT_EQ(texture.id, paint_grain().id);
  EXPECT_LE(texture.png.size(), 9'000u);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&image, texture.png.data(), texture.png.size()));
  EXPECT_EQ(image.format, unsigned{PNG_FORMAT_GRAY}) << "colours in it would replace those of the ground in VRML97";
  image.format = PNG_FORMAT_GRAY;
  std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr));
  const std::size_t n = image.width;
  ASSERT_EQ(n, image.height);
  double sum = 0, inside = 0, rim = 0;
  for (const unsigned char v : pixels) sum += v / 255.0;
  EXPECT_NEAR(sum / double(pixels.size()), kGrainMean, 0.005);
  const auto step = [&](std::size_t a, std::size_t b) { return std::abs(int{pixels[a]} - int{pixels[b]}); };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const double steps = step(i * n + k, i * n + (k + 1) % n) + step(k * n + i, (k + 1) % n * n + i);
      (k + 1 == n ? rim : inside) += steps / double(k + 1 == n ? n : n * (n - 1));
    }
  EXPECT_LT(rim, 1.2 * inside);
  EXPECT_GT(inside, 2) << "it has a grain";
}

}  // namespace
}  // namespace vicus
