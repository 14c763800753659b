#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "sectorgen/build_city.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "tests/unit/sectorgen/sectors/drawn_map.hpp"

/// Streets below houses and over other streets.
namespace vicus::test {
namespace {

std::size_t count(const City& city, IssueCode code) {
  return static_cast<std::size_t>(
      std::count_if(city.issues.begin(), city.issues.end(), [&](const Issue& i) { return i.code == code; }));
}

const Sector* sector_at(const City& city, PlanPoint p) {
  for (const auto& s : city.sectors)
    if (locate(s.ground, p) != Side::outside) return &s;
  return nullptr;
}

TEST(Levels, AStreetLeadsThroughAViaductThatShowsNoPassage) {
  std::vector<Issue> issues;
  LoadOptions load;
  load.inputs = {std::filesystem::path(VICUS_TESTS) / "fixtures/issues/303_unmapped_passage.osm"};
  load.origin = {50.00005, 10.0007};
  SourceMap map = load_source_map(load, issues);
  const City city = built(std::move(map), std::move(issues));
  EXPECT_EQ(count(city, IssueCode::unmapped_passage), 2u);    // both ways of the street
  EXPECT_EQ(count(city, IssueCode::building_in_street), 1u);  // the path at the corner
  EXPECT_NE(sector_at(city, at(0, 0)), nullptr);              // below the viaduct
  EXPECT_EQ(sector_at(city, at(25, 0)), nullptr);
  EXPECT_EQ(sector_at(city, at(49, 0)), nullptr);
}

TEST(Levels, AHouseOfTheBridgeKindBlocksNothing) {
  SourceMap map = one_street();
  Footprint bridge = house("bridge", box(90, -16, 100, 16));
  bridge.base_m = 4.5;  // what building=bridge is read as
  map.footprints.push_back(bridge);
  const City city = built(std::move(map));
  EXPECT_NE(sector_at(city, at(95, 0)), nullptr);
}

/// Long Street with a street crossing it at 50 m, as a bridge or not.
SourceMap crossing(int level) {
  SourceMap map = one_street();
  for (const char* id : {"south4", "south5", "north4", "north5"})
    std::erase_if(map.footprints, [&](const Footprint& f) { return f.source_id == id; });
  for (int i = 0; i < 8; ++i)
    for (double west : {30.0, 60.0})
      for (double south : {16.0 + 10 * i, -26.0 - 10 * i})
        map.footprints.push_back(
            house("h" + std::to_string(map.footprints.size()), box(west, south, west + 10, south + 10)));
  Axis over = street("High Road", {at(50, -150), at(50, 150)});
  over.is_bridge = level > 0;
  over.level = level;
  map.axes.push_back(over);
  return map;
}

TEST(Levels, AStreetThatPassesOverAnotherMakesNoJunction) {
  const City flat = built(crossing(0)), over = built(crossing(1));
  const auto cut_by_junction = [](const City& city) {
    // Does a gate cross Long Street within a street's width of the crossing?
    return std::any_of(city.gates.begin(), city.gates.end(), [](const Gate& g) {
      return g.kind == GateKind::street && std::abs(g.line.front().x - g.line.back().x) < 3000 &&
             std::abs(g.line.front().x - 50'000) < 15'000 && std::abs(g.line.front().y) < 8'000;
    });
  };
  EXPECT_TRUE(cut_by_junction(flat));
  EXPECT_FALSE(cut_by_junction(over));
  const Sector* below = sector_at(over, at(50, 0));
  ASSERT_NE(below, nullptr);
  EXPECT_EQ(below->names, std::vector<std::string>{"Long Street"});  // the deck is the lower street's ground
  const Sector* beyond = sector_at(over, at(50, 60));
  ASSERT_NE(beyond, nullptr);
  EXPECT_EQ(beyond->name, "High Road");
}

TEST(Levels, StreetsOfOneLevelMeet) {
  SourceMap map = crossing(1);
  for (auto& axis : map.axes) axis.level = 1;
  const City both = built(std::move(map)), flat = built(crossing(0));
  EXPECT_EQ(both.sectors.size(), flat.sectors.size());
}

}  // namespace
}  // namespace vicus::test
