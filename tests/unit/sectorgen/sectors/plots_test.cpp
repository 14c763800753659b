#include <gtest/gtest.h>

#include <algorithm>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/domain.hpp"
#include "tests/unit/sectorgen/sectors/drawn_map.hpp"

/// Plot lines bound streets and yards.
namespace vicus::test {
namespace {

const Sector* sector_at(const City& city, PlanPoint p) {
  for (const auto& s : city.sectors)
    if (locate(s.ground, p) != Side::outside) return &s;
  return nullptr;
}

/// Detached houses on both sides of a street, 9 m behind the plots' front line at 6 m; gardens 34 m deep.
SourceMap suburb() {
  SourceMap map;
  for (int i = 0; i < 8; ++i)
    for (int side : {-1, 1}) {
      const double x = 25.0 * i, near = side * 15.0, far = side * 25.0;
      map.footprints.push_back(house("h" + std::to_string(map.footprints.size()),
                                     box(x + 6, std::min(near, far), x + 18, std::max(near, far))));
    }
  for (int side : {-1, 1}) {  // walled in at the back and at both ends
    map.footprints.push_back(house("back" + std::to_string(side),
                                   box(-10, std::min(side * 40, side * 50), 210, std::max(side * 40, side * 50))));
    for (double x : {-10.0, 200.0})
      map.footprints.push_back(house("end" + std::to_string(int(x) * side),
                                     box(x, std::min(side * 6, side * 40), x + 10, std::max(side * 6, side * 40))));
  }
  map.axes.push_back(street("Garden Road", {at(-60, 0), at(260, 0)}, 8));
  return map;
}

void add_plots(SourceMap& map, double front) {
  for (int i = 0; i < 8; ++i)
    for (int side : {-1, 1}) {
      const double x = 25.0 * i, near = side * front, far = side * 40.0;
      map.areas.push_back({"plot", "", AreaKind::plot, box(x, std::min(near, far), x + 25, std::max(near, far))});
    }
}

TEST(Plots, AStreetEndsAtTheFrontLineOfItsPlots) {
  SourceMap map = suburb();
  EXPECT_EQ(sector_at(built(map), at(100, 9))->kind, SectorKind::street);  // gardens not told from the street
  add_plots(map, 6);
  const City city = built(std::move(map));
  ASSERT_NE(sector_at(city, at(100, 0)), nullptr);
  EXPECT_EQ(sector_at(city, at(100, 0))->name, "Garden Road");
  ASSERT_NE(sector_at(city, at(100, 9)), nullptr);
  EXPECT_NE(sector_at(city, at(100, 9))->kind, SectorKind::street);
  for (const auto& g : city.gates) {
    if (g.kind != GateKind::kerb) continue;
    for (PlanPoint p : g.line) EXPECT_GE(std::abs(p.y), 5'900);
  }
  EXPECT_TRUE(
      std::any_of(city.gates.begin(), city.gates.end(), [](const Gate& g) { return g.kind == GateKind::kerb; }));
}

TEST(Plots, AStripOfFrontGardensBelongsToItsStreet) {
  SourceMap map = one_street();  // facades at 6 m
  for (int i = 0; i < 20; ++i) map.areas.push_back({"plot", "", AreaKind::plot, box(10 * i, 3, 10 * i + 10, 40)});
  EXPECT_EQ(built(std::move(map)).sectors.size(), built(one_street()).sectors.size());
}

TEST(Plots, LinesBesideAnObstacleAndStreetParcelsBoundNothing) {
  SourceMap map = one_street();
  const Blocks blocks = [&] {
    std::vector<Issue> issues;
    return make_blocks(map, issues);
  }();
  const std::vector<Polygon> domain{box(-500, -500, 500, 500)};
  map.areas.push_back({"street", "", AreaKind::plot, box(0, -6, 100, 6)});  // the road's own parcel
  EXPECT_TRUE(outline_kerbs(map, blocks, domain, {}).empty());
  map.areas.push_back({"house", "", AreaKind::plot, box(10, 5, 20, 17)});  // 1 m round a house
  EXPECT_TRUE(outline_kerbs(map, blocks, domain, {}).empty());
  map.areas.push_back({"meadow", "", AreaKind::plot, box(0, 40, 50, 90)});
  const auto lines = outline_kerbs(map, blocks, domain, {});
  EXPECT_EQ(lines.size(), 4u);
  double length = 0;
  for (const auto& line : lines) length += metres(length_mm(line.front(), line.back()));
  EXPECT_NEAR(length, 200, 0.01);
}

}  // namespace
}  // namespace vicus::test
