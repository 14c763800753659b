#include "sectorgen/geo/heights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/map_checks.hpp"

namespace vicus::test {
namespace {

/// A 10 x 10 m house with its corner `east` metres along a street.
Footprint house(double east, Tags tags) {
  Footprint footprint;
  footprint.source_id = "way/" + std::to_string(static_cast<int>(east));
  const std::int32_t x = lattice_mm(east);
  footprint.area.outer = {{x, 0}, {x + 10'000, 0}, {x + 10'000, 10'000}, {x, 10'000}};
  footprint.tags = std::move(tags);
  footprint.tags.emplace("building", "yes");
  return footprint;
}

Footprint with_height(Footprint footprint, std::vector<Issue>* issues = nullptr) {
  std::vector<Footprint> one = {std::move(footprint)};
  std::vector<Issue> found;
  set_heights(one, {false}, found);
  if (issues) *issues = found;
  return one[0];
}

TEST(Heights, MeasuredOnesWinOverLevels) {
  const Footprint f = with_height(house(0, {{"height", "40'"}, {"building:levels", "9"}}));
  EXPECT_NEAR(f.height_m, 12.192, 1e-9);
  EXPECT_EQ(f.height_source, HeightSource::measured);
}

TEST(Heights, LevelsAreThreeMetresAndTheRoofGoesOnTop) {
  const Footprint f = with_height(house(0, {{"building:levels", "4"}, {"roof:levels", "1"}, {"roof:shape", "gabled"}}));
  EXPECT_EQ(f.height_source, HeightSource::levels);
  EXPECT_EQ(f.eave_m, 12);
  EXPECT_EQ(f.height_m, 15);
  EXPECT_EQ(f.roof_shape, "gabled");
  EXPECT_EQ(with_height(house(0, {{"building:levels", "4"}, {"roof:height", "2.5"}})).height_m, 14.5);
}

TEST(Heights, TheRoofIsPartOfAMeasuredHeight) {
  const Footprint f = with_height(house(0, {{"height", "15"}, {"roof:height", "4"}}));
  EXPECT_EQ(f.height_m, 15);
  EXPECT_EQ(f.eave_m, 11);
}

TEST(Heights, AGuessIsTheMedianOfLikeNeighbours) {
  std::vector<Footprint> street = {house(0, {{"height", "10"}}),  house(15, {{"height", "12"}}), house(30, {}),
                                   house(45, {{"height", "14"}}), house(60, {{"height", "90"}}), house(5000, {})};
  street.push_back(house(75, {{"building", "church"}}));
  std::vector<Issue> issues;
  set_heights(street, std::vector<bool>(street.size()), issues);
  EXPECT_EQ(street[2].height_m, 12);
  EXPECT_EQ(street[2].height_source, HeightSource::guessed);
  EXPECT_EQ(street[5].height_m, 9) << "no neighbour in reach";
  EXPECT_EQ(street[6].height_m, 6) << "no other church; a small one";
  EXPECT_EQ(issues.size(), 3u);
}

TEST(Heights, SmallAndLowKindsStayLowBesideHighNeighbours) {
  std::vector<Footprint> street;
  for (int i = 0; i < 5; ++i) street.push_back(house(15 * i, {{"height", "20"}}));
  street.push_back(house(80, {{"building", "garage"}}));
  Footprint kiosk = house(95, {});
  kiosk.area.outer = {{95'000, 0}, {98'000, 0}, {98'000, 3'000}, {95'000, 3'000}};
  street.push_back(kiosk);
  street.push_back(kiosk);  // the same as a piece cut off at a tile border
  std::vector<bool> is_cut(street.size());
  is_cut.back() = true;
  std::vector<Issue> issues;
  set_heights(street, is_cut, issues);
  EXPECT_EQ(street[5].height_m, 3);
  EXPECT_EQ(street[6].height_m, 3);
  EXPECT_EQ(street[7].height_m, 20);
}

TEST(Heights, ChurchesAndTowersAreGuessedByTheirSize) {
  const auto guessed = [](Tags tags, double wide, double deep) {
    Footprint f = house(0, std::move(tags));
    f.area = {{{0, 0}, {lattice_mm(wide), 0}, {lattice_mm(wide), lattice_mm(deep)}, {0, lattice_mm(deep)}}, {}};
    return with_height(f).height_m;
  };
  EXPECT_EQ(guessed({{"building", "church"}}, 50, 25), 19);
  EXPECT_EQ(guessed({{"building", "cathedral"}}, 130, 48), 40);
  EXPECT_EQ(guessed({{"building", "church"}, {"man_made", "tower"}}, 7, 7), 35);
  EXPECT_EQ(guessed({{"building", "tower"}}, 4, 4), 20) << "small, but no shed";
  EXPECT_EQ(guessed({{"building", "yes"}}, 50, 25), 9);
}

TEST(Heights, NonsenseIsIgnoredWithAnIssue) {
  for (const auto& [key, value, code] :
       {std::tuple{"height", "0", IssueCode::absurd_height}, std::tuple{"height", "-3", IssueCode::absurd_height},
        std::tuple{"height", "501", IssueCode::absurd_height},
        std::tuple{"building:levels", "151", IssueCode::absurd_height},
        std::tuple{"height", "tall", IssueCode::unknown_attribute_value}}) {
    std::vector<Issue> issues;
    const Footprint f = with_height(house(0, {{key, value}}), &issues);
    EXPECT_EQ(f.height_source, HeightSource::guessed) << key << "=" << value;
    EXPECT_EQ(f.height_m, 9);
    ASSERT_EQ(issues.size(), 2u);
    EXPECT_EQ(issues[0].code, code);
    EXPECT_EQ(issues[1].code, IssueCode::no_height);
  }
}

TEST(Heights, AnUndersideAboveTheTopIsPutOnTheGround) {
  std::vector<Issue> issues;
  const Footprint f = with_height(house(0, {{"height", "5"}, {"min_height", "8"}}), &issues);
  EXPECT_EQ(f.base_m, 0);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].code, IssueCode::absurd_height);
}

