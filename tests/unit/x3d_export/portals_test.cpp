#include "x3d_export/portals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/support/sample_city.hpp"
#include "tests/support/triangulate.hpp"

namespace vicus {
namespace {

std::int64_t orient(PlanPoint a, PlanPoint b, PlanPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

std::int64_t area2(const Ring& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += orient(ring[0], ring[i], ring[i + 1]);
  return sum;
}

bool has_edge(const ConvexCell& cell, PlanPoint from, PlanPoint to) {
  for (std::size_t i = 0; i < cell.ring.size(); ++i)
    if (cell.ring[i] == from && cell.ring[(i + 1) % cell.ring.size()] == to) return true;
  return false;
}

struct ReadPortal {
  std::uint32_t a = 0, b = 0;
  std::vector<std::array<double, 3>> points;
};
struct ReadPrt {
  std::size_t cells = 0;
  std::vector<ReadPortal> portals;
};

/// PRT1 as Quake's programs read it: scanf, blind to line ends.
ReadPrt read_prt(const std::string& text) {
  std::istringstream in(text);
  std::string magic, mark;
  ReadPrt prt;
  std::size_t count = 0;
  in >> magic >> prt.cells >> count;
  EXPECT_EQ(magic, "PRT1");
  for (std::size_t i = 0; i < count; ++i) {
    auto& portal = prt.portals.emplace_back();
    std::size_t corners = 0;
    in >> corners >> portal.a >> portal.b;
    for (std::size_t k = 0; k < corners; ++k) {
      auto& p = portal.points.emplace_back();
      std::string open, close;
      // "(x" has no blank: take the bracket apart from the number.
      char bracket = 0;
      in >> bracket >> p[0] >> p[1] >> p[2] >> close;
      EXPECT_EQ(bracket, '(');
      EXPECT_EQ(close, ")");
    }
  }
  EXPECT_TRUE(in) << "cut short";
  in >> mark;
  EXPECT_TRUE(in.eof() && mark.empty()) << "something follows: " << mark;
  return prt;
}

/// Edges with a cell on either side, inside the sectors, and edges of gates: each pair of twins once.
std::size_t shared_edges(const City& city, const PortalGraph& graph) {
  std::map<std::uint32_t, std::set<std::pair<PlanPoint, PlanPoint>>> edges;
  for (const auto& cell : graph.cells)
    for (std::size_t i = 0; i < cell.ring.size(); ++i)
      edges[cell.sector].insert({cell.ring[i], cell.ring[(i + 1) % cell.ring.size()]});
  std::size_t inner = 0, gates = 0;
  for (const auto& [sector, list] : edges)
    for (const auto& [from, to] : list) inner += list.contains({to, from});
  for (const auto& g : city.gates)
    if (!g.twin_id.empty()) gates += g.line.size() - 1;
  return inner / 2 + gates / 2;
}

class PortalsOfSample : public testing::TestWithParam<bool> {
 protected:
  City city = test::sample_city();
  PortalGraph graph = portal_graph(city, GetParam());
};

TEST_P(PortalsOfSample, LieOnTheEdgesOfBothTheirCells) {
  for (const auto& portal : graph.portals) {
    ASSERT_NE(portal.a, portal.b);
    EXPECT_TRUE(has_edge(graph.cells.at(portal.a), portal.from, portal.to));
    EXPECT_TRUE(has_edge(graph.cells.at(portal.b), portal.to, portal.from));
  }
}

TEST_P(PortalsOfSample, AreAsManyAsSharedEdges) { EXPECT_EQ(graph.portals.size(), shared_edges(city, graph)); }

TEST_P(PortalsOfSample, JoinConvexCellsThatCoverEachSectorOnce) {
  std::vector<std::int64_t> areas(city.sectors.size(), 0);
  for (const auto& cell : graph.cells) {
    const auto n = cell.ring.size();
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_GE(orient(cell.ring[i], cell.ring[(i + 1) % n], cell.ring[(i + 2) % n]), 0);
    EXPECT_GT(area2(cell.ring), 0);
    areas[cell.sector] += area2(cell.ring);
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    std::int64_t ground = area2(city.sectors[i].ground.outer);
    for (const auto& hole : city.sectors[i].ground.holes) ground += area2(hole);
    EXPECT_EQ(areas[i], ground) << city.sectors[i].id;
  }
}

TEST_P(PortalsOfSample, ReadBackWithTheNormalThatQuakeExpects) {
  const auto prt = read_prt(prt_text(graph));
  EXPECT_EQ(prt.cells, graph.cells.size());
  ASSERT_EQ(prt.portals.size(), graph.portals.size());
  const auto middle = [&](std::uint32_t cell) {
    std::array<double, 2> sum{};
    for (const auto& p : graph.cells[cell].ring) sum[0] += p.x, sum[1] += p.y;
    const auto n = static_cast<double>(graph.cells[cell].ring.size());
    return std::array<double, 2>{sum[0] / n, sum[1] / n};
  };
  for (const auto& portal : prt.portals) {
    ASSERT_EQ(portal.points.size(), 4u);
    const auto& p = portal.points;
    EXPECT_EQ(p[0][2], 0);
    EXPECT_EQ(p[2][2], 3000);
    // PlaneFromWinding: (p0 - p1) x (p2 - p1) points from b to a.
    const double ux = p[0][0] - p[1][0], uy = p[0][1] - p[1][1], wz = p[2][2] - p[1][2];
    EXPECT_EQ(p[2][0], p[1][0]);
    EXPECT_EQ(p[2][1], p[1][1]);
    const double nx = uy * wz, ny = -ux * wz;
    const auto a = middle(portal.a), b = middle(portal.b);
    EXPECT_GT(nx * (a[0] - b[0]) + ny * (a[1] - b[1]), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(TrianglesAndCells, PortalsOfSample, testing::Bool());

TEST(Portals, JoinTrianglesWhereThatStaysConvex) {
  const City city = test::sample_city();
  const auto triangles = portal_graph(city, true), cells = portal_graph(city, false);
  std::size_t count = 0;
  for (const auto& s : city.sectors) count += s.ground_triangles.size() / 3;
  EXPECT_EQ(triangles.cells.size(), count);
  EXPECT_LT(cells.cells.size(), triangles.cells.size());
  // s-cross, s-passage, s-yard are convex: one cell each, whatever their triangles were.
  for (const char* id : {"s-cross", "s-passage", "s-yard"})
    EXPECT_EQ(std::count_if(cells.cells.begin(), cells.cells.end(),
                            [&](const ConvexCell& c) { return city.sectors[c.sector].id == id; }),
              1)
        << id;
}

TEST(Portals, TellUnitsAndSectorsBeside) {
  const City city = test::sample_city();
  const auto graph = portal_graph(city, false);
  const auto json = nlohmann::json::parse(prt_json(graph, city));
  EXPECT_EQ(json["units_per_metre"], 1000);
  EXPECT_EQ(json["portals"], graph.portals.size());
  ASSERT_EQ(json["sector_of_cell"].size(), graph.cells.size());
  for (std::size_t i = 0; i < graph.cells.size(); ++i)
    EXPECT_EQ(json["sector_of_cell"][i], city.sectors[graph.cells[i].sector].id);
}

/// A strip of squares, each with a vertex in the middle of each long side.
TEST(Portals, KeepVerticesOnStraightSides) {
  City city;
  Sector s;
  s.id = "a";
  s.ground.outer = {{0, 0}, {1000, 0}, {2000, 0}, {2000, 1000}, {1000, 1000}, {0, 1000}};
  s.ground_triangles = test::triangulate(s.ground);
  city.sectors = {s};
  const auto graph = portal_graph(city, false);
  ASSERT_EQ(graph.cells.size(), 1u);
  EXPECT_EQ(graph.cells[0].ring.size(), 6u);
  EXPECT_TRUE(graph.portals.empty());
}

TEST(Portals, NameTheGateOrSectorThatDoesNotFit) {
  const auto error_after = [](const std::function<void(City&)>& change) {
    City city = test::sample_city();
    change(city);
    try {
      portal_graph(city, false);
    } catch (const CityError& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(error_after([](City& c) { c.gates[1].line.back().x += 1; }), "gate s-cross-to-s-main-e is not made"));
  EXPECT_TRUE(has(error_after([](City& c) { c.gates[0].to_sector_id = "nowhere"; }), "nowhere"));
  EXPECT_TRUE(
      has(error_after([](City& c) { c.sectors[2].ground_triangles.clear(); }), "sector s-main-w has no ground"));
  EXPECT_TRUE(
      has(error_after([](City& c) { std::swap(c.sectors[2].ground_triangles[0], c.sectors[2].ground_triangles[1]); }),
          "without area"));
  EXPECT_TRUE(has(error_after([](City& c) { c.sectors[2].ground_triangles[0] = 99; }), "corner its ground lacks"));
}

}  // namespace
}  // namespace vicus
