#include "x3d_export/roof_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "city_db/gables.hpp"

namespace vicus {
namespace {

/// 10 x 6 m, eave at 4 m, a level roof at 7 m: gables of 3 m all round; the southern one has a pediment of 2 m more.
Building house_with_pediment() {
  Building house;
  house.footprint.outer = {{0, 0}, {10'000, 0}, {10'000, 6'000}, {0, 6'000}};
  house.eave_m = 4;
  house.height_m = 9;
  const auto add = [&](std::initializer_list<RoofPoint> corners, FacetKind kind) {
    RoofFacet facet{kind, {{}}, {}};
    for (const RoofPoint& p : corners) {
      facet.rings[0].push_back(static_cast<std::uint32_t>(house.roof.points.size()));
      house.roof.points.push_back(p);
    }
    for (std::uint32_t i = 2; i < facet.rings[0].size(); ++i)
      facet.triangles.insert(facet.triangles.end(), {facet.rings[0][0], facet.rings[0][i - 1], facet.rings[0][i]});
    house.roof.facets.push_back(facet);
  };
  const auto& p = house.footprint.outer;
  add({{p[0], 40'000}, {p[1], 40'000}, {p[1], 70'000}, {{5'000, 0}, 90'000}, {p[0], 70'000}}, FacetKind::gable);
  for (const std::size_t i : {1u, 2u})
    add({{p[i], 40'000}, {p[i + 1], 40'000}, {p[i + 1], 70'000}, {p[i], 70'000}}, FacetKind::gable);
  // A triangle: no rectangle in it.
  add({{p[3], 40'000}, {p[0], 40'000}, {{0, 3'000}, 70'000}}, FacetKind::gable);
  return house;
}

double area_m2(const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& f : faces)
    for (int i = 2; i < f.count; ++i) {
      const auto vector_to = [&](int k) {
        const X3dPoint &o = f.corners[0], &q = f.corners[static_cast<std::size_t>(k)];
        return std::array{metres(q.x - o.x), metres(q.y - o.y), metres(q.z - o.z)};
      };
      const auto u = vector_to(i - 1), v = vector_to(i);
      sum += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
    }
  return sum;
}

TEST(FullWalls, AreTheRectanglesOfGables) {
  const auto walls = full_walls(house_with_pediment());
  ASSERT_EQ(walls.size(), 3u);
  for (const auto& [edge, top_m] : walls) EXPECT_EQ(top_m, 7);
  EXPECT_FALSE(walls.contains({{0, 6'000}, {0, 0}}));
}

/// A wall from west to east, seen from the south, over a low roof that rises from 5 to 6 m, up to a high one that rises
/// from 8 to 9 m.
Building house_with_step() {
  Building house;
  house.eave_m = 4;
  const auto up = [](double m) { return static_cast<std::int32_t>(std::lround(m * kRoofStepsPerMetre)); };
  house.roof.points = {{{0, 0}, up(5)}, {{10'000, 0}, up(6)}, {{10'000, 0}, up(9)}, {{0, 0}, up(8)}};
  house.roof.facets = {{FacetKind::step, {{1, 2, 3, 0}}, {1, 2, 3, 1, 3, 0}}};
  return house;
}

TEST(RoofSteps, HaveTheRectangleThatIsWhole) {
  Building house = house_with_step();
  const auto step = step_of(house, house.roof.facets[0]);
  ASSERT_TRUE(step);
  EXPECT_EQ(step->a, (PlanPoint{0, 0}));
  EXPECT_EQ(step->b, (PlanPoint{10'000, 0}));
  EXPECT_EQ(full_wall(*step), (std::pair{6.0, 8.0}));
  house.roof.facets[0].rings[0] = {3, 2, 1, 0};  // the same seen from the north
  EXPECT_EQ(step_of(house, house.roof.facets[0])->a, (PlanPoint{10'000, 0}));
  house.roof.facets[0].kind = FacetKind::slope;
  EXPECT_FALSE(step_of(house, house.roof.facets[0]));
}

TEST(AddRoof, DrawsOfAStepWhatIsAroundTheFacadeOnIt) {
  const Building house = house_with_step();
  FaceList whole({0, 0}), cut({0, 0});
  add_roof(whole, house);
  add_roof(cut, house, {}, [](PlanPoint a, PlanPoint b) -> std::optional<std::pair<double, double>> {
    if (a.x == 0 && b.x == 10'000) return std::pair(6.5, 7.5);
    return std::nullopt;
  });
  const double all = area_m2(whole.take());
  const auto faces = cut.take();
  EXPECT_NEAR(all, 30, 1e-6);
  EXPECT_NEAR(area_m2(faces), 20, 1e-6);
  for (const Face& f : faces) {  // all of them look south: +z
    const X3dPoint &a = f.corners[0], &b = f.corners[1], &c = f.corners[2];
    const double nz = double(b.x - a.x) * double(c.y - a.y) - double(b.y - a.y) * double(c.x - a.x);
    EXPECT_GT(nz, 0);
  }
}

TEST(AddRoof, DrawsOfAGableWhatIsAboveTheFacadeThatReachesIntoIt) {
  const Building house = house_with_pediment();
  FaceList whole({0, 0}), cut({0, 0});
  add_roof(whole, house);
  add_roof(cut, house, [](PlanPoint a, PlanPoint b) { return a.y == 0 && b.y == 0 ? 6.5 : -1.0; });
  const double all = area_m2(whole.take()), rest = area_m2(cut.take());
  EXPECT_NEAR(all, 10 * 3 + 10 + 6 * 3 + 10 * 3 + 9, 1e-6);
  EXPECT_NEAR(all - rest, 10 * 2.5, 1e-6);
}

}  // namespace
}  // namespace vicus
