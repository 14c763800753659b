#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sectorgen/geom/polygon.hpp"
#include "tests/unit/sectorgen/sectors/drawn_map.hpp"

/// Small maps drawn by hand: which sectors and gates they give.
namespace vicus::test {
namespace {

std::size_t count(const City& city, GateKind kind) {
  return static_cast<std::size_t>(
      std::count_if(city.gates.begin(), city.gates.end(), [&](const Gate& g) { return g.kind == kind; }));
}

TEST(Streets, ALongStreetIsAChainOfPieces) {
  const City city = built(one_street());
  EXPECT_EQ(city.sectors.size(), 2u);
  EXPECT_EQ(count(city, GateKind::street), 2u);  // one gate and its twin
  for (const auto& s : city.sectors) EXPECT_EQ(s.name, "Long Street");
  for (const auto& g : city.gates)
    if (g.kind == GateKind::street) {
      EXPECT_NEAR(metres(std::abs(g.line[0].y - g.line[1].y)), 12, 0.001);  // square across, wall to wall
      EXPECT_EQ(g.line[0].x, g.line[1].x);
    }
}

TEST(Streets, TwoCarriagewaysAreOneStreet) {
  SourceMap map = one_street();
  map.axes.clear();
  map.axes.push_back(street("Long Street", {at(-60, 3), at(260, 3)}));
  map.axes.push_back(street("Long Street", {at(260, -3), at(-60, -3)}));
  EXPECT_EQ(built(std::move(map)).sectors.size(), built(one_street()).sectors.size());
}

TEST(Streets, ASmallCrossroadsBelongsToAStreet) {
  SourceMap map;
  for (int sx : {-1, 1})
    for (int sy : {-1, 1})
      for (int i = 0; i < 8; ++i) {
        const double a = 5 + 10.0 * i, b = a + 10;
        const auto add = [&](double x0, double y0, double x1, double y1) {
          map.footprints.push_back(house("h" + std::to_string(map.footprints.size()),
                                         box(std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1))));
        };
        add(sx * a, sy * 5, sx * b, sy * 15);
        if (i > 0) add(sx * 5, sy * a, sx * 15, sy * b);
      }
  map.axes.push_back(street("East Street", {at(-130, 0), at(0, 0), at(130, 0)}));
  map.axes.push_back(street("North Street", {at(0, -130), at(0, 0), at(0, 130)}));
  const City city = built(std::move(map));
  std::set<std::string> names;
  for (const auto& s : city.sectors) {
    EXPECT_NE(s.kind, SectorKind::crossroads);
    names.insert(s.name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"East Street", "North Street"}));
  EXPECT_GE(city.sectors.size(), 2u);  // the shorter street's halves, or one through street and two halves
  EXPECT_LE(city.sectors.size(), 4u);
}

TEST(Streets, APassageJoinsAStreetAndACourtyard) {
  SourceMap map = one_street();
  // A second row closes a courtyard behind the north side.
  for (int i = 0; i < 20; ++i)
    map.footprints.push_back(house("back" + std::to_string(i), box(10 * i, 46, 10 * i + 10, 56)));
  map.footprints.push_back(house("west", box(-10, 6, 0, 56)));
  map.footprints.push_back(house("east", box(200, 6, 210, 56)));
  const auto courtyards = [](const City& city) {
    return std::count_if(city.obstacles.begin(), city.obstacles.end(),
                         [](const Obstacle& o) { return o.kind == ObstacleKind::courtyard; });
  };
  EXPECT_EQ(courtyards(built(map)), 1);
  Axis passage = street("", {at(55, 0), at(55, 30)}, 4);
  passage.is_passage = true;
  map.axes.push_back(passage);
  const City open = built(std::move(map));
  EXPECT_EQ(courtyards(open), 0);
  const auto roofed =
      std::find_if(open.buildings.begin(), open.buildings.end(), [](const Building& b) { return b.base_m > 0; });
  ASSERT_NE(roofed, open.buildings.end());  // the house goes on above the passage
  EXPECT_EQ(roofed->source_id, "north5");
}

TEST(Streets, ABridgeCarriesTheStreetOverWater) {
  SourceMap map = one_street();
  std::erase_if(map.footprints,
                [](const Footprint& f) { return f.source_id == "south10" || f.source_id == "north10"; });
  map.areas.push_back({"brook", "Brook", AreaKind::water, box(102, -60, 108, 60)});
  const City city = built(std::move(map));
  EXPECT_EQ(check_rules(city).components, 1u);
  EXPECT_TRUE(std::any_of(city.borders.begin(), city.borders.end(),
                          [](const Border& b) { return b.kind == BorderKind::bank; }));
}

