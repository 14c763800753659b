#include "sectorgen/geo/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sectorgen/geo/stitch_pieces.hpp"
#include "tests/support/map_checks.hpp"

namespace vicus::test {
namespace {

/// An axis-parallel house, metres.
Footprint house(double west, double south, double east, double north, Tags tags = {}) {
  const std::int32_t w = lattice_mm(west), s = lattice_mm(south), e = lattice_mm(east), n = lattice_mm(north);
  Footprint footprint;
  footprint.source_id = "way/" + std::to_string(w) + "_" + std::to_string(s);
  footprint.area.outer = {{w, s}, {e, s}, {e, n}, {w, n}};
  footprint.height_m = footprint.eave_m = 9;
  footprint.tags = std::move(tags);
  return footprint;
}

TEST(Duplicates, TheFirstStaysAndLearnsWhatOnlyTheSecondKnows) {
  std::vector<Footprint> houses = {house(0, 0, 10, 10, {{"building", "yes"}}), house(20, 0, 30, 10),
                                   house(0, 0, 10, 10, {{"building", "house"}, {"height", "7"}})};
  std::rotate(houses[2].area.outer.begin(), houses[2].area.outer.begin() + 2, houses[2].area.outer.end());
  std::vector<bool> is_cut = {false, true, false};
  std::vector<Issue> issues;
  drop_duplicates(houses, is_cut, issues);
  ASSERT_EQ(houses.size(), 2u);
  EXPECT_EQ(houses[0].tags, (Tags{{"building", "yes"}, {"height", "7"}}));
  EXPECT_EQ(is_cut, (std::vector<bool>{false, true}));
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].code, IssueCode::duplicate);
}

TEST(Duplicates, AnOutlineAndItsPartOrPartsAboveEachOtherAreNone) {
  std::vector<Footprint> houses = {house(0, 0, 10, 10), house(0, 0, 10, 10), house(0, 0, 10, 10)};
  houses[1].is_part = houses[2].is_part = true;
  houses[1].tags = {{"min_height", "0"}, {"height", "5"}};
  houses[2].tags = {{"min_height", "5"}, {"height", "9"}};
  std::vector<bool> is_cut(3);
  std::vector<Issue> issues;
  drop_duplicates(houses, is_cut, issues);
  EXPECT_EQ(houses.size(), 3u);
}

TEST(Overlaps, ArePartyWallsOnlyFromOneSquareMetreOn) {
  const auto overlaps = [](double depth) {
    std::vector<Issue> issues;
    find_overlaps({house(0, 0, 10, 10), house(10 - depth, 0, 20, 10)}, issues);
    return issues.size();
  };
  EXPECT_EQ(overlaps(0), 0u);
  EXPECT_EQ(overlaps(0.099), 0u);
  EXPECT_EQ(overlaps(0.101), 1u);
}

TEST(Overlaps, PartsAndWhatStandsAboveTheGroundDoNotCount) {
  std::vector<Footprint> houses = {house(0, 0, 10, 10), house(2, 2, 8, 8), house(3, 3, 9, 9)};
  houses[1].is_part = true;
  houses[2].base_m = 4;
  std::vector<Issue> issues;
  find_overlaps(houses, issues);
  EXPECT_TRUE(issues.empty());
}

TEST(BlockedStreets, CountOnlyWhatRunsInside) {
  const auto blocked = [](const std::vector<PlanPoint>& line) {
    Axis axis;
    axis.source_id = "way/1";
    axis.line = line;
    Footprint court = house(0, 0, 30, 30);
    court.area.holes = {{{5'000, 5'000}, {5'000, 25'000}, {25'000, 25'000}, {25'000, 5'000}}};
    std::vector<Issue> issues;
    find_blocked_streets({court}, {axis}, issues);
    return issues.size();
  };
  EXPECT_EQ(blocked({{-9'000, 15'000}, {40'000, 15'000}}), 1u);
  EXPECT_EQ(blocked({{-9'000, 15'000}, {900, 15'000}}), 0u) << "0.9 m";
  EXPECT_EQ(blocked({{-9'000, 15'000}, {1'100, 15'000}}), 1u) << "1.1 m";
  EXPECT_EQ(blocked({{6'000, 15'000}, {24'000, 15'000}}), 0u) << "in the courtyard";
  EXPECT_EQ(blocked({{0, -9'000}, {0, 40'000}}), 0u) << "along the facade";
}

TEST(StitchPieces, JoinsWhatTilesCut) {
  std::vector<Footprint> pieces = {house(0, 0, 12, 10, {{"height", "9"}, {"tile", "1/1"}}),
                                   house(8, 0, 20, 10, {{"height", "9"}, {"tile", "2/1"}}),
                                   house(8, 0, 20, 10, {{"height", "5"}, {"tile", "2/1"}}),
                                   house(8, 20, 20, 30, {{"height", "9"}, {"tile", "2/1"}})};
  std::vector<bool> is_cut = {true, true, true, false};
  stitch_pieces(pieces, is_cut);
  ASSERT_EQ(pieces.size(), 3u) << "another height is another house";
  EXPECT_NEAR(area_by_geos_m2(pieces[0].area), 200, 1e-6);
  EXPECT_TRUE(is_valid_by_geos(pieces[0].area));
  EXPECT_EQ(pieces[0].tags, (Tags{{"height", "9"}}));
  EXPECT_EQ(is_cut, (std::vector<bool>{true, true, false}));
}

TEST(StitchPieces, LeavesNeighboursInOneTileAlone) {
  std::vector<Footprint> pieces = {house(0, 0, 12, 10, {{"tile", "1/1"}}), house(8, 0, 20, 10, {{"tile", "1/1"}})};
  std::vector<bool> is_cut = {true, true};
  stitch_pieces(pieces, is_cut);
  EXPECT_EQ(pieces.size(), 2u);
}

}  // namespace
}  // namespace vicus::test
