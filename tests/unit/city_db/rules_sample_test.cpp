#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "city_db/rules.hpp"
#include "tests/support/sample_city.hpp"

/// Each rule is broken in several ways in the sample city; the checker must name it, and no other where none else is
/// concerned.
namespace vicus {
namespace {

using test::sample_city;

std::string broken_rules(const City& city) {
  const auto report = check_rules(city);
  std::string names;
  for (std::size_t r = 0; r < kRuleCount; ++r)
    if (!report.holds(static_cast<Rule>(r)))
      names += std::string(names.empty() ? "" : " ") + name_of(static_cast<Rule>(r));
  return names;
}

template <class T>
T& by_id(std::vector<T>& records, const std::string& id) {
  return *std::find_if(records.begin(), records.end(), [&](const T& r) { return r.id == id; });
}

Border& border_of(City& city, const std::string& sector, const std::string& building) {
  return *std::find_if(city.borders.begin(), city.borders.end(),
                       [&](const Border& b) { return b.sector_id == sector && b.building_id == building; });
}

PlanPoint metres_at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

/// Moves a vertex wherever a ring or line has it.
void move_everywhere(City& city, PlanPoint from, PlanPoint to) {
  const auto line = [&](std::vector<PlanPoint>& points) { std::replace(points.begin(), points.end(), from, to); };
  const auto polygon = [&](Polygon& p) {
    line(p.outer);
    for (auto& hole : p.holes) line(hole);
  };
  for (auto& d : city.domain) polygon(d);
  for (auto& s : city.sectors) polygon(s.ground);
  for (auto& b : city.buildings) polygon(b.footprint);
  for (auto& o : city.obstacles) polygon(o.area);
  for (auto& g : city.gates) line(g.line);
  for (auto& b : city.borders) line(b.line);
}

TEST(RulesSample, HoldsEveryRule) {
  const auto report = check_rules(sample_city());
  for (const auto& v : report.violations)
    ADD_FAILURE() << name_of(v.rule) << " " << v.id << " " << v.message << " at " << v.at.x << "," << v.at.y;
  EXPECT_TRUE(report.all_hold());
  EXPECT_TRUE(report.is_noded);
  EXPECT_EQ(report.area_error_mm2, 0.0);
  EXPECT_EQ(report.walkable_mm2, report.sectors_mm2);
  EXPECT_EQ(report.components, 1u);
}

TEST(RulesSample, AnEmptyCityHoldsEveryRule) { EXPECT_EQ(broken_rules(City{}), ""); }

TEST(RulesSample, HoldsWhenAVertexOfAllMovesTogether) {
  City city = sample_city();
  move_everywhere(city, metres_at(5, 5), metres_at(5.001, 5.002));
  EXPECT_EQ(broken_rules(city), "");
}

// Rule 1 --------------------------------------------------------------------------------------------------------

TEST(RulesPartition, BreaksByOneMillimetreOfASectorsVertex) {
  City city = sample_city();
  auto& ring = by_id(city.sectors, "s-main-e").ground.outer;
  auto& corner = *std::find(ring.begin(), ring.end(), metres_at(24, 5));
  corner.x += 1;  // along the facade: no area changes, yet the vertex lies inside a house's edge
  EXPECT_NE(broken_rules(city).find("partition"), std::string::npos);
}

TEST(RulesPartition, BreaksByOneMillimetreOfAHouse) {
  City city = sample_city();
  auto& ring = by_id(city.buildings, "b-8").footprint.outer;
  *std::find(ring.begin(), ring.end(), metres_at(5, -5)) = metres_at(5.001, -5.001);
  const auto report = check_rules(city);
  EXPECT_FALSE(report.holds(Rule::partition));
  EXPECT_TRUE(report.is_noded);
  EXPECT_EQ(report.area_error_mm2, 10e3 + 12.5e3);  // triangles of 20 and 25 m by 1 mm
}

TEST(RulesPartition, BreaksWhereAnIslandIsNotLeftOut) {
  City city = sample_city();
  by_id(city.sectors, "s-main-e").ground.holes.clear();
  std::erase_if(city.borders, [](const Border& b) { return b.kind == BorderKind::edge; });
  EXPECT_EQ(broken_rules(city), "partition");
  EXPECT_EQ(check_rules(city).area_error_mm2, 6e6);
}

TEST(RulesPartition, BreaksWhereAHoleIsLeftUncovered) {
  City city = sample_city();
  std::erase_if(city.obstacles, [](const Obstacle& o) { return o.kind == ObstacleKind::island; });
  EXPECT_EQ(broken_rules(city), "partition edges");  // one could walk on beyond the island's edge
  EXPECT_EQ(check_rules(city).area_error_mm2, 6e6);
}

TEST(RulesPartition, BreaksWhereTwoSectorsShareGround) {
  City city = sample_city();
  auto twice = by_id(city.sectors, "s-yard");
  twice.id = "s-yard-again";
  std::rotate(twice.ground.outer.begin(), twice.ground.outer.begin() + 1, twice.ground.outer.end());
  city.sectors.push_back(twice);
  city.visible.push_back({twice.id, twice.id, VisibleReason::self, true, {}});
  EXPECT_EQ(broken_rules(city), "partition edges connected");
  EXPECT_EQ(check_rules(city).area_error_mm2, 40e3 * 14e3);
}

TEST(RulesPartition, BreaksWhereASectorLeavesTheDomain) {
  City city = sample_city();
  for (auto& p : city.domain[0].outer)
    if (p == metres_at(60, 5)) p.x -= 1;
  EXPECT_NE(broken_rules(city).find("partition"), std::string::npos);
}

TEST(RulesPartition, BreaksByRingsThatTurnTheWrongWay) {
  City city = sample_city();
  std::reverse(city.obstacles[0].area.outer.begin(), city.obstacles[0].area.outer.end());
  EXPECT_EQ(broken_rules(city), "partition");
}

TEST(RulesPartition, BreaksOffTheLattice) {
  City city = sample_city();
  by_id(city.sectors, "s-yard").ground.outer[0].x = kPlanLimit;
  EXPECT_EQ(broken_rules(city), "partition edges facades houses_whole connected identity");
}

TEST(RulesPartition, SeesHolesThatNestInTheWrongSector) {
  City city = sample_city();
  // Every point is covered as often as it should be, but the island's hole is cut out of another sector's polygon.
  auto& holes = by_id(city.sectors, "s-main-e").ground.holes;
  by_id(city.sectors, "s-yard").ground.holes = holes;
  holes.clear();
  for (auto& b : city.borders)
    if (b.kind == BorderKind::edge) b.sector_id = "s-yard";
  EXPECT_EQ(broken_rules(city), "partition connected");
}

// Rule 2 --------------------------------------------------------------------------------------------------------

TEST(RulesEdges, BreakWithoutAGate) {
  City city = sample_city();
  std::erase_if(city.gates,
                [](const Gate& g) { return g.id == "s-main-w-to-s-cross" || g.twin_id == "s-main-w-to-s-cross"; });
  EXPECT_EQ(broken_rules(city), "edges connected");
}

TEST(RulesEdges, BreakWithoutOneOfTwins) {
  City city = sample_city();
  std::erase_if(city.gates, [](const Gate& g) { return g.id == "s-main-w-to-s-cross"; });
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakByTwinsSwapped) {
  City city = sample_city();
  std::swap(by_id(city.gates, "s-main-w-to-s-cross").twin_id, by_id(city.gates, "s-north-to-s-cross").twin_id);
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakByATwinWithTheSameDirection) {
  City city = sample_city();
  auto& line = by_id(city.gates, "s-cross-to-s-north").line;
  std::reverse(line.begin(), line.end());
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakByAGateToAnotherSector) {
  City city = sample_city();
  by_id(city.gates, "s-cross-to-s-north").to_sector_id = "s-south";
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakByABorderAcrossAStreet) {
  City city = sample_city();
  std::erase_if(city.gates, [](const Gate& g) { return g.sector_id == "s-yard" || g.to_sector_id == "s-yard"; });
  city.borders.push_back({"s-yard", "", BorderKind::fence, 1, {metres_at(24, 22), metres_at(28, 22)}});
  city.borders.push_back({"s-passage", "", BorderKind::fence, 1, {metres_at(28, 22), metres_at(24, 22)}});
  EXPECT_EQ(broken_rules(city), "edges connected");
}

TEST(RulesEdges, BreakByAGateOutInTheMiddle) {
  City city = sample_city();
  auto& gate = by_id(city.gates, "s-cross-to-s-north");
  gate.to_sector_id = gate.twin_id = "";
  gate.kind = GateKind::end_of_city;
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakWithoutAnEndOfCityGate) {
  City city = sample_city();
  std::erase_if(city.gates, [](const Gate& g) { return g.id == "s-north-to-out"; });
  EXPECT_EQ(broken_rules(city), "edges");
  city.borders.push_back({"s-north", "", BorderKind::edge, 0, {metres_at(5, 40), metres_at(-5, 40)}});
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakByAnotherBuildingsFacade) {
  City city = sample_city();
  border_of(city, "s-main-e", "b-8").building_id = "b-9";
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakByABankWithoutWater) {
  City city = sample_city();
  for (auto& o : city.obstacles)
    if (o.kind == ObstacleKind::water) o.kind = ObstacleKind::wall;
  EXPECT_EQ(broken_rules(city), "edges");
}

TEST(RulesEdges, BreakByALineOverACorner) {
  City city = sample_city();
  auto& line = border_of(city, "s-passage", "b-3").line;
  line.insert(line.begin() + 1, metres_at(24, 10));
  EXPECT_EQ(broken_rules(city), "edges facades");
}

TEST(RulesEdges, BreakByALineThatJumps) {
  City city = sample_city();
  // b-8 and b-9 stand in a row: one border of both is a run, but names one building for the other's wall.
  auto& first = border_of(city, "s-main-e", "b-8");
  first.line.push_back(metres_at(60, -5));
  std::erase_if(city.borders, [](const Border& b) { return b.sector_id == "s-main-e" && b.building_id == "b-9"; });
  EXPECT_EQ(broken_rules(city), "edges");
}

// Rule 3 --------------------------------------------------------------------------------------------------------

TEST(RulesFacades, BreakWhereAFacadeIsSentTwice) {
  City city = sample_city();
  auto again = border_of(city, "s-north", "b-3");
  again.sector_id = "s-cross";
  city.borders.push_back(again);
  EXPECT_EQ(broken_rules(city), "edges facades");
}

TEST(RulesFacades, BreakWhereAFacadeIsCalledAFence) {
  City city = sample_city();
  city.obstacles.push_back({ObstacleKind::fence, "", 1, by_id(city.buildings, "b-3").footprint});
  border_of(city, "s-north", "b-3").kind = BorderKind::fence;
  EXPECT_EQ(broken_rules(city), "facades");
}

TEST(RulesFacades, AnObstacleOverAHouseChangesNothing) {
  City city = sample_city();
  city.obstacles.push_back({ObstacleKind::fence, "", 1, by_id(city.buildings, "b-3").footprint});
  EXPECT_EQ(broken_rules(city), "");
}

// Rule 4 --------------------------------------------------------------------------------------------------------

TEST(RulesHouses, BreakByAGateThroughAHouse) {
  City city = sample_city();
  Building kiosk = by_id(city.buildings, "b-1");
  kiosk.id = "b-kiosk";
  kiosk.footprint = {{metres_at(-6, -1), metres_at(-4, -1), metres_at(-4, 1), metres_at(-6, 1)}, {}};
  city.buildings.push_back(kiosk);
  EXPECT_NE(broken_rules(city).find("houses_whole"), std::string::npos);
}

TEST(RulesHouses, BreakByADiagonalThroughCorners) {
  City city = sample_city();
  Gate gate;
  gate.id = "diagonal";
  gate.sector_id = "s-main-e";
  gate.line = {metres_at(5, -25), metres_at(30, -5)};  // from corner to corner of b-8
  city.gates.push_back(gate);
  EXPECT_FALSE(check_rules(city).holds(Rule::houses_whole));
}

TEST(RulesHouses, HoldWhereAGateRunsAlongAWall) {
  City city = sample_city();
  Gate gate;
  gate.id = "along";
  gate.sector_id = "s-main-e";
  gate.line = {metres_at(5, -5), metres_at(60, -5)};
  city.gates.push_back(gate);
  EXPECT_TRUE(check_rules(city).holds(Rule::houses_whole));
}

TEST(RulesHouses, HoldUnderAHouseOnPillars) {
  EXPECT_TRUE(check_rules(sample_city()).holds(Rule::houses_whole));  // b-4 spans the passage
  City city = sample_city();
  by_id(city.buildings, "b-4").base_m = 0;
  EXPECT_NE(broken_rules(city).find("partition"), std::string::npos);
}

// Rule 5 --------------------------------------------------------------------------------------------------------

TEST(RulesConnected, BreakByASectorInTwoParts) {
  City city = sample_city();
  // The yard's and the passage's ground in one sector, joined in no edge but told as two rings through one point.
  auto& yard = by_id(city.sectors, "s-yard").ground.outer;
  const Ring passage = by_id(city.sectors, "s-passage").ground.outer;
  yard = {metres_at(24, 22), metres_at(28, 22), metres_at(52, 22),
          metres_at(52, 36), metres_at(12, 36), metres_at(12, 22)};
  Ring both(yard.begin(), yard.end());
  both.insert(both.end(), {metres_at(24, 22), metres_at(24, 5), metres_at(28, 5), metres_at(28, 22)});
  yard = both;
  std::erase_if(city.sectors, [](const Sector& s) { return s.id == "s-passage"; });
  EXPECT_NE(broken_rules(city).find("connected"), std::string::npos);
}

TEST(RulesConnected, BreakByGatesToWhereOneCannotWalk) {
  City city = sample_city();
  by_id(city.gates, "s-north-to-out").to_sector_id = "s-yard";
  std::erase_if(city.gates, [](const Gate& g) { return g.sector_id == "s-passage" || g.to_sector_id == "s-passage"; });
  const auto report = check_rules(city);
  EXPECT_FALSE(report.holds(Rule::connected));
}

// Rules 6 and 7 -------------------------------------------------------------------------------------------------

TEST(RulesBudget, BreakByOneByte) {
  City city = sample_city();
  by_id(city.sectors, "s-yard").bytes = 200'001;
  EXPECT_EQ(broken_rules(city), "budget");
  city.meta["budget_bytes"] = "200001";
  EXPECT_EQ(broken_rules(city), "");
  city.meta["budget_bytes"] = "much";
  EXPECT_EQ(broken_rules(city), "budget");
}

TEST(RulesIdentity, BreakByIds) {
  const auto breaks = [](auto change) {
    City city = sample_city();
    change(city);
    return broken_rules(city);
  };
  EXPECT_EQ(breaks([](City& c) { c.viewpoints[1].id = c.viewpoints[0].id; }), "identity");
  EXPECT_EQ(breaks([](City& c) { c.objects[0].id.clear(); }), "identity");
  EXPECT_EQ(breaks([](City& c) { c.objects.push_back(c.objects[0]); }), "identity");
  EXPECT_EQ(breaks([](City& c) { c.visible.push_back(c.visible[0]); }), "identity");
  EXPECT_EQ(breaks([](City& c) { c.visible[0].visible_sector_id = "nowhere"; }), "identity");
  EXPECT_EQ(breaks([](City& c) { c.buildings[0].sector_id = "nowhere"; }), "identity");
  EXPECT_EQ(breaks([](City& c) {
              c.buildings.push_back(c.buildings[0]);
              c.buildings.back().id = "b-another";
            }),
            "identity");
}

TEST(RulesIdentity, BreakByASectorIdThatIsNoUrlName) {
  City city = sample_city();
  const auto rename = [](std::string& id) {
    if (id == "s-yard") id = "s yard";
  };
  for (auto& s : city.sectors) rename(s.id);
  for (auto& g : city.gates) rename(g.sector_id), rename(g.to_sector_id);
  for (auto& b : city.borders) rename(b.sector_id);
  for (auto& b : city.buildings) rename(b.sector_id);
  for (auto& o : city.objects) rename(o.sector_id);
  for (auto& v : city.viewpoints) rename(v.sector_id);
  for (auto& v : city.visible) rename(v.sector_id), rename(v.visible_sector_id);
  EXPECT_EQ(broken_rules(city), "identity");
}

/// What rule 7 says of the sample city after a change; one line per violation.
std::string identity_faults(const std::function<void(City&)>& change) {
  City city = sample_city();
  change(city);
  std::string text;
  for (const auto& v : check_rules(city).violations)
    if (v.rule == Rule::identity) text += v.id + ": " + v.message + "\n";
  return text;
}

Visible& row_of(City& city, const std::string& from, const std::string& to) {
  return *std::find_if(city.visible.begin(), city.visible.end(),
                       [&](const Visible& v) { return v.sector_id == from && v.visible_sector_id == to; });
}

TEST(RulesVisible, BreakWhereAListIsNotWhole) {
  const auto without = [](const std::string& from, const std::string& to) {
    return identity_faults(
        [&](City& c) { c.visible.erase(c.visible.begin() + (&row_of(c, from, to) - &c.visible[0])); });
  };
  EXPECT_EQ(without("s-yard", "s-yard"), "s-yard: its L_vis lacks the sector itself\n");
  EXPECT_EQ(without("s-yard", "s-passage"),
            "s-yard: its L_vis lacks \"s-passage\", which lies behind its gate s-yard-to-s-passage\n");
  EXPECT_EQ(without("s-main-e", "s-main-w"), "s-main-w: it sees \"s-main-e\" along a line that does not lead back\n");
  EXPECT_EQ(without("s-yard", "s-cross"), "") << "important";
  EXPECT_EQ(without("s-yard", "s-north"), "") << "over roofs";
}

TEST(RulesVisible, BreakByRowsThatCannotBe) {
  const auto after = [](const char* from, const char* to, const std::function<void(Visible&)>& change) {
    return identity_faults([&](City& c) { change(row_of(c, from, to)); });
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(
      has(after("s-yard", "s-north", [](Visible& v) { v.visible_sector_id = "nowhere"; }), "\"nowhere\": one of"));
  EXPECT_TRUE(has(after("s-yard", "s-north", [](Visible& v) { v.building_ids = {"b-99"}; }), "house \"b-99\""));
  EXPECT_TRUE(has(after("s-yard", "s-north", [](Visible& v) { v.building_ids = {"b-2", "b-10"}; }), "not sorted"));
  EXPECT_TRUE(has(after("s-yard", "s-north", [](Visible& v) { v.building_ids = {"b-2", "b-2"}; }), "there twice"));
  EXPECT_TRUE(has(after("s-yard", "s-north", [](Visible& v) { v.reason = VisibleReason::self; }), "\"self\" and"));
  EXPECT_TRUE(has(after("s-yard", "s-yard", [](Visible& v) { v.reason = VisibleReason::gate; }), "\"self\" and"));
  EXPECT_TRUE(has(after("s-yard", "s-passage", [](Visible& v) { v.is_proven = false; }), "stay unproven"));
  EXPECT_TRUE(has(after("s-yard", "s-cross", [](Visible& v) { v.building_ids = {"b-2"}; }), "only over roofs are"));
}

TEST(RulesVisible, HoldBeforeAnythingIsComputed) {
  EXPECT_EQ(identity_faults([](City& c) { c.visible.clear(); }), "");
  EXPECT_EQ(identity_faults([](City& c) {
              std::erase_if(c.visible, [](const Visible& v) { return v.reason != VisibleReason::important; });
              ASSERT_EQ(c.visible.size(), 1u);
            }),
            "");
}

TEST(RulesReport, CountsAllButListsFew) {
  City city = sample_city();
  for (int i = 0; i < 30; ++i) city.objects.push_back(city.objects[0]);
  const auto report = check_rules(city, {.listed_per_rule = 4});
  EXPECT_EQ(report.violation_counts[static_cast<std::size_t>(Rule::identity)], 30u);
  EXPECT_EQ(report.violations.size(), 4u);
}

}  // namespace
}  // namespace vicus
