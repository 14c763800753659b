#include "sectorgen/bake/impostors/bake_panorama.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "city_db/panorama_sides.hpp"
#include "sectorgen/bake/picture/png.hpp"
#include "sectorgen/bake/render/camera.hpp"

namespace vicus {
namespace {

PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

Sector sector(const char* id, SectorKind kind, double west, double south, double east, double north) {
  Sector s;
  s.id = id;
  s.kind = kind;
  s.ground = {{at(west, south), at(east, south), at(east, north), at(west, north)}, {}};
  s.ground_triangles = {0, 1, 2, 0, 2, 3};
  return s;
}

Visible seen(const char* from, const char* to) {
  Visible v;
  v.sector_id = from;
  v.visible_sector_id = to;
  return v;
}

/// The four walls of a house; its roof does not matter here.
void add_house(RenderMesh& mesh, double east, double north, double side, double top, Colour colour) {
  const double h = side / 2;
  const std::array<Vec3, 4> feet{
      {{east - h, north - h, 0}, {east + h, north - h, 0}, {east + h, north + h, 0}, {east - h, north + h, 0}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 a = feet[i], b = feet[(i + 1) % 4];
    const std::uint32_t p = mesh.add_point(a), q = mesh.add_point(b), r = mesh.add_point({b[0], b[1], top}),
                        s = mesh.add_point({a[0], a[1], top});
    RenderTriangle t;
    t.colour = colour;
    t.corners = {p, q, r};
    mesh.triangles.push_back(t);
    t.corners = {p, r, s};
    mesh.triangles.push_back(t);
  }
}

constexpr Colour kGrey{120, 120, 120}, kRed{200, 30, 30}, kGreen{30, 200, 30};

/// A square of 40 x 40 m; L_vis names the street whose houses of 10 m stand around it 40 m off. Beyond them a red tower
/// of 90 m, 400 m to the east, and a green house of 12 m, 250 m to the north, which they hide.
struct Quarter {
  City city;
  FarCity far;
};

Quarter quarter() {
  City city;
  city.sectors = {sector("a", SectorKind::square, -20, -20, 20, 20), sector("b", SectorKind::street, -60, -60, 60, -50),
                  sector("c", SectorKind::street, 380, -10, 390, 10)};
  city.visible.push_back(seen("a", "a"));
  city.visible.push_back(seen("a", "b"));
  RenderMesh mesh;
  std::vector<std::uint32_t> first{0, 0};
  for (int i = -3; i <= 3; ++i)
    for (const auto& [x, y] : {std::pair(20.0 * i, 60.0), {20.0 * i, -60.0}, {60.0, 20.0 * i}, {-60.0, 20.0 * i}})
      add_house(mesh, x, y, 20, 10, kGrey);
  first.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
  add_house(mesh, 400, 0, 20, 90, kRed);
  add_house(mesh, 0, 250, 20, 12, kGreen);
  first.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
  return {std::move(city), {RayScene(std::move(mesh)), std::move(first)}};
}

TEST(Panorama, ShowsWhatLVisDoesNotNameWhereItIs) {
  const Quarter q = quarter();
  PanoramaOptions options;
  options.threads = 1;
  const auto panoramas = bake_panoramas(q.city, q.far, options);
  ASSERT_EQ(panoramas.size(), 1u);
  const Panorama& p = panoramas.front();
  EXPECT_EQ(p.sector_id, "a");
  EXPECT_GE(p.near_m, options.nearest_m);
  EXPECT_NEAR(p.near_m, 400 - 10 - metres(p.eye.x), 12);
  // East is four sixteenths of a turn: the tower stands on the sides before and behind it, the hidden house nowhere.
  EXPECT_EQ(p.sides, (1u << 3) | (1u << 4));
  const CutOut picture = read_png(p.png);
  ASSERT_EQ(picture.width, static_cast<int>(p.width_px));
  EXPECT_EQ(p.width_px, 2u * 128);
  int red = 0, green = 0;
  for (const Rgba& c : picture.pixels) {
    red += c[3] > 0.5f && c[0] > 2 * c[1];
    green += c[3] > 0.5f && c[1] > 2 * c[0];
  }
  EXPECT_GT(red, 100);
  EXPECT_EQ(green, 0);
  // Where the tower's top is seen from the eye, there it is in the picture.
  const Enu eye{metres(p.eye.x), metres(p.eye.y), p.eye_up_m};
  for (const PanoramaSide& side : sides_of(p)) {
    const Camera camera = camera_through(eye, {metres(side.left.x), metres(side.left.y), 0},
                                         {metres(side.right.x), metres(side.right.y), 0}, p.bottom_m, p.top_m);
    const auto is_red = [&](const Vec3& place) {
      const Vec3 seen = seen_at(camera, place);
      if (seen[0] < 0 || seen[0] >= 1) return true;  // on the other side
      const double u = side.u_left + seen[0] * (side.u_right - side.u_left);
      return picture.at(static_cast<int>(u * picture.width), static_cast<int>(seen[1] * picture.height))[3] > 0.5f;
    };
    for (const double north : {-7.0, 7.0}) EXPECT_TRUE(is_red({390, north, 80})) << side.number << ' ' << north;
    EXPECT_FALSE(picture.at(static_cast<int>((side.u_left + side.u_right) / 2 * picture.width), 0)[3] > 0.5f);
  }
}

TEST(Panorama, IsForOpenSectorsWithSomethingBeyondTheirListsAlone) {
  Quarter q = quarter();
  PanoramaOptions options;
  options.least_ground_m2 = 1601;
  EXPECT_TRUE(bake_panoramas(q.city, q.far, options).empty()) << "too small";
  q.city.sectors[0].kind = SectorKind::street;
  EXPECT_TRUE(bake_panoramas(q.city, q.far, {}).empty()) << "a street";
  q.city.sectors[0].kind = SectorKind::open;
  EXPECT_EQ(bake_panoramas(q.city, q.far, {}).size(), 1u);
  options = {};
  options.nearest_m = 450;
  EXPECT_TRUE(bake_panoramas(q.city, q.far, options).empty()) << "all is nearer";
  q.city.visible.push_back(seen("a", "c"));
  EXPECT_TRUE(bake_panoramas(q.city, q.far, {}).empty()) << "the tower comes itself";
}

TEST(Panorama, StandsBehindAllThatLVisNames) {
  Quarter q = quarter();
  q.city.sectors[1] = sector("b", SectorKind::street, -60, -2000, 60, -50);
  const auto panoramas = bake_panoramas(q.city, q.far, {});
  ASSERT_EQ(panoramas.size(), 1u);
  EXPECT_GT(panoramas.front().radius_m * std::cos(std::numbers::pi / kPanoramaSides), 2000);
}

TEST(Panorama, IsTheSameOnAnyNumberOfThreads) {
  const Quarter q = quarter();
  PanoramaOptions one, two;
  one.threads = 1;
  two.threads = 2;
  EXPECT_EQ(bake_panoramas(q.city, q.far, one).front().png, bake_panoramas(q.city, q.far, two).front().png);
}

}  // namespace
}  // namespace vicus
