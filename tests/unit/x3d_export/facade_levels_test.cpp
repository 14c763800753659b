#include "x3d_export/facade_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace vicus {
namespace {

using Vec = std::array<double, 3>;

Vec metres_of(const X3dPoint& p) { return {metres(p.x), metres(p.y), metres(p.z)}; }

/// Area vector of a planar polygon: its length is the area, its direction the normal.
template <class F>
Vec area_of(const F& face, std::size_t corners) {
  Vec sum{};
  const Vec o = metres_of(face.corners[0]);
  for (std::size_t i = 1; i + 1 < corners; ++i) {
    const Vec p = metres_of(face.corners[i]), q = metres_of(face.corners[i + 1]);
    const Vec u{p[0] - o[0], p[1] - o[1], p[2] - o[2]}, v{q[0] - o[0], q[1] - o[1], q[2] - o[2]};
    sum[0] += (u[1] * v[2] - u[2] * v[1]) / 2;
    sum[1] += (u[2] * v[0] - u[0] * v[2]) / 2;
    sum[2] += (u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return sum;
}

/// Faces south (X3D +z), 12.5 m long; x of the layout is X3D x.
Facade south_front(FacadeStyle style, int floors, int bays) {
  Facade f;
  f.b = {0, 0};
  f.a = {12'500, 0};
  f.style = style;
  f.floors = floors;
  f.bays = bays;
  f.top_m = 15;
  f.door_bay = 0;
  f.texture = "t";
  return f;
}

struct Built {
  LevelFaces levels[4];
};

Built built(const Facade& facade) {
  Built out;
  add_facade(facade, {200, 180, 160}, 0, {0, 0}, 0, out.levels);
  return out;
}

class EachStyle : public testing::TestWithParam<FacadeStyle> {};

TEST_P(EachStyle, TheDeepWallAndItsOpeningsCoverTheFrontOnce) {
  const Facade f =
      south_front(GetParam(), GetParam() == FacadeStyle::church || GetParam() == FacadeStyle::shed ? 1 : 4, 5);
  const LevelFaces level = built(f).levels[3];
  double wall = 0, openings = 0;
  for (const TexturedFace& face : level.own_images.begin()->second) {
    const Vec area = area_of(face, 4);
    EXPECT_GT(area[2], 0) << "a piece of wall looks into the house";
    EXPECT_NEAR(area[0], 0, 1e-9);
    wall += area[2];
  }
  for (const TexturedFace& face : level.atlas) {
    openings += area_of(face, 4)[2];
    EXPECT_NEAR(metres(face.corners[0].z), -figures_of(f.style).depth, 0.0011) << "an opening not at its depth";
  }
  EXPECT_NEAR(wall + openings, 12.5 * 15, 0.05);
  EXPECT_GT(openings, 1);
}

TEST_P(EachStyle, ImagesOfTheDeepWallLieWhereTheWholeImageHasThem) {
  const Facade f = south_front(GetParam(), 1, 5);
  const Built b = built(f);
  for (const TexturedFace& face : b.levels[3].own_images.begin()->second)
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(face.uv[k][0], metres(face.corners[k].x) / 12.5, 1e-4);
      EXPECT_NEAR(face.uv[k][1], metres(face.corners[k].y) / 15, 1e-4);
    }
}

TEST_P(EachStyle, ReliefKeepsThePolygonsOfLevelThreeNearLevelTwo) {
  const Facade f = south_front(GetParam(), 4, 5);
  const Built b = built(f);
  EXPECT_LE(b.levels[2].triangles(), b.levels[1].triangles());
  EXPECT_GE(b.levels[3].triangles(), b.levels[1].triangles());
  EXPECT_EQ(b.levels[0].triangles(), 2u);
}

INSTANTIATE_TEST_SUITE_P(All, EachStyle,
                         testing::Values(FacadeStyle::plaster, FacadeStyle::stone, FacadeStyle::brick,
                                         FacadeStyle::modern, FacadeStyle::church, FacadeStyle::shed),
                         [](const auto& info) { return std::string(name_of(info.param)); });

/// Windows of a staircase stand between the storeys: no rows.
TEST(AddFacade, OwnOpeningsAreTheSameInAllLevels) {
  Facade f = south_front(FacadeStyle::plaster, 2, 2);
  f.openings = {{OpeningKind::house_door, 1, 2, 0, 2.1, 0, 0, 0.3},
                {OpeningKind::window, 4, 5, 1, 2.5, 0, 1, 0.1},
                {OpeningKind::window, 7, 8, 2, 3.5, 0, 2, 0.1},
                {OpeningKind::window, 4.5, 5.5, 4, 5, 1, 3, 0.2}};
  const double sum = 2.1 + 1.5 + 1.5 + 1;
  const Built b = built(f);
  double quads = 0, deep = 0, wall = 0;
  for (const TexturedFace& face : b.levels[1].atlas) quads += area_of(face, 4)[2];
  EXPECT_NEAR(quads, sum, 0.01);
  EXPECT_TRUE(b.levels[2].atlas.empty()) << "its image has the door";
  ASSERT_EQ(b.levels[3].atlas.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    deep += area_of(b.levels[3].atlas[i], 4)[2];
    EXPECT_NEAR(metres(b.levels[3].atlas[i].corners[0].z), -f.openings[i].depth, 0.0011);
  }
  for (const TexturedFace& face : b.levels[3].own_images.at("t")) wall += area_of(face, 4)[2];
  EXPECT_NEAR(deep, sum, 0.01);
  EXPECT_NEAR(wall + deep, 12.5 * 15, 0.05);
}

TEST(AddFacade, QuadsStandBeforeTheWallAtTheOpenings) {
  const Facade f = south_front(FacadeStyle::stone, 4, 5);
  const LevelFaces level = built(f).levels[1];
  const auto openings = openings_of(f);
  ASSERT_EQ(level.atlas.size(), openings.size());
  double area = 0, expected = 0;
  for (const TexturedFace& face : level.atlas) {
    EXPECT_NEAR(metres(face.corners[0].z), kQuadOffset_m, 0.0011);
    EXPECT_GT(area_of(face, 4)[2], 0);
    area += area_of(face, 4)[2];
  }
  for (const Opening& o : openings) expected += (o.x1 - o.x0) * (o.z1 - o.z0);
  EXPECT_NEAR(area, expected, 0.1);
}

/// What is behind the wall is closed: seen from the front, the sides of each recess look towards its middle.
TEST(AddFacade, RecessesAreSeenFromOutside) {
  Facade f = south_front(FacadeStyle::plaster, 1, 1);
  f.door_bay = -1;
  f.top_m = pattern_height_m(f);
  const LevelFaces level = built(f).levels[3];
  Vec sum{};
  int sides = 0;
  for (const Face& face : level.solid) {
    const Vec area = area_of(face, static_cast<std::size_t>(face.count));
    if (std::any_of(face.corners.begin(), face.corners.end(), [](const X3dPoint& p) { return p.z > 0; })) continue;
    ++sides;
    for (std::size_t i = 0; i < 3; ++i) sum[i] += area[i];
    const Vec c = metres_of(face.corners[0]);
    const double middle_x = 6.25, side_x = c[0] - middle_x;
    if (std::abs(area[0]) > 1e-6) {
      EXPECT_LT(area[0] * side_x, 0) << "a jamb looks away from the opening";
    }
  }
  EXPECT_EQ(sides, 4);
  for (const double v : sum) EXPECT_NEAR(v, 0, 1e-3);
}

TEST(SplitFacade, PiecesHaveTheOpeningsOfTheWhole) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
    Facade f;
    f.b = {pick(-99'999, 99'999), pick(-99'999, 99'999)};
    f.a = {f.b.x + pick(20'000, 200'000), f.b.y + pick(-99'999, 99'999)};
    f.top_m = 12;
    f.floors = pick(1, 6);
    f.bays = pick(1, 8);
    f.repeats = pick(1, 9);
    f.door_bay = pick(-1, f.bays - 1);
    const auto pieces = split_facade(f, 60);
    EXPECT_EQ(pieces.front().b, f.b);
    EXPECT_EQ(pieces.back().a, f.a);
    const auto whole = openings_of(f);
    std::size_t count = 0;
    double left = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i > 0) {
        EXPECT_EQ(pieces[i].b, pieces[i - 1].a);
      }
      EXPECT_TRUE(pieces[i].repeats == 1 || pieces[i].repeats * f.bays * f.floors <= 60) << "seed " << seed;
      for (const Opening& o : openings_of(pieces[i])) {
        ASSERT_LT(count, whole.size());
        EXPECT_NEAR(left + o.x0, whole[count].x0, 0.01) << "seed " << seed;
        EXPECT_EQ(o.kind, whole[count++].kind);
      }
      left += length_m(pieces[i]);
    }
    EXPECT_EQ(count, whole.size());
  }
}

