#include "sectorgen/models/photo_facades.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "city_db/facade_layout.hpp"
#include "sectorgen/models/facades.hpp"
#include "sectorgen/models/paint_facade.hpp"
#include "sectorgen/models/palette_png.hpp"
#include "sectorgen/models/rectify.hpp"
#include "sectorgen/models/window_grid.hpp"
#include "tests/support/map_checks.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"

/// Photos of facades: straightened, measured, hung.
namespace vicus::test {
namespace {

Facade facade_of(FacadeStyle style, int bays, int floors) {
  Facade f;
  f.style = style;
  f.bays = bays;
  f.floors = floors;
  f.b = {0, 0};
  f.a = {lattice_mm(pattern_width_m(f)), 0};
  f.top_m = pattern_height_m(f);
  return f;
}

double mean_difference(const Canvas& a, const Canvas& b) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      sum += std::abs(a.at(x, y).r - b.at(x, y).r) + std::abs(a.at(x, y).g - b.at(x, y).g) +
             std::abs(a.at(x, y).b - b.at(x, y).b);
  return sum / (3.0 * a.width() * a.height());
}

/// Bottom left, bottom right, top right, top left, in pixels.
const std::array<double, 8> kCorners = {60, 420, 560, 380, 520, 60, 90, 30};

TEST(Rectified, GivesThePictureBackFromAPhotoTakenAtASlant) {
  const ScratchDirectory scratch;
  const Canvas truth = paint_facade(facade_of(FacadeStyle::stone, 4, 4), {210, 200, 180});
  // The photo by cross ratios in the pencils through the vanishing points: no formula of the subject is used.
  const Canvas photo = [&] {
    Canvas out(640, 480, 640, 480);
    const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    for (int row = 0; row < 480; ++row)
      for (int column = 0; column < 640; ++column) {
        // Cross ratios: u from the pencil of lines through where the left and right edges meet, v likewise.
        const auto& q = kCorners;
        const auto meet = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
          const double x1 = q[2 * a], y1 = q[2 * a + 1], dx1 = q[2 * b] - x1, dy1 = q[2 * b + 1] - y1, x2 = q[2 * c],
                       y2 = q[2 * c + 1], dx2 = q[2 * d] - x2, dy2 = q[2 * d + 1] - y2;
          const double t = cross(x2 - x1, y2 - y1, dx2, dy2) / cross(dx1, dy1, dx2, dy2);
          return std::pair(x1 + t * dx1, y1 + t * dy1);
        };
        const double px = column + 0.5, py = row + 0.5;
        // Harmonic position between two edges with the vanishing point of the third direction as infinity.
        const auto share = [&](std::pair<double, double> pencil, std::size_t zero, std::size_t one,
                               std::pair<double, double> infinity) {
          const auto s = [&](double x, double y) { return std::pair(x - pencil.first, y - pencil.second); };
          const auto [ax, ay] = s(q[2 * zero], q[2 * zero + 1]);
          const auto [bx, by] = s(q[2 * one], q[2 * one + 1]);
          const auto [cx, cy] = s(infinity.first, infinity.second);
          const auto [dx, dy] = s(px, py);
          return cross(ax, ay, dx, dy) / cross(cx, cy, dx, dy) / (cross(ax, ay, bx, by) / cross(cx, cy, bx, by));
        };
        const auto upright = meet(0, 3, 1, 2), level = meet(0, 1, 3, 2);
        const double u = share(upright, 0, 1, level), v = share(level, 0, 3, upright);
        if (!(u > 0 && u < 1 && v > 0 && v < 1)) continue;
        out.set(column, row,
                truth.at(std::min(truth.width() - 1, static_cast<int>(u * truth.width())),
                         std::min(truth.height() - 1, static_cast<int>((1 - v) * truth.height()))));
      }
    return out;
  }();
  write_bytes(scratch / "photo.png", palette_png(photo, 256));
  const Canvas straight =
      rectified(scratch / "photo.png", kCorners, truth.width(), truth.height(), truth.width_m(), truth.height_m());
  EXPECT_LT(mean_difference(straight, truth), 0.03);
  // Corners that are off by a tenth of the picture are seen.
  auto off = kCorners;
  off[0] += 50;
  const Canvas wrong = rectified(scratch / "photo.png", off, truth.width(), truth.height(), 1, 1);
  EXPECT_GT(mean_difference(wrong, truth), 0.03);
}

TEST(Rectified, RefusesWhatIsNoPicture) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "a.png", "no picture");
  try {
    rectified(scratch / "a.png", std::nullopt, 32, 32, 1, 1);
    FAIL();
  } catch (const CityError& error) {
    EXPECT_NE(std::string(error.what()).find("a.png"), std::string::npos);
    EXPECT_EQ(error.exit_code, 4);
  }
}

