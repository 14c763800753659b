#include "cli/city_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "city_db/issues.hpp"
#include "sectorgen/bake/picture/silhouette.hpp"
#include "sectorgen/bake/render/render.hpp"
#include "sectorgen/models/facades.hpp"
#include "sectorgen/models/paint_openings.hpp"
#include "tests/support/sample_city.hpp"
#include "x3d_export/facade_levels.hpp"

namespace vicus {
namespace {

City painted_city() {
  City city = test::sample_city_with_facades();
  for (auto& facade : city.facades) facade.texture.clear();  // those that have one are left alone
  paint_textures(city, 1);
  return city;
}

class SampleCityMesh : public ::testing::Test {
 protected:
  RenderMesh mesh(int level, bool marks = false) const {
    CityMeshOptions options;
    options.level = level;
    options.marks_facades = marks;
    return city_mesh(index_, textures_of(city_), options);
  }
  View from_the_street(RenderMesh mesh) const {
    // In the eastern main street, northwards and a little down: the facade of b-5 is 5 m ahead.
    return render(RayScene(std::move(mesh)), camera_at({45, 0, 1.7}, {45, 5, 1.2}, 1, 80, 60), {80, 60, 4, 0.05, 1});
  }
  const City city_ = painted_city();
  const CityIndex index_{city_};
};

TEST_F(SampleCityMesh, StandsInThePlan) {
  const View view = from_the_street(mesh(1));
  const Camera camera = camera_at({45, 0, 1.7}, {45, 5, 1.2}, 1, 80, 60);
  const Vec3 wall = seen_at(camera, {44.5, 5, 2.4});
  EXPECT_NEAR(view.depth.at(static_cast<int>(wall[0] * 80), static_cast<int>(wall[1] * 60)), wall[2], 0.05);
  const Vec3 ground = seen_at(camera, {45, 4.5, 0});
  EXPECT_NEAR(view.depth.at(static_cast<int>(ground[0] * 80), static_cast<int>(ground[1] * 60)), ground[2], 0.2);
}

TEST_F(SampleCityMesh, EveryLevelHasTheSameOutlineOfItsWalls) {
  std::vector<View> views;
  for (int level = 1; level <= 4; ++level) views.push_back(from_the_street(mesh(level)));
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_NE(views[i].colour, views[i - 1].colour) << i;
    EXPECT_GT(silhouette_iou(views[0].coverage, views[i].coverage), 0.99) << i;
  }
  EXPECT_LT(mesh(1).triangles.size(), mesh(2).triangles.size());
  EXPECT_LT(mesh(2).triangles.size(), mesh(4).triangles.size());
}

TEST_F(SampleCityMesh, MarksFacadesAndNothingElse) {
  const View view = from_the_street(mesh(1, true));
  int white = 0, black = 0;
  for (std::size_t i = 0; i < view.colour.pixels.size(); ++i) {
    if (view.coverage.pixels[i] < 1) continue;
    const float v = view.colour.pixels[i][0];
    if (v == 1) ++white;
    if (v == 0) ++black;
  }
  EXPECT_GT(white, 500);
  EXPECT_GT(black, 200) << "ground";
}

TEST_F(SampleCityMesh, AMissingImageIsNamed) {
  City city = city_;
  city.textures.clear();
  const CityIndex index(city);
  try {
    city_mesh(index, textures_of(city), {});
    FAIL() << "expected an error";
  } catch (const CityError& error) {
    EXPECT_NE(std::string(error.what()).find("textures/"), std::string::npos) << error.what();
  }
}

TEST_F(SampleCityMesh, HoldsOnlyTheSectorsAskedFor) {
  CityMeshOptions options;
  options.sectors = {"s-yard"};
  const RenderMesh one = city_mesh(index_, textures_of(city_), options);
  EXPECT_LT(one.triangles.size(), mesh(4).triangles.size() / 2);
  EXPECT_FALSE(one.triangles.empty());
}

/// As in their files (x3d_export/far_windows.hpp): darker panes, and as light in the mean as level 1.
TEST_F(SampleCityMesh, FarSectorsHaveWindows) {
  std::vector<SectorPart> parts;
  for (const Sector& s : city_.sectors) parts.push_back({&s, Detail::far});
  const View far = from_the_street(parts_mesh(index_, cached(textures_of(city_)), parts)),
             plain = from_the_street(mesh(1));
  double sum_far = 0, sum_plain = 0, darkest = 1, lightest = 0, same = 0;
  int pixels = 0;
  for (int row = 5; row < 25; ++row)  // of the wall, above the door
    for (int column = 5; column < 75; ++column) {
      const double a = far.colour.at(column, row)[0], b = plain.colour.at(column, row)[0];
      sum_far += a;
      sum_plain += b;
      darkest = std::min(darkest, a);
      lightest = std::max(lightest, a);
      same += std::abs(a - b) < 0.01;
      ++pixels;
    }
  EXPECT_NEAR(sum_far / pixels, sum_plain / pixels, 0.06);
  EXPECT_LT(darkest, 0.6 * lightest);
  EXPECT_LT(same / pixels, 0.8) << "sky and roof beside it are";
}

// x3d_export states the colours of openings, sectorgen/models paints them: neither knows the other.
TEST(MeanColour, OfAnOpeningIsThatOfItsPainting) {
  for (std::size_t k = 0; k < kOpeningKinds; ++k) {
    const auto kind = static_cast<OpeningKind>(k);
    const Canvas tile = paint_tile(kind);
    double r = 0, g = 0, b = 0;
    for (int y = 0; y < tile.height(); ++y)
      for (int x = 0; x < tile.width(); ++x) {
        const Paint p = tile.at(x, y);
        r += p.r;
        g += p.g;
        b += p.b;
      }
    const double n = tile.width() * tile.height() / 255.0;
    EXPECT_NEAR(opening_colour(kind).r, r / n, 3) << k;
    EXPECT_NEAR(opening_colour(kind).g, g / n, 3) << k;
    EXPECT_NEAR(opening_colour(kind).b, b / n, 3) << k;
  }
}

TEST(MeanColour, OfAFacadeLiesBetweenWallAndOpenings) {
  Facade f;
  f.a = {12'000, 0};
  f.top_m = 12;
  f.floors = 4;
  f.bays = 5;
  const Colour wall{220, 200, 160}, mean = mean_colour(f, wall);
  EXPECT_LT(mean.r, wall.r);
  EXPECT_GT(mean.r, 140);
  f.floors = 1;
  EXPECT_GT(mean_colour(f, wall).r, mean.r) << "fewer windows";
}

}  // namespace
}  // namespace vicus
