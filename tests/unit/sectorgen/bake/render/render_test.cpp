#include "sectorgen/bake/render/render.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sectorgen/bake/render/shading.hpp"

namespace vicus {
namespace {

constexpr Colour kRed{200, 40, 20};

void add_quad(RenderMesh& mesh, Vec3 a, Vec3 b, Vec3 c, Vec3 d, RenderTriangle look = {}) {
  const std::array corners{mesh.add_point(a), mesh.add_point(b), mesh.add_point(c), mesh.add_point(d)};
  for (const auto& [j, k] : {std::pair(1, 2), std::pair(2, 3)}) {
    look.corners = {corners[0], corners[static_cast<std::size_t>(j)], corners[static_cast<std::size_t>(k)]};
    mesh.triangles.push_back(look);
    if (look.image != kNoImage) ++look.places;
  }
}

/// From (x0, y0, z0) to (x1, y1, z1), seen from outside.
RenderMesh box(Vec3 low, Vec3 high, Colour colour = kRed) {
  RenderMesh mesh;
  RenderTriangle look;
  look.colour = colour;
  const auto at = [&](int x, int y, int z) {
    return Vec3{x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2]};
  };
  add_quad(mesh, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1), look);  // south
  add_quad(mesh, at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), look);  // north
  add_quad(mesh, at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1), look);  // east
  add_quad(mesh, at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), look);  // west
  add_quad(mesh, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1), look);  // top
  add_quad(mesh, at(0, 1, 0), at(1, 1, 0), at(1, 0, 0), at(0, 0, 0), look);  // bottom
  return mesh;
}

/// 90 degrees wide: a place x beside and d ahead is seen at x / d.
constexpr double kRight = 1.5707963267948966;

TEST(Render, ABoxStandsWhereItsCornersSay) {
  // Its southern face, 2 m wide, 1 m high, is 4 m ahead of the eye: a half of the window's width, a quarter of its
  // height.
  const RayScene scene(box({-1, 4, 0}, {1, 6, 1}));
  const View view = render(scene, camera_at({0, 0, 1}, {0, 1, 1}, kRight, 64, 64), {64, 64, 4, 0.05, 1});
  double covered = 0;
  for (const float c : view.coverage.pixels) covered += c;
  EXPECT_NEAR(covered / (64 * 64), 0.25 * 0.125, 1e-6);
  EXPECT_EQ(view.coverage.at(24, 32), 1);
  EXPECT_EQ(view.coverage.at(23, 32), 0);
  EXPECT_EQ(view.coverage.at(39, 39), 1);
  EXPECT_EQ(view.coverage.at(40, 39), 0);
  EXPECT_EQ(view.coverage.at(32, 31), 0) << "the eye is level with the top";
  EXPECT_EQ(view.coverage.at(32, 40), 0);
  EXPECT_NEAR(view.depth.at(28, 36), 4, 1e-5);
  EXPECT_TRUE(std::isinf(view.depth.at(20, 10)));
}

TEST(Render, AFaceIsLitByWhatShinesOnIt) {
  const RayScene scene(box({-1, 4, 0}, {1, 6, 1}));
  const View view = render(scene, camera_at({0, 0, 1}, {0, 1, 1}, kRight, 64, 64), {64, 64, 4, 0.05, 1});
  // The southern face looks along +z of X3D: lights that go towards -z reach it. Their lengths: 0.6 -0.65 -0.5 and
  // -0.6 0.15 -0.25.
  const double light = 1.0 * 0.5 / std::sqrt(0.36 + 0.4225 + 0.25) + 0.68 * 0.25 / std::sqrt(0.36 + 0.0225 + 0.0625);
  EXPECT_NEAR(light_on({0, -1, 0}), light, 1e-12);
  EXPECT_NEAR(view.colour.at(32, 36)[0], light * 200 / 255, 1e-5);
  EXPECT_NEAR(view.colour.at(32, 36)[2], light * 20 / 255, 1e-5);
}