/// Lyon's storeys and heights are both measured: what a guess from storeys alone is worth.
/// Measured: 5.5 m from storeys (those of the old silk weavers are higher than 3 m), 3 m from neighbours.
TEST(Heights, GuessesComeAsNearLyonsMeasuredHeightsAsStated) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  Loaded lyon = load({*data / "lyon1-heights/buildings_lyon1.geojson.gz"});
  std::vector<double> from_levels, from_neighbours;
  std::vector<Footprint> blind;
  std::vector<std::size_t> hidden;
  for (std::size_t i = 0; i < lyon.map.footprints.size(); ++i) {
    Footprint footprint = lyon.map.footprints[i];
    const double truth = footprint.height_m;
    footprint.tags.erase("height");
    if (footprint.tags.count("building:levels"))
      from_levels.push_back(std::abs(with_height(footprint).height_m - truth));
    // Every fifth house without anything: its neighbours must tell.
    footprint.tags = {{"building", "yes"}};
    if (i % 5 != 0) footprint.tags["height"] = std::to_string(truth);
    if (i % 5 == 0) hidden.push_back(i);
    blind.push_back(std::move(footprint));
  }
  std::vector<Issue> issues;
  set_heights(blind, std::vector<bool>(blind.size()), issues);
  for (std::size_t i : hidden) from_neighbours.push_back(std::abs(blind[i].height_m - lyon.map.footprints[i].height_m));
  const auto median = [](std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
  };
  std::cout << "median error: from storeys " << median(from_levels) << " m, from neighbours " << median(from_neighbours)
            << " m\n";
  EXPECT_LE(median(from_levels), 6);
  EXPECT_LE(median(from_neighbours), 3.5);
}

}  // namespace
}  // namespace vicus::test
