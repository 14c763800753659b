#include "tests/support/sample_city.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace vicus {
namespace {

using Edge = std::pair<PlanPoint, PlanPoint>;

std::int64_t doubled_area(const Ring& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return sum;
}

std::vector<Ring> rings_of(const Polygon& polygon) {
  std::vector<Ring> rings = polygon.holes;
  rings.insert(rings.begin(), polygon.outer);
  return rings;
}

std::int64_t doubled_area(const Polygon& polygon) {
  std::int64_t sum = 0;
  for (const auto& ring : rings_of(polygon)) sum += doubled_area(ring);
  return sum;
}

std::vector<Edge> edges_of(const Polygon& polygon) {
  std::vector<Edge> edges;
  for (const auto& ring : rings_of(polygon))
    for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  return edges;
}

std::vector<Polygon> faces_of(const City& city) {
  std::vector<Polygon> faces;
  for (const auto& s : city.sectors) faces.push_back(s.ground);
  for (const auto& b : city.buildings)
    if (b.base_m == 0) faces.push_back(b.footprint);
  for (const auto& o : city.obstacles) faces.push_back(o.area);
  return faces;
}

TEST(SampleCity, PartitionsItsDomainExactly) {
  const City city = test::sample_city();
  std::int64_t domain = 0, sum = 0;
  for (const auto& d : city.domain) domain += doubled_area(d);
  for (const auto& face : faces_of(city)) {
    EXPECT_GT(doubled_area(face), 0);
    sum += doubled_area(face);
  }
  EXPECT_EQ(sum, domain);
}

TEST(SampleCity, IsNodedEveryEdgeHasItsReverseOrBoundsTheDomain) {
  const City city = test::sample_city();
  std::set<Edge> edges;
  for (const auto& face : faces_of(city))
    for (const auto& edge : edges_of(face)) EXPECT_TRUE(edges.insert(edge).second);
  std::set<Edge> rim;
  for (const auto& d : city.domain)
    for (const auto& edge : edges_of(d)) rim.insert(edge);
  for (const auto& edge : edges)
    EXPECT_NE(edges.contains({edge.second, edge.first}), rim.contains(edge)) << edge.first.x << "," << edge.first.y;
  for (const auto& edge : rim) EXPECT_TRUE(edges.contains(edge));
}

TEST(SampleCity, HasEveryGroundEdgeOnceAsBorderOrGate) {
  const City city = test::sample_city();
  std::multiset<std::pair<std::string, Edge>> expected, found;
  for (const auto& s : city.sectors)
    for (const auto& edge : edges_of(s.ground)) expected.insert({s.id, edge});
  const auto add = [&](const std::string& sector, const std::vector<PlanPoint>& line) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) found.insert({sector, {line[i], line[i + 1]}});
  };
  for (const auto& b : city.borders) add(b.sector_id, b.line);
  for (const auto& g : city.gates) add(g.sector_id, g.line);
  EXPECT_EQ(found, expected);
}

TEST(SampleCity, HasGatesThatAreTwinsOrLeadOut) {
  const City city = test::sample_city();
  std::map<std::string, Gate> gates;
  for (const auto& g : city.gates) EXPECT_TRUE(gates.emplace(g.id, g).second) << g.id;
  int out = 0;
  for (const auto& [id, g] : gates) {
    EXPECT_EQ(g.twin_id.empty(), g.to_sector_id.empty()) << id;
    EXPECT_EQ(g.twin_id.empty(), g.kind == GateKind::end_of_city) << id;
    if (g.twin_id.empty()) {
      ++out;
      continue;
    }
    const Gate& twin = gates.at(g.twin_id);
    EXPECT_EQ(twin.twin_id, id);
    EXPECT_EQ(twin.sector_id, g.to_sector_id);
    EXPECT_EQ(twin.to_sector_id, g.sector_id);
    EXPECT_EQ(twin.line, std::vector<PlanPoint>(g.line.rbegin(), g.line.rend()));
  }
  EXPECT_EQ(out, 3);
}

TEST(SampleCity, HasFacadesOnTheReverseOfTheirHousesEdges) {
  const City city = test::sample_city();
  std::map<std::string, std::vector<Edge>> walls;
  for (const auto& b : city.buildings) walls[b.id] = edges_of(b.footprint);
  int facades = 0;
  for (const auto& border : city.borders) {
    EXPECT_EQ(border.building_id.empty(), border.kind != BorderKind::facade);
    if (border.kind != BorderKind::facade) continue;
    ++facades;
    const auto& edges = walls.at(border.building_id);
    EXPECT_NE(std::find(edges.begin(), edges.end(), Edge{border.line[1], border.line[0]}), edges.end());
  }
  EXPECT_EQ(facades, 18);
}

TEST(SampleCity, HasTrianglesThatCoverGroundsAndRoofsExactly) {
  const City city = test::sample_city();
  const auto check = [](const Polygon& polygon, const Triangles& triangles) {
    Ring points;
    for (const auto& ring : rings_of(polygon)) points.insert(points.end(), ring.begin(), ring.end());
    ASSERT_EQ(triangles.size() % 3, 0u);
    ASSERT_EQ(triangles.size() / 3, points.size() + 2 * polygon.holes.size() - 2);
    std::int64_t sum = 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      const std::int64_t area =
          doubled_area(Ring{points.at(triangles[t]), points.at(triangles[t + 1]), points.at(triangles[t + 2])});
      EXPECT_GT(area, 0);
      sum += area;
    }
    EXPECT_EQ(sum, doubled_area(polygon));
  };
  for (const auto& s : city.sectors) check(s.ground, s.ground_triangles);
  for (const auto& b : city.buildings) check(b.footprint, b.roof.facets.at(0).triangles);
}

TEST(SampleCity, NamesOnlyIdsThatExistAndUsesEveryList) {
  const City city = test::sample_city();
  std::set<std::string> sectors;
  for (const auto& s : city.sectors) EXPECT_TRUE(sectors.insert(s.id).second);
  for (const auto& b : city.buildings) EXPECT_TRUE(sectors.contains(b.sector_id));
  for (const auto& o : city.objects) EXPECT_TRUE(sectors.contains(o.sector_id));
  for (const auto& v : city.viewpoints) EXPECT_TRUE(sectors.contains(v.sector_id));
  for (const auto& v : city.visible)
    EXPECT_TRUE(sectors.contains(v.sector_id) && sectors.contains(v.visible_sector_id));
  for (bool is_empty : {city.meta.empty(), city.obstacles.empty(), city.streets.empty(), city.objects.empty(),
                        city.viewpoints.empty(), city.visible.empty(), city.issues.empty()})
    EXPECT_FALSE(is_empty);
}

}  // namespace
}  // namespace vicus