TEST(Render, SkyIsTheRootWorldsBackground) {
  const Rgb zenith = sky_colour({0, 0, 1}), horizon = sky_colour({1, 0, 0}), nadir = sky_colour({0, 0, -2});
  EXPECT_NEAR(zenith[0], 92 / 255.0, 1e-6);
  EXPECT_NEAR(horizon[2], 228 / 255.0, 1e-6);
  EXPECT_NEAR(nadir[1], 118 / 255.0, 1e-6);
  for (double angle = 0; angle < 1.57; angle += 0.01) {  // as smooth as the square of a sine
    const double share = std::sin(angle) * std::sin(angle);
    EXPECT_NEAR(sky_colour({std::sin(angle), 0, std::cos(angle)})[0], (92 + share * (196 - 92)) / 255, 2.0 / 255);
  }
}

TEST(Render, FromInsideABoxOneSeesOut) {
  const RayScene scene(box({-1, -1, -1}, {1, 1, 1}));
  const View view = render(scene, camera_at({0, 0, 0}, {0, 1, 0}, 1, 8, 8), {8, 8, 1, 0.05, 1});
  for (const float c : view.coverage.pixels) EXPECT_EQ(c, 0);
}

TEST(Render, WhatIsNearerThanTheNearPlaneIsNotThere) {
  RenderMesh mesh = box({-1, 4, 0}, {1, 6, 1});
  const RenderMesh behind = box({-1, 10, 0}, {1, 12, 1});
  const auto base = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), behind.points.begin(), behind.points.end());
  for (RenderTriangle t : behind.triangles) {
    for (auto& c : t.corners) c += base;
    mesh.triangles.push_back(t);
  }
  const RayScene scene(std::move(mesh));
  const Camera camera = camera_at({0, 0, 0.5}, {0, 1, 0.5}, kRight, 9, 9);
  EXPECT_NEAR(render(scene, camera, {9, 9, 1, 0.05, 1}).depth.at(4, 4), 4, 1e-5);
  EXPECT_NEAR(render(scene, camera, {9, 9, 1, 7, 1}).depth.at(4, 4), 10, 1e-5);
}

TEST(Render, FarImagesAreTheirMeanAndNearOnesTheirPixels) {
  RenderMesh mesh;
  CutOut checks(2, 2);
  checks.pixels = {{1, 1, 1, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}};
  mesh.images.push_back(std::make_shared<RepeatedImage>(checks));
  RenderTriangle look;
  look.image = 0;
  look.is_lit = false;
  mesh.places = {{{{0, 0}, {50, 0}, {50, 50}}}, {{{0, 0}, {50, 50}, {0, 50}}}};
  add_quad(mesh, {-50, 100, -50}, {50, 100, -50}, {50, 100, 50}, {-50, 100, 50}, look);
  const RayScene scene(std::move(mesh));
  const View far = render(scene, camera_at({0, 0, 0}, {0, 1, 0}, 0.9, 8, 8), {8, 8, 1, 0.05, 1});
  for (const Rgb& p : far.colour.pixels) EXPECT_NEAR(p[0], 0.5, 0.06);
  const View near = render(scene, camera_at({0.5, 99.9, 0.5}, {0.5, 100, 0.5}, 0.2, 4, 4), {4, 4, 1, 0.001, 1});
  for (const Rgb& p : near.colour.pixels) EXPECT_LT(std::min(p[0], 1 - p[0]), 0.02f);
}

TEST(Render, CutOutsLetThroughWhatIsBehind) {
  RenderMesh mesh = box({-1, 4, -1}, {1, 6, 1});
  CutOut half(1, 1);
  half.pixels = {{0, 0, 1, 0.25f}};
  mesh.images.push_back(std::make_shared<RepeatedImage>(half));
  mesh.places = {{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}};
  RenderTriangle look;
  look.image = 0;
  look.is_lit = false;
  add_quad(mesh, {-3, 2, -3}, {3, 2, -3}, {3, 2, 3}, {-3, 2, 3}, look);
  const RayScene scene(std::move(mesh));
  const View view = render(scene, camera_at({0, 0, 0}, {0, 1, 0}, kRight, 32, 32), {32, 32, 1, 0.05, 1});
  const auto red = static_cast<float>(light_on({0, -1, 0}) * 200 / 255),
             blue = static_cast<float>(light_on({0, -1, 0}) * 20 / 255);
  EXPECT_NEAR(view.colour.at(16, 16)[0], 0.75f * red, 1e-5);
  EXPECT_NEAR(view.colour.at(16, 16)[2], 0.25f + 0.75f * blue, 1e-5);
  EXPECT_EQ(view.coverage.at(16, 16), 1);
  EXPECT_NEAR(view.coverage.at(1, 1), 0.25, 1e-6);
}