TEST(Streets, ABridgeMayBeginAndEndJustAtTheBanks) {
  SourceMap map = one_street();
  std::erase_if(map.footprints,
                [](const Footprint& f) { return f.source_id == "south10" || f.source_id == "north10"; });
  map.areas.push_back({"brook", "Brook", AreaKind::water, box(102, -60, 108, 60)});
  map.axes.clear();
  map.axes.push_back(street("Long Street", {at(-60, 0), at(102, 0)}));
  map.axes.push_back(street("Long Street", {at(102, 0), at(108, 0)}));
  map.axes.push_back(street("Long Street", {at(108, 0), at(260, 0)}));
  EXPECT_EQ(check_rules(built(std::move(map))).components, 1u);
}

TEST(Streets, ABridgesOutlineIsItsDeckWhereAStreetLeadsOverIt) {
  SourceMap map = one_street();
  std::erase_if(map.footprints, [](const Footprint& f) {
    return f.source_id == "south10" || f.source_id == "north10" || f.source_id == "north11";
  });
  map.areas.push_back({"brook", "Brook", AreaKind::water, box(102, -60, 118, 60)});
  map.areas.push_back({"bridge", "", AreaKind::deck, box(101, -6, 119, 14)});     // far broader than the street
  map.areas.push_back({"railway", "", AreaKind::deck, box(101, -40, 119, -34)});  // nobody walks there
  const City city = built(std::move(map));
  const auto is_walkable = [&](PlanPoint p) {
    return std::any_of(city.sectors.begin(), city.sectors.end(),
                       [&](const Sector& s) { return locate(s.ground, p) != Side::outside; });
  };
  EXPECT_TRUE(is_walkable(at(110, 0)));
  EXPECT_TRUE(is_walkable(at(110, 13)));
  EXPECT_FALSE(is_walkable(at(110, 15)));
  EXPECT_FALSE(is_walkable(at(110, -37)));
}

TEST(Streets, AWayAlongTheBankIsNoDeck) {
  SourceMap map = one_street();
  map.areas.push_back({"brook", "Brook", AreaKind::water, box(-60, -5, 260, -3)});
  map.axes.push_back(street("Towpath", {at(-60, -3), at(260, -3)}));
  const City city = built(std::move(map));
  EXPECT_TRUE(std::any_of(city.borders.begin(), city.borders.end(),
                          [](const Border& b) { return b.kind == BorderKind::bank; }));
}

TEST(Streets, AWallWithAnOpeningLeavesAGap) {
  SourceMap map = one_street();
  Barrier wall;
  wall.source_id = "wall";
  wall.line = {at(120, -8), at(120, 8)};  // across the street, as a town wall
  wall.height_m = 6;
  map.barriers.push_back(wall);
  const City city = built(std::move(map));
  EXPECT_EQ(check_rules(city).components, 1u);  // the street leads through
  EXPECT_TRUE(std::any_of(city.borders.begin(), city.borders.end(),
                          [](const Border& b) { return b.kind == BorderKind::wall; }));
}

TEST(Streets, WithoutAnyStreetTheWideGroundIsWalked) {
  SourceMap map = one_street();
  map.axes.clear();
  const City city = built(std::move(map));
  EXPECT_FALSE(city.sectors.empty());
}

TEST(Streets, ASpikeThatRoundingClosedIsNobodysFacade) {
  // The first house has a spike 1 mm wide down to y = 10; the second house's corner at y = 12 snaps its sides together,
  // and they run along the second house's east wall.
  SourceMap map = one_street();
  std::erase_if(map.footprints, [](const Footprint& f) { return f.source_id == "north10"; });
  map.footprints.insert(
      map.footprints.begin(),
      {house("spiked",
             {{at(100, 16), at(100, 14), at(105, 14), at(105, 10), at(105.001, 14), at(110, 14), at(110, 16)}, {}}),
       house("beside", box(102, 10, 105, 12))});
  built(std::move(map));  // rule 2 was broken: the wall was the first house's
}

TEST(Streets, NothingAtAllIsRefused) {
  BuildReport report;
  try {
    build_city(SourceMap{}, {}, {}, report);
    FAIL() << "built a city from nothing";
  } catch (const CityError& e) {
    EXPECT_EQ(e.exit_code, 4);
  }
}

TEST(Streets, AHeavySectorIsHalved) {
  BuildReport report;
  BuildOptions tight;
  tight.budget_bytes = 20 * 45;  // twenty sides
  const City city = build_city(one_street(), tight, {}, report);
  EXPECT_GT(city.sectors.size(), 4u);
  EXPECT_TRUE(check_rules(city).all_hold());
}

}  // namespace
}  // namespace vicus::test
