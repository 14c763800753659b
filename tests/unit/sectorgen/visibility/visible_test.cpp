#include "sectorgen/visibility/visible.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/grid_city.hpp"

namespace vicus::test {
namespace {

/// Three crossroads a side, a tower in the middle block, and gates between a few neighbours.
City city_with_a_tower() {
  GridOptions options;
  options.side = 4;
  City city = grid_city(options);
  for (std::size_t i = 0; i < city.buildings.size(); ++i) {
    city.buildings[i].sector_id = city.sectors[i].id;
    if (i == 4) city.buildings[i].height_m = city.buildings[i].eave_m = 90;
  }
  city.gates.push_back({"g", "s0", "s16", "", GateKind::street, {}});  // into the street at the first crossroads
  return city;
}

TEST(ListVisible, GivesEachPairOnceWithTheFirstReasonThatHolds) {
  City city = city_with_a_tower();
  list_visible(city, {});
  std::set<std::pair<std::string, std::string>> pairs;
  for (const auto& v : city.visible) {
    EXPECT_TRUE(pairs.insert({v.sector_id, v.visible_sector_id}).second);
    EXPECT_EQ(v.reason == VisibleReason::self, v.sector_id == v.visible_sector_id);
    EXPECT_EQ(v.reason == VisibleReason::over_roofs, !v.building_ids.empty());
    EXPECT_TRUE(std::is_sorted(v.building_ids.begin(), v.building_ids.end()));
    EXPECT_TRUE(v.is_proven || v.reason == VisibleReason::over_roofs);
  }
  const auto reason = [&](const char* from, const char* to) {
    for (const auto& v : city.visible)
      if (v.sector_id == from && v.visible_sector_id == to) return v.reason;
    ADD_FAILURE() << from << " does not list " << to;
    return VisibleReason::self;
  };
  EXPECT_EQ(reason("s0", "s16"), VisibleReason::gate);
  EXPECT_EQ(reason("s16", "s0"), VisibleReason::line_of_sight) << "no gate was given for the way back";
  EXPECT_TRUE(std::any_of(city.visible.begin(), city.visible.end(), [](const Visible& v) {
    return v.building_ids == std::vector<std::string>{"h4"} && v.is_proven;
  }));
}

TEST(ListVisible, LeavesRoofsOutWhereToldAndSaysSo) {
  City city = city_with_a_tower();
  VisibleOptions options;
  options.over_roofs = OverRoofs::no;
  const auto sectors_that_name_the_tower = [&] {
    return std::count_if(city.visible.begin(), city.visible.end(), [](const Visible& v) {
      return std::find(v.building_ids.begin(), v.building_ids.end(), "h4") != v.building_ids.end();
    });
  };
  list_visible(city, options);
  EXPECT_EQ(city.meta["over_roofs"], "no");
  const auto on_the_level = sectors_that_name_the_tower();
  for (const auto& v : city.visible) EXPECT_TRUE(v.is_proven);
  options.over_roofs = OverRoofs::automatic;
  list_visible(city, options);
  EXPECT_EQ(city.meta["over_roofs"], "yes");
  EXPECT_LT(on_the_level, sectors_that_name_the_tower());
}

TEST(ListVisible, ListsLandmarksAlone) {
  City city = city_with_a_tower();
  city.buildings[0].height_m = city.buildings[0].eave_m = kLandmark_m - 1;  // seen over roofs, too, and no landmark
  const auto over_roofs = [&](OverRoofs which) {
    VisibleOptions options;
    options.over_roofs = which;
    list_visible(city, options);
    std::set<std::pair<std::string, std::string>> sights;  // sector, house
    for (const auto& v : city.visible)
      for (const auto& house : v.building_ids) sights.insert({v.sector_id, house});
    return sights;
  };
  const auto none = over_roofs(OverRoofs::no), all = over_roofs(OverRoofs::yes), few = over_roofs(OverRoofs::landmarks);
  EXPECT_EQ(city.meta["over_roofs"], "landmarks");
  std::set<std::pair<std::string, std::string>> expected = none;
  for (const auto& sight : all)
    if (sight.second == "h4") expected.insert(sight);
  EXPECT_EQ(few, expected);
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const auto& s) { return s.second == "h0" && !few.contains(s); }));
}

TEST(ListVisible, NamesAHouseSeenOnTheLevelWhoseSectorIsNot) {
  City city = city_with_a_tower();
  VisibleOptions options;
  options.over_roofs = OverRoofs::no;
  list_visible(city, options);
  // The house of the block beside s0 becomes that of a sector that s0 does not see.
  std::set<std::string> seen;
  for (const auto& v : city.visible)
    if (v.sector_id == "s0") seen.insert(v.visible_sector_id);
  const auto far =
      std::find_if(city.sectors.begin(), city.sectors.end(), [&](const Sector& s) { return !seen.contains(s.id); });
  ASSERT_NE(far, city.sectors.end());
  city.buildings[0].sector_id = far->id;
  list_visible(city, options);
  const auto row = std::find_if(city.visible.begin(), city.visible.end(), [&](const Visible& v) {
    return v.sector_id == "s0" && v.visible_sector_id == far->id;
  });
  ASSERT_NE(row, city.visible.end());
  EXPECT_EQ(row->reason, VisibleReason::over_roofs);
  EXPECT_EQ(row->building_ids, std::vector<std::string>{city.buildings[0].id});
  EXPECT_TRUE(row->is_proven);
}

/// Issue 404.
TEST(ListVisible, RaisesSightOverBudgetForEachLooserList) {
  City city = city_with_a_tower();
  VisibleOptions options;
  options.over_roofs = OverRoofs::no;
  options.step_budget = 10;
  list_visible(city, options);
  ASSERT_FALSE(city.issues.empty());
  EXPECT_EQ(city.issues[0].code, IssueCode::sight_over_budget);
  EXPECT_NE(city.issues[0].message.find("sector s"), std::string::npos) << city.issues[0].message;
}

}  // namespace
}  // namespace vicus::test
