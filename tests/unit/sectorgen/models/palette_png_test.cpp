#include "sectorgen/models/palette_png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>

#include "sectorgen/models/paint_facade.hpp"
#include "sectorgen/models/paint_openings.hpp"

namespace vicus {
namespace {

struct Decoded {
  unsigned width = 0, height = 0;
  std::vector<unsigned char> rgb;
};

/// By libpng, which shares no code with the writer.
Decoded decoded(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Decoded out;
  EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0) << image.message;
  image.format = PNG_FORMAT_RGB;
  out.width = image.width;
  out.height = image.height;
  out.rgb.resize(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, out.rgb.data(), 0, nullptr), 0) << image.message;
  return out;
}

double worst_difference(const Canvas& canvas, const Decoded& image) {
  const auto rgba = canvas.rgba();
  double worst = 0;
  for (std::size_t i = 0; i < rgba.size() / 4; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(static_cast<double>(rgba[4 * i + c]) - image.rgb[3 * i + c]));
  return worst;
}

TEST(PalettePng, FewColoursComeBackAsTheyWere) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {64, 64}, {33, 2}}) {
    for (const int colours : {2, 4, 7, 16}) {
      Canvas canvas(width, height, width, height);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const double v = (x + 3 * y) % colours / 16.0;
          canvas.rectangle(x, y, x + 1, y + 1, {v, 1 - v, 0.5});
        }
      const Decoded image = decoded(palette_png(canvas, 16));
      ASSERT_EQ(image.width, static_cast<unsigned>(width));
      ASSERT_EQ(image.height, static_cast<unsigned>(height));
      EXPECT_LE(worst_difference(canvas, image), 1) << width << " x " << height << ", " << colours << " colours";
    }
  }
}

TEST(PalettePng, IsTheSameEachTime) { EXPECT_EQ(palette_png(paint_atlas(), 64), palette_png(paint_atlas(), 64)); }

/// Paper 004 §4.2: such a texture does not exceed 3 kB.
TEST(PaintTile, EachKindTakesLessThan3kB) {
  for (std::size_t kind = 0; kind < kOpeningKinds; ++kind) {
    const Canvas tile = paint_tile(static_cast<OpeningKind>(kind));
    EXPECT_EQ(tile.width(), 64);
    EXPECT_EQ(tile.height(), 64);
    EXPECT_LT(palette_png(tile, 64).size(), 3000u);
  }
}

TEST(PaintAtlas, TakesFewerBytesThanItsTilesOneByOne) {
  std::size_t one_by_one = 0;
  for (std::size_t kind = 0; kind < kOpeningKinds; ++kind)
    one_by_one += palette_png(paint_tile(static_cast<OpeningKind>(kind)), 64).size();
  EXPECT_LT(palette_png(paint_atlas(), 64).size(), one_by_one);
}

TEST(Canvas, RectanglesAreLaidByTheAreaTheyCover) {
  Canvas canvas(4, 4, 4, 4);
  canvas.rectangle(0.25, 0.5, 1.75, 3, {1, 1, 1});
  EXPECT_NEAR(canvas.at(0, 3).r, 0.75 * 0.5, 1e-12);  // the bottom row is the last one
  EXPECT_NEAR(canvas.at(1, 2).r, 0.75, 1e-12);
  EXPECT_NEAR(canvas.at(0, 0).r, 0, 1e-12);
  canvas.rectangle(-5, -5, 50, 50, {0, 0, 0});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) EXPECT_EQ(canvas.at(x, y).r, 0);
}

TEST(PaintFacade, SidesArePowersOfTwoUpTo512) {
  for (const int floors : {1, 2, 3, 6, 20, 60})
    for (const int bays : {1, 2, 3, 5, 8}) {
      Facade f;
      f.floors = floors;
      f.bays = bays;
      const Canvas c = paint_facade(f, {200, 190, 170});
      for (const int side : {c.width(), c.height()}) {
        EXPECT_EQ(side & (side - 1), 0);
        EXPECT_LE(side, 512);
        EXPECT_GE(side, 32);
      }
    }
}

/// The wall between the openings has the colour of the house, so that the second level of detail and the third agree.
TEST(PaintFacade, HasTheColourOfTheHouse) {
  const Colour wall{200, 180, 150};
  for (const FacadeStyle style : {FacadeStyle::plaster, FacadeStyle::stone, FacadeStyle::brick, FacadeStyle::church}) {
    Facade f;
    f.style = style;
    f.bays = 3;
    f.floors = style == FacadeStyle::church ? 1 : 4;
    const Canvas c = paint_facade(f, wall);
    double sum = 0;
    int count = 0;
    const auto openings = pattern_openings(f);
    for (int row = 0; row < c.height(); ++row)
      for (int column = 0; column < c.width(); ++column) {
        const double x = (column + 0.5) * c.width_m() / c.width(),
                     z = (c.height() - row - 0.5) * c.height_m() / c.height();
        bool is_open = false;
        for (const Opening& o : openings)
          is_open |= x > o.x0 - 0.3 && x < o.x1 + 0.3 && z > o.z0 - 0.3 && z < o.z1 + 0.5;
        if (is_open) continue;
        sum += c.at(column, row).g;
        ++count;
      }
    EXPECT_NEAR(sum / count, wall.g / 255.0, 0.05) << name_of(style);
  }
}

}  // namespace
}  // namespace vicus
