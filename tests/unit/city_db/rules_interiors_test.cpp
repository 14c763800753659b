#include <gtest/gtest.h>

#include <functional>

#include "city_db/rules.hpp"
#include "tests/support/sample_interior.hpp"

/// The rules of interiors, each broken in one way; the checker must name it, and no other.
namespace vicus {
namespace {

std::string broken_rules(const City& city) {
  const auto report = check_rules(city);
  std::string names;
  for (std::size_t r = 0; r < kRuleCount; ++r)
    if (!report.holds(static_cast<Rule>(r)))
      names += std::string(names.empty() ? "" : " ") + name_of(static_cast<Rule>(r));
  return names;
}

std::string broken_by(const std::function<void(City&)>& change) {
  City city = test::sample_city_with_interior();
  change(city);
  return broken_rules(city);
}

TEST(RulesInteriors, HoldInTheSample) {
  for (const auto& v : check_rules(test::sample_city_with_interior()).violations)
    ADD_FAILURE() << name_of(v.rule) << " " << v.id << " " << v.message;
}

TEST(RulesInteriors, ARoomLiesInItsHouse) {
  EXPECT_EQ(broken_by([](City& c) { c.interiors[1].sector.ground.outer[1].x = 31'000; }), "houses_whole");
  EXPECT_EQ(broken_by([](City& c) { c.interiors[0].building_id = "b-9"; }), "houses_whole");
  EXPECT_EQ(broken_by([](City& c) { c.interiors[0].building_id = "nowhere"; }), "identity");
}

TEST(RulesInteriors, RoomsDoNotOverlap) {
  EXPECT_EQ(broken_by([](City& c) { c.interiors[1].sector.ground.outer[0].x = 13'000; }), "houses_whole");
}

TEST(RulesInteriors, EveryDoorHasItsTwin) {
  EXPECT_EQ(broken_by([](City& c) { c.doors[1].a.x += 1; }), "edges");
  EXPECT_EQ(broken_by([](City& c) { c.doors[3].twin_id = "hall-d1"; }), "edges");
  EXPECT_EQ(broken_by([](City& c) { c.doors[2].id = "hall-d1"; }), "edges connected identity");
}

TEST(RulesInteriors, ADoorIsAnEdgeOfItsRoomAndStandsInAFacade) {
  EXPECT_EQ(broken_by([](City& c) {
              for (auto& p : c.interiors[0].sector.ground.outer)
                if (p == PlanPoint{11'000, -5'000}) p.x -= 100;
            }),
            "edges");
  EXPECT_EQ(broken_by([](City& c) {  // 20 mm behind the facade, on both sides
              for (auto& p : c.interiors[0].sector.ground.outer)
                if (p.y == -5'000) p.y -= 20;
              for (int i : {0, 1}) c.doors[i].a.y = c.doors[i].b.y = -5'020;
            }),
            "edges");
  EXPECT_EQ(broken_by([](City& c) { c.doors[0].sector_id = c.doors[1].to_sector_id = "s-north"; }), "edges");
}

TEST(RulesInteriors, EveryRoomIsReached) {
  EXPECT_EQ(broken_by([](City& c) { c.doors.erase(c.doors.begin() + 2, c.doors.end()); }), "connected");
  EXPECT_EQ(broken_by([](City& c) { c.doors.erase(c.doors.begin(), c.doors.begin() + 2); }), "connected");
}

TEST(RulesInteriors, IdsAndBytes) {
  EXPECT_EQ(broken_by([](City& c) {
              c.interiors[1].sector.id = "s-yard";
              for (auto& d : c.doors) {
                if (d.sector_id == "kitchen") d.sector_id = "s-yard";
                if (d.to_sector_id == "kitchen") d.to_sector_id = "s-yard";
              }
            }),
            "identity");
  EXPECT_EQ(broken_by([](City& c) { c.interiors[0].sector.bytes = 200'001; }), "budget");
}

}  // namespace
}  // namespace vicus