/// What a depth buffer of 24 bits holds for a place so far ahead; browsers' near plane is half of the avatar's radius.
std::int64_t depth_step(double ahead_m) {
  constexpr double kNear_m = 0.125, kFar_m = 10'000;
  const double z = kFar_m / (kFar_m - kNear_m) * (1 - kNear_m / ahead_m);
  return std::llround(z * ((1 << 24) - 1));
}

// Where level 2 is shown its windows are at least a step of the depth buffer before the wall, from any side.
TEST(FacadeLevels, WindowsOfLevel2DoNotFlickerAt200Metres) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Facade f = south_front(FacadeStyle::plaster, 4, 5);
    const double turn = 6.283 * unit(random);
    f.a = {static_cast<std::int32_t>(12'500 * std::cos(turn)), static_cast<std::int32_t>(12'500 * std::sin(turn))};
    const LevelFaces level = built(f).levels[1];
    const Face& wall = level.solid.front();
    Vec normal = area_of(wall, 4);
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& v : normal) v /= length;
    const Vec foot = metres_of(wall.corners[0]);
    // An eye 200 m away, from straight before the wall to 80 degrees aside; it looks at the house.
    const double aside = 2.8 * (unit(random) - 0.5);
    const Vec side{normal[2], 0, -normal[0]};
    Vec eye{}, ahead{};
    for (std::size_t k = 0; k < 3; ++k) {
      ahead[k] = -(normal[k] * std::cos(aside) + side[k] * std::sin(aside));
      eye[k] = foot[k] - 200 * ahead[k];
    }
    const auto dot = [](const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    for (const TexturedFace& quad : level.atlas)
      for (const X3dPoint& corner : quad.corners) {
        const Vec p = metres_of(corner);
        const Vec way{p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]},
            to_foot{foot[0] - eye[0], foot[1] - eye[1], foot[2] - eye[2]};
        const double share = dot(to_foot, normal) / dot(way, normal);  // of the way to the wall
        EXPECT_GT(depth_step(share * dot(way, ahead)), depth_step(dot(way, ahead)));
      }
  }
}

}  // namespace
}  // namespace vicus