TEST(Render, ThreadsDoNotChangeAByte) {
  const RayScene scene(box({-1, 4, 0}, {1, 6, 1}));
  const Camera camera = camera_at({0.3, 0, 1.7}, {0.1, 5, 0.5}, 0.8, 50, 40);
  const View one = render(scene, camera, {50, 40, 9, 0.05, 1}), three = render(scene, camera, {50, 40, 9, 0.05, 3});
  EXPECT_EQ(one.colour, three.colour);
  EXPECT_EQ(one.depth, three.depth);
}

TEST(Camera, ThroughAGateItsCornersAreThePicturesCorners) {
  const Vec3 left{3, 10, 0}, right{7, 8, 0};
  const Camera camera = camera_through({1, 1, 1.7}, left, right, -0.5, 6);
  const auto expect = [&](Vec3 place, double x, double y) {
    const Vec3 seen = seen_at(camera, place);
    EXPECT_NEAR(seen[0], x, 1e-12);
    EXPECT_NEAR(seen[1], y, 1e-12);
    EXPECT_GT(seen[2], 0);
  };
  expect({3, 10, 6}, 0, 0);
  expect({7, 8, 6}, 1, 0);
  expect({3, 10, -0.5}, 0, 1);
  expect({7, 8, -0.5}, 1, 1);
  expect({5, 9, 2.75}, 0.5, 0.5);
}

/// Moeller and Trumbore, each triangle for itself.
double slow_hit(const RenderMesh& mesh, const Vec3& from, const Vec3& way) {
  double best = INFINITY;
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) {
      const auto& p = mesh.points[t.corners[k]];
      return Vec3{p[0], p[1], p[2]};
    };
    const Vec3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), p = cross(way, e2);
    const double det = dot(e1, p);
    if (det <= 0 && !t.is_two_sided) continue;
    const Vec3 s = from - corner(0), q = cross(s, e1);
    const double u = dot(s, p) / det, v = dot(way, q) / det, hit = dot(e2, q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && hit > 0.05) best = std::min(best, hit);
  }
  return best;
}

TEST(RayScene, FindsTheFirstFaceThatShowsItself) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  RenderMesh mesh;
  for (int i = 0; i < 200; ++i) {
    RenderTriangle t;
    for (auto& corner : t.corners) corner = mesh.add_point({5 * unit(random), 5 * unit(random), 5 * unit(random)});
    t.is_two_sided = i % 3 == 0;
    mesh.triangles.push_back(t);
  }
  const RayScene scene(mesh);
  int hits = 0, differ = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 from{8 * unit(random), 8 * unit(random), 8 * unit(random)},
        way{unit(random), unit(random), unit(random)};
    const auto hit = scene.first_hit(from, way, 0.05);
    const double expected = slow_hit(mesh, from, way);
    if (std::isfinite(expected) != hit.has_value()) {
      ++differ;  // grazes an edge
    } else if (hit) {
      ++hits;
      EXPECT_NEAR(hit->t, expected, 1e-4 * (1 + expected));
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_LE(differ, 2);
}

TEST(RepeatedImage, MeansAreIntegralsOfItsPixels) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  CutOut picture(5, 3);
  for (Rgba& p : picture.pixels) p = {static_cast<float>(unit(random)), 0, 0, 1};
  const RepeatedImage image(picture);
  for (int i = 0; i < 100; ++i) {
    const double u = 6 * unit(random) - 3, v = 6 * unit(random) - 3;
    const double us = std::max(0.2, 3 * unit(random)), vs = std::max(1.0 / 3, 3 * unit(random));
    double sum = 0;
    constexpr int kSteps = 400;
    for (int j = 0; j < kSteps; ++j)
      for (int k = 0; k < kSteps; ++k) {
        const double x = u + us * ((j + 0.5) / kSteps - 0.5), y = v + vs * ((k + 0.5) / kSteps - 0.5);
        const int column = static_cast<int>((x - std::floor(x)) * 5),
                  row = 2 - static_cast<int>((y - std::floor(y)) * 3);
        sum += picture.at(column, row)[0];
      }
    EXPECT_NEAR(image.mean(u, v, us, vs)[0], sum / (kSteps * kSteps), 4e-3) << u << " " << v << " " << us << " " << vs;
  }
}

}  // namespace
}  // namespace vicus
