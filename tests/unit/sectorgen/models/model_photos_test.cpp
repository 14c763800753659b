#include "sectorgen/models/model_photos.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "city_db/facade_layout.hpp"
#include "tests/support/scratch.hpp"

/// Images on the walls of modelled houses, on facades.
namespace vicus::test {
namespace {

/// 8 x 8 pixels as a portable pixmap: red above, green below.
std::filesystem::path picture(const ScratchDirectory& scratch) {
  std::ofstream out(scratch / "wall.ppm", std::ios::binary);
  out << "P6\n8 8\n255\n";
  for (int i = 0; i < 64; ++i) out << (i < 32 ? std::string("\xc8\x20\x20", 3) : std::string("\x20\x96\x20", 3));
  return scratch / "wall.ppm";
}

City one_facade() {
  City city;
  Building house;
  house.id = "b", house.source_id = "m#b";
  city.buildings = {house};
  Facade f;
  f.sector_id = "s", f.building_id = "b";
  f.a = {8000, 0}, f.b = {0, 0};
  f.top_m = 6;
  f.floors = 2, f.bays = 3;
  city.facades = {f};
  return city;
}

/// The wall above `share` of the facade's length.
std::map<std::string, HouseModel> wall(const std::filesystem::path& image, double share, std::int32_t north = 0) {
  const std::int32_t x = static_cast<std::int32_t>(8000 * share);
  HouseModel model;
  model.photos = {
      {image, {{{0, north}, 0}, {{x, north}, 0}, {{x, north}, 6}, {{0, north}, 6}}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  return {{"m#b", model}};
}

TEST(HangModelPhotos, MakeTheImageTheFacadesTextureAndItsColourTheHouses) {
  const ScratchDirectory scratch;
  City city = one_facade();
  hang_model_photos(wall(picture(scratch), 1, 200), city);
  ASSERT_EQ(city.textures.size(), 1u);
  EXPECT_EQ(city.facades[0].texture, city.textures[0].id);
  EXPECT_EQ(city.textures[0].width, 32) << "no finer than the image needs, 32 at least";
  EXPECT_EQ(city.facades[0].repeats, 1);
  const Colour c = city.buildings[0].wall_colour;
  EXPECT_TRUE(c.r > 60 && c.g > 50 && c.b < 60) << hex_of(c) << ": red and green mixed";
}

TEST(HangModelPhotos, LeaveFacadesAloneThatTheyHardlyCoverOrAreNotOn) {
  const ScratchDirectory scratch;
  for (const auto& models : {wall(picture(scratch), 0.4), wall(picture(scratch), 1, 900)}) {
    City city = one_facade();
    hang_model_photos(models, city);
    EXPECT_TRUE(city.textures.empty());
    EXPECT_EQ(city.facades[0].texture, "");
  }
}

TEST(HangModelPhotos, SayWhichImageCannotBeRead) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "wall.jpg") << "no picture";
  City city = one_facade();
  try {
    hang_model_photos(wall(scratch / "wall.jpg", 1), city);
    FAIL();
  } catch (const CityError& error) {
    EXPECT_NE(std::string(error.what()).find("wall.jpg"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace vicus::test