TEST(WindowGrid, FindsBaysAndStoreysOfPaintedFacades) {
  int sure = 0, wrong = 0, all = 0;
  for (const auto style : {FacadeStyle::stone, FacadeStyle::plaster, FacadeStyle::brick, FacadeStyle::modern})
    for (int bays = 3; bays <= 8; ++bays)
      for (int floors = 3; floors <= 7; ++floors) {
        const Canvas picture = paint_facade(facade_of(style, bays, floors), {200, 190, 170});
        ++all;
        if (const auto found = find_bays(picture)) ++sure, wrong += found->count != bays;
        if (const auto found = find_floors(picture)) wrong += found->count != floors;
      }
  EXPECT_GT(sure, all / 2);
  EXPECT_EQ(wrong, 0);
}

TEST(WindowGrid, IsNotSureOfAnAerialView) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  int seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*data / "citymodels-citygml/lyon-small-houses")) {
    if (entry.path().extension() != ".jpg") continue;
    ++seen;
    const Canvas picture = rectified(entry.path(), std::nullopt, 512, 512, 15, 15);
    EXPECT_FALSE(find_bays(picture)) << entry.path();
    EXPECT_FALSE(find_floors(picture)) << entry.path();
  }
  EXPECT_EQ(seen, 2);
}

TEST(WindowGrid, IsNotSureOfNoiseNorOfAPlainWall) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Canvas noise(256, 256, 12, 12), plain(256, 256, 12, 12);
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        const double v = static_cast<double>(random()) / 4294967296.0;
        noise.set(x, y, {v, v, v});
        plain.set(x, y, {0.7, 0.7, 0.6});
      }
    EXPECT_FALSE(find_bays(noise));
    EXPECT_FALSE(find_floors(noise));
    EXPECT_FALSE(find_bays(plain));
  }
}

TEST(PhotoFacades, GiveTheirHouseColourTextureAndWindows) {
  const ScratchDirectory scratch;
  City city = sample_city();
  lay_out_facades(city);
  ASSERT_FALSE(city.facades.empty());
  const std::string house = city.facades[0].building_id;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < city.facades.size(); ++i)
    if (city.facades[i].building_id == house &&
        (city.facades[longest].building_id != house || length_m(city.facades[i]) > length_m(city.facades[longest])))
      longest = i;
  Canvas red(64, 64, 1, 1);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) red.set(x, y, {0.8, 0.2, 0.2});
  write_bytes(scratch / "red.png", palette_png(red, 4));
  write_bytes(scratch / "photos.csv", "house,file,bays,floors\n" + house + ",red.png,5,3\nnobody,red.png,,\n");
  hang_photos(read_photo_list(scratch / "photos.csv"), city);
  paint_textures(city, 1);
  const Facade& facade = city.facades[longest];
  EXPECT_EQ(facade.bays, 5);
  EXPECT_EQ(facade.repeats, 1);
  EXPECT_EQ(facade.floors, 3);
  std::size_t users = 0;
  for (const auto& f : city.facades) users += f.texture == facade.texture;
  EXPECT_EQ(users, 1u);
  const auto texture = std::find_if(city.textures.begin(), city.textures.end(),
                                    [&](const Texture& t) { return t.id == facade.texture; });
  ASSERT_NE(texture, city.textures.end());
  EXPECT_EQ(texture->width & (texture->width - 1), 0);
  EXPECT_LE(texture->width, 512);
  const auto owner =
      std::find_if(city.buildings.begin(), city.buildings.end(), [&](const Building& b) { return b.id == house; });
  EXPECT_NEAR(owner->wall_colour.r, 204, 3);
  EXPECT_NEAR(owner->wall_colour.g, 51, 3);
  const auto told = std::find_if(city.issues.begin(), city.issues.end(),
                                 [](const Issue& i) { return i.source_id == "photos.csv#3"; });
  ASSERT_NE(told, city.issues.end());
  EXPECT_EQ(told->code, IssueCode::unknown_place);
}

TEST(PhotoList, IsRefusedByFileAndLine) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "a.png", "x");
  const auto told = [&](const std::string& list, const char* part) {
    write_bytes(scratch / "photos.csv", list);
    try {
      read_photo_list(scratch / "photos.csv");
      ADD_FAILURE() << list;
    } catch (const CityError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  told("house,picture\n", "line 1: no column is called picture");
  told("house\n", "house and file among them");
  told("house,file\na,none.png\n", "line 2");
  told("house,file\n,a.png\n", "house or file is empty");
  told("house,file,bays\na,a.png,0\n", "bays: 0 is no number from 1");
  told("house,file,bays\na,a.png,2.5\n", "bays");
  told("house,file,heading\na,a.png,north\n", "heading");
  told("house,file,corners\na,a.png,1 2 3\n", "eight numbers");
  told("house,file,corners\na,a.png,0 0 10 0 10 10 0 10\n", "bottom left, bottom right");
  told("house,file\n", "found none");
}

}  // namespace
}  // namespace vicus::test
