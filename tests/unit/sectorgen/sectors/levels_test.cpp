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

}  // namespace
}  // namespace vicus::test
