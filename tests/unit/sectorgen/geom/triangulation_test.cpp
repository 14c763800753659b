#include "sectorgen/geom/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "city_db/issues.hpp"
#include "sectorgen/geom/noding.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {
namespace {

struct Input {
  std::vector<PlanPoint> points;
  std::vector<Edge> edges;
};

/// Noded random segments.
Input random_input(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::int32_t> draw(-9'000, 9'000);
  std::vector<Segment> segments;
  for (int i = 0; i < 30; ++i) segments.push_back({{draw(random), draw(random)}, {draw(random), draw(random)}});
  const Noded noded = node_segments(segments);
  Input in;
  for (std::size_t s = 0; s + 1 < noded.begin.size(); ++s)
    for (std::uint32_t i = noded.begin[s]; i + 1 < noded.begin[s + 1]; ++i) {
      const auto n = static_cast<std::uint32_t>(in.points.size());
      in.points.push_back(noded.points[i]);
      in.points.push_back(noded.points[i + 1]);
      in.edges.push_back({n, n + 1});
    }
  return in;
}

TEST(TriangulateEdges, KeepsEveryEdgeAndIsDelaunayElsewhere) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Input in = random_input(seed);
    const Mesh mesh = triangulate_edges(in.points, in.edges);
    std::vector<std::pair<PlanPoint, PlanPoint>> kept;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& c = mesh.triangles[t].corner;
      EXPECT_GT(orient(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]), 0);
      for (int k = 0; k < 3; ++k) {
        const auto s = static_cast<std::size_t>(k);
        const PlanPoint u = mesh.points[mesh.corner(t, k + 1)], v = mesh.points[mesh.corner(t, k + 2)];
        const std::uint32_t n = mesh.triangles[t].neighbour[s];
        if (mesh.triangles[t].edge[s] != kNone) kept.push_back({std::min(u, v), std::max(u, v)});
        if (n == kNone) continue;
        const int m = mesh.twin_side(t, k);
        EXPECT_EQ(mesh.triangles[n].neighbour[static_cast<std::size_t>(m)], t);
        EXPECT_EQ(mesh.triangles[n].edge[static_cast<std::size_t>(m)], mesh.triangles[t].edge[s]);
        if (mesh.triangles[t].edge[s] != kNone) continue;
        const PlanPoint far = mesh.points[mesh.corner(n, m)];
        const int inside = in_circle(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]], far);
        EXPECT_LE(inside, 0);
        if (inside == 0) {  // cocircular: the diagonal at the smallest vertex
          EXPECT_LT(std::min(u, v), std::min(mesh.points[mesh.corner(t, k)], far));
        }
      }
    }
    std::sort(kept.begin(), kept.end());
    for (const Edge& e : in.edges) {
      const PlanPoint a = in.points[e.a], b = in.points[e.b];
      EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), std::make_pair(std::min(a, b), std::max(a, b))));
    }
  }
}

TEST(TriangulateEdges, DependsOnCoordinatesOnly) {
  // A lattice of squares: every cell is cocircular.
  std::vector<PlanPoint> points;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) points.push_back({x * 1'000, y * 1'000});
  const Mesh a = triangulate_edges(points, {});
  std::shuffle(points.begin(), points.end(), std::mt19937(4));
  const Mesh b = triangulate_edges(points, {});
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t) EXPECT_EQ(a.triangles[t].corner, b.triangles[t].corner);
}

TEST(TriangulateEdges, RefusesEdgesThatCross) {
  const std::vector<PlanPoint> points{{0, 0}, {10, 10}, {0, 10}, {10, 0}};
  EXPECT_THROW(triangulate_edges(points, {{0, 1}, {2, 3}}), CityError);
}

TEST(Triangulate, CoversAPolygonWithHolesExactly) {
  const Polygon ring_road{{{0, 0}, {9'000, 0}, {9'000, 9'000}, {0, 9'000}},
                          {{{1'000, 1'000}, {1'000, 3'000}, {3'000, 3'000}, {3'000, 1'000}},
                           {{3'000, 3'000}, {3'000, 6'000}, {6'000, 6'000}, {6'000, 3'000}}}};  // touch in a point
  std::vector<PlanPoint> points = ring_road.outer;
  for (const auto& hole : ring_road.holes) points.insert(points.end(), hole.begin(), hole.end());
  const Triangles triangles = triangulate(ring_road);
  Int128 sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const auto area = orient(points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]);
    EXPECT_GT(area, 0);
    sum += area;
  }
  EXPECT_TRUE(sum == area2(ring_road));
}

}  // namespace
}  // namespace vicus
