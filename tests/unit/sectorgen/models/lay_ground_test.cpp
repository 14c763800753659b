#include "sectorgen/models/lay_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/models/ground_covers.hpp"
#include "sectorgen/models/stand_objects.hpp"

/// A street of two sectors with houses on both sides, drawn here.
namespace vicus {
namespace {

PlanPoint at(double x, double y) { return {lattice_mm(x), lattice_mm(y)}; }

Polygon box(double x0, double y0, double x1, double y1) {
  return {{at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}, {}};
}

City street_city() {
  City city;
  for (const auto& [id, x] : {std::pair("east", 0.0), std::pair("west", -40.0)}) {
    Sector s;
    s.id = id;
    s.ground = box(x, -6, x + 40, 6);
    s.ground_triangles = triangulate(s.ground);
    city.sectors.push_back(s);
    for (const double side : {-1.0, 1.0}) {
      Building house;
      house.id = std::string(id) + (side < 0 ? "-s" : "-n");
      house.sector_id = id;
      house.footprint = side < 0 ? box(x, -16, x + 40, -6) : box(x, 6, x + 40, 16);
      house.height_m = house.eave_m = 9;
      Border facade;
      facade.sector_id = id;
      facade.building_id = house.id;
      facade.line = side < 0 ? std::vector{at(x, -6), at(x + 40, -6)} : std::vector{at(x + 40, 6), at(x, 6)};
      city.borders.push_back(facade);
      city.buildings.push_back(std::move(house));
    }
  }
  city.domain = {box(-40, -16, 40, 16)};
  return city;
}

SourceMap street_map() {
  SourceMap map;
  Axis axis;
  axis.kind = "residential";
  axis.width_m = 12;
  axis.carriageway_m = 6;
  axis.line = {at(-40, 0), at(40, 0)};
  map.axes.push_back(axis);
  return map;
}

double area_m2_of(const Surface& s) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < s.triangles.size(); i += 3) {
    const PlanPoint a = s.points[s.triangles[i]].at, b = s.points[s.triangles[i + 1]].at,
                    c = s.points[s.triangles[i + 2]].at;
    sum += (double(b.x - a.x) * (c.y - a.y) - double(b.y - a.y) * (c.x - a.x)) / 2e6;
  }
  return sum;
}

std::map<std::pair<std::string, SurfaceKind>, double> areas(const City& city) {
  std::map<std::pair<std::string, SurfaceKind>, double> out;
  for (const auto& s : city.surfaces) out[{s.sector_id, s.kind}] = area_m2_of(s);
  return out;
}

/// Directed edges of all surfaces that have no opposite: where one could look through the ground.
std::set<std::pair<GroundPoint, GroundPoint>> open_edges(const City& city) {
  std::set<std::pair<GroundPoint, GroundPoint>> open;
  for (const auto& s : city.surfaces)
    for (std::size_t i = 0; i + 2 < s.triangles.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto p = s.points[s.triangles[i + k]], q = s.points[s.triangles[i + (k + 1) % 3]];
        if (!open.erase({q, p})) open.insert({p, q});
      }
  return open;
}

TEST(LayGround, PartsAStreetIntoCarriagewayAndPavementWithoutLoss) {
  City city = street_city();
  lay_ground(street_map(), city, 1);
  auto area = areas(city);
  for (const char* id : {"east", "west"}) {
    EXPECT_NEAR((area[{id, SurfaceKind::carriageway}]), 40 * 6, 0.5) << id;
    EXPECT_NEAR((area[{id, SurfaceKind::carriageway}] + area[{id, SurfaceKind::pavement}]), 40 * 12, 1e-9) << id;
  }
}

TEST(LayGround, LeavesNoCrackBetweenSurfacesOfAnyHeight) {
  City city = street_city();
  lay_ground(street_map(), city, 1);
  const auto open = open_edges(city);
  EXPECT_FALSE(open.empty());
  for (const auto& [p, q] : open) {  // only the rim of the ground, at the level of what lies beyond
    EXPECT_TRUE((std::abs(p.at.y) == 6000 && p.at.y == q.at.y) || (std::abs(p.at.x) == 40000 && p.at.x == q.at.x))
        << p.at.x << ' ' << p.at.y << ' ' << q.at.x << ' ' << q.at.y;
    EXPECT_EQ(p.up_mm, 0);
    EXPECT_EQ(q.up_mm, 0);
  }
}

TEST(LayGround, KeepsACarriagewayOffTheWallsAndOutOfNarrowLanes) {
  City city = street_city();
  auto map = street_map();
  map.axes[0].carriageway_m = 30;
  lay_ground(map, city, 1);
  EXPECT_NEAR((areas(city)[{"east", SurfaceKind::carriageway}]), 40 * (12 - 2 * kLeastPavement_m), 0.5);
}

TEST(LayGround, StandsHousesOnATerrainWithoutAGap) {
  City city = street_city();
  city.terrain = {at(-60, -40), 5000, 25, 17, {}};
  for (std::uint32_t r = 0; r < 17; ++r)
    for (std::uint32_t c = 0; c < 25; ++c)
      city.terrain.height_mm.push_back(static_cast<std::int32_t>(200 * c + 90 * ((c * 7 + r * 5) % 11)));
  const auto figures = lay_ground(street_map(), city, 1);
  EXPECT_EQ(figures.largest_gap_m, 0);
  for (const auto& house : city.buildings) {
    EXPECT_GT(house.ground_m, 0) << house.id;
    EXPECT_GT(house.foot_m, 0) << house.id;
  }
  std::set<std::int32_t> heights;
  for (const auto& s : city.surfaces)
    for (const auto& p : s.points) heights.insert(p.up_mm);
  EXPECT_GT(heights.size(), 20u);
}

TEST(WebAddress, IsHttpWithAHostOrNothing) {
  EXPECT_EQ(web_address("www.example.org"), "https://www.example.org");
  EXPECT_EQ(web_address(" http://example.org/a?b=1&c#d "), "http://example.org/a?b=1&c#d");
  for (const char* bad :
       {"", "nowhere", "javascript:alert(1)", "https://", "https://a", "ftp://example.org", "https://example.org/\"x",
        "https://me@example.org", "https://example..org", "https://example.org/a b", "data:text/html,x.y"})
    EXPECT_FALSE(web_address(bad)) << bad;
}

}  // namespace
}  // namespace vicus
