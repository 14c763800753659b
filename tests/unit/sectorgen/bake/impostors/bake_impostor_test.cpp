#include "sectorgen/bake/impostors/bake_impostor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cli/city_mesh.hpp"
#include "sectorgen/bake/impostors/capture_point.hpp"
#include "sectorgen/bake/picture/png.hpp"

namespace vicus {
namespace {

PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

/// A street from the west to its gate at x = 0, 20 m long, 6 m wide; behind the gate another, and in that a red wall 4
/// m high, 10 m behind the gate, across the northern half. A side street goes off at its western end.
City street() {
  City city;
  Sector a, b;
  a.id = "a";
  a.ground = {{at(-20, -3), at(0, -3), at(0, 3), at(-14, 3), at(-14, 15), at(-20, 15)}, {}};
  a.ground_triangles = {0, 1, 2, 0, 2, 3, 0, 3, 5, 3, 4, 5};
  a.origin = at(-10, 0);
  b.id = "b";
  b.ground = {{at(0, -3), at(30, -3), at(30, 3), at(0, 3)}, {}};
  b.ground_triangles = {0, 1, 2, 0, 2, 3};
  b.origin = at(15, 0);
  city.sectors = {a, b};
  city.gates = {{"ab", "a", "b", "ba", GateKind::street, {at(0, -3), at(0, 3)}},
                {"ba", "b", "a", "ab", GateKind::street, {at(0, 3), at(0, -3)}},
                {"b-out", "b", "", "", GateKind::end_of_city, {at(30, -3), at(30, 3)}}};
  city.borders = {{"b", "", BorderKind::wall, 4, {at(10, 0), at(10, 3)}}};
  return city;
}

class StreetImpostors : public ::testing::Test {
 protected:
  const City city_ = street();
  const CityGround ground_{city_};
  const RayScene scene_{city_mesh(CityIndex(city_), textures_of(city_), {})};
};

TEST_F(StreetImpostors, TheCapturePointIsTheFarthestThatSeesTheWholeGate) {
  const PlanPoint p = capture_point(city_.sectors[0], city_.gates[0]);
  EXPECT_LT(p.x, lattice_mm(-19));
  EXPECT_LT(std::abs(p.y), lattice_mm(3));
  const PlanPoint half = capture_point(city_.sectors[0], city_.gates[0], 0.5);
  EXPECT_NEAR(half.x, p.x / 2.0, 1);
}

TEST_F(StreetImpostors, WhatIsSeenThroughTheGateIsInThePicture) {
  ImpostorOptions options;
  options.colours = 256;
  const auto impostor = bake_impostor(ground_, scene_, city_.gates[0], options);
  ASSERT_TRUE(impostor);
  EXPECT_EQ(impostor->left, at(0, 3));
  EXPECT_EQ(impostor->right, at(0, -3));
  EXPECT_FALSE(impostor->is_solid);
  const double eye_m = -metres(impostor->eye.x);
  // The wall at the end of the city, 15 m high, is the farthest; the ground behind the gate the nearest.
  EXPECT_NEAR(impostor->far_m, eye_m + 30, 0.01);
  EXPECT_NEAR(impostor->near_m, eye_m, 1);
  EXPECT_NEAR(impostor->plane_m, eye_m, 1e-6);
  const CutOut picture = read_png(impostor->png);
  ASSERT_EQ(picture.width, static_cast<int>(impostor->width_px));
  const Camera camera = camera_through({metres(impostor->eye.x), metres(impostor->eye.y), impostor->eye_up_m},
                                       {0, 3, 0}, {0, -3, 0}, impostor->bottom_m, impostor->top_m);
  const auto pixel = [&](const Vec3& place) {
    const Vec3 seen = seen_at(camera, place);
    return picture.at(static_cast<int>(seen[0] * picture.width), static_cast<int>(seen[1] * picture.height));
  };
  const Rgba wall = pixel({10, 1, 2}), end = pixel({30, -2, 3});
  EXPECT_GT(wall[0], wall[2]) << "the wall is brown";
  EXPECT_GT(end[2], end[0]) << "the end of the city has the colour of the sky";
  EXPECT_EQ(wall[3], 1);
  EXPECT_EQ(picture.at(picture.width / 2, picture.height - 1)[3], 1) << "ground";
}

TEST_F(StreetImpostors, TheBestPlaneStandsAtTheMeanOfInverseDepths) {
  ImpostorOptions options;
  options.plane = ImpostorPlane::best;
  const auto impostor = bake_impostor(ground_, scene_, city_.gates[0], options);
  ASSERT_TRUE(impostor);
  EXPECT_NEAR(1 / impostor->plane_m, (1 / impostor->near_m + 1 / impostor->far_m) / 2, 1e-9);
  // The picture fills the gate seen from the capture point: its corners are on the rays through the gate's.
  const double k = impostor->plane_m / -metres(impostor->eye.x);
  EXPECT_NEAR(metres(impostor->left.y - impostor->eye.y), k * (3 - metres(impostor->eye.y)), 2e-3);
  EXPECT_NEAR(displacement_px(kViewUnit_px, impostor->radius_m, impostor->plane_m, impostor->near_m), kValid_px, 1e-6);
  EXPECT_NEAR(displacement_px(kViewUnit_px, impostor->radius_m, impostor->plane_m, impostor->far_m), kValid_px, 1e-6);
}

// Research: with 50, 200, 500 m before the nearest thing and the horizon behind, 2 px are 0.35, 1.4, 3.5 m at f = 579.
TEST(Displacement, IsThatOfTheFormula) {
  for (const auto& [near, radius] : {std::pair(50.0, 0.3454), std::pair(200.0, 1.3817), std::pair(500.0, 3.4542)})
    EXPECT_NEAR(displacement_px(579, radius, 2 * near, near), 2, 1e-3);
}

TEST_F(StreetImpostors, AnEndOfTheCityIsSolid) {
  const auto impostor = bake_impostor(ground_, scene_, city_.gates[2], {});
  ASSERT_TRUE(impostor);
  EXPECT_TRUE(impostor->is_solid);
  EXPECT_GE(impostor->top_m, 15);
  const CutOut picture = read_png(impostor->png);
  for (const Rgba& p : picture.pixels) EXPECT_EQ(p[3], 1);
  const Rgba sky = picture.at(picture.width / 2, 0), ground = picture.at(picture.width / 2, picture.height - 1);
  EXPECT_GT(sky[2], sky[0]);
  EXPECT_NE(ground, sky);
}

TEST_F(StreetImpostors, EqualForAnyNumberOfThreads) {
  ImpostorOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const auto a = bake_impostors(city_, scene_, one), b = bake_impostors(city_, scene_, three);
  ASSERT_EQ(a.size(), 3u);
  ASSERT_EQ(b.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(a[i].gate_id, city_.gates[i].id);
    EXPECT_EQ(a[i].png, b[i].png);
    EXPECT_EQ(a[i].radius_m, b[i].radius_m);
  }
}

}  // namespace
}  // namespace vicus
