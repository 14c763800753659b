#include "sectorgen/models/solid_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sectorgen/models/roof_flat.hpp"
#include "tests/unit/sectorgen/models/roof_plans.hpp"

/// The checker first: a sound roof passes, every way of breaking it is found.
namespace vicus::test {
namespace {

const Polygon kPlan{ring_of({{0, 0}, {12, 0}, {12, 8}, {0, 8}}), {}};
constexpr double kEave_m = 5;

/// Gabled, written by hand: ridge from (0, 4) to (12, 4), 3 m high.
Roof gabled() {
  const auto at = [](double x, double y, double up) {
    return RoofPoint{{lattice_mm(x), lattice_mm(y)}, roof_steps(up)};
  };
  Roof roof;
  roof.points = {at(0, 0, 5), at(12, 0, 5), at(12, 8, 5), at(0, 8, 5), at(0, 4, 8), at(12, 4, 8)};
  roof.facets = {{FacetKind::slope, {{0, 1, 5, 4}}, {}},
                 {FacetKind::gable, {{1, 2, 5}}, {}},
                 {FacetKind::slope, {{2, 3, 4, 5}}, {}},
                 {FacetKind::gable, {{3, 0, 4}}, {}}};
  return roof;
}

std::string fault(const Roof& roof) { return fault_of_roof(kPlan, kEave_m, roof).value_or("none"); }

TEST(FaultOfRoof, IsNoneForASoundRoof) {
  EXPECT_EQ(fault(gabled()), "none");
  EXPECT_EQ(fault(flat_roof(kPlan, kEave_m)), "none");
}

TEST(FaultOfRoof, FindsAFacetThatIsMissing) {
  for (std::size_t f = 0; f < 4; ++f) {
    Roof roof = gabled();
    roof.facets.erase(roof.facets.begin() + static_cast<std::ptrdiff_t>(f));
    EXPECT_EQ(fault(roof), "an open edge") << f;
  }
}

TEST(FaultOfRoof, FindsAFacetThatIsTurnedOver) {
  for (std::size_t f = 0; f < 4; ++f) {
    Roof roof = gabled();
    auto& ring = roof.facets[f].rings[0];
    std::reverse(ring.begin(), ring.end());
    EXPECT_NE(fault(roof), "none") << f;
  }
}

TEST(FaultOfRoof, FindsAFacetThatIsThereTwice) {
  Roof roof = gabled();
  roof.facets.push_back(roof.facets[0]);
  EXPECT_EQ(fault(roof), "an edge used twice in one direction");
}

TEST(FaultOfRoof, FindsABentFacet) {
  Roof roof = gabled();
  roof.points[5].up += 60;  // 6 mm: half of it off the plane through the four
  EXPECT_EQ(fault(roof), "a facet that is not planar");
  roof.points[5].up -= 50;
  EXPECT_EQ(fault(roof), "none") << "1 mm of height is less than 1 mm off the plane";
}

TEST(FaultOfRoof, FindsARidgeThatLeavesTheHouse) {
  Roof roof = gabled();
  roof.points[5].at.x += 1;
  EXPECT_EQ(fault(roof), "a gable that leans outwards");
  roof.points[5].at.x -= 3;
  EXPECT_EQ(fault(roof), "none") << "2 mm inwards is rounding";
  roof.points[5].at.x -= 1;
  EXPECT_EQ(fault(roof), "a gable that leans inwards");
}

TEST(FaultOfRoof, FindsSlopesThatCross) {
  Roof roof = flat_roof(kPlan, kEave_m);
  roof.points[2].at = {2'000, 8'000};
  roof.points[3].at = {10'000, 8'000};
  roof.facets[0].kind = FacetKind::slope;
  EXPECT_EQ(fault(roof), "a slope that crosses or touches itself in plan");
}

TEST(FaultOfRoof, FindsAPointBelowTheEaveAndATopThatIsNotLevel) {
  Roof roof = gabled();
  roof.points[4].up = roof_steps(4);
  EXPECT_EQ(fault(roof), "a point below the eave");
  roof = flat_roof(kPlan, kEave_m);
  roof.points[0].up += 1;
  EXPECT_EQ(fault(roof), "a top that is not level");
}

TEST(FaultOfRoof, FindsARimThatIsNotTheFootprints) {
  Roof roof = gabled();
  EXPECT_NE(fault_of_roof(kPlan, kEave_m - 1, roof), std::nullopt) << "walls that end below the roof";
  Polygon noded = kPlan;
  noded.outer.insert(noded.outer.begin() + 1, PlanPoint{6'000, 0});
  EXPECT_EQ(fault_of_roof(noded, kEave_m, roof), "an open edge") << "a neighbour's corner on the eave";
}

TEST(FaultOfRoof, FindsBadIndicesAndRings) {
  Roof roof = gabled();
  roof.facets[0].rings[0][0] = 6;
  EXPECT_EQ(fault(roof), "an index beyond the points");
  roof.facets[0].rings[0] = {0, 1};
  EXPECT_EQ(fault(roof), "a ring of two points");
  roof.facets[0].rings.clear();
  EXPECT_EQ(fault(roof), "a facet without a ring");
}

TEST(FaultOfRoof, SeesHolesInTops) {
  Polygon plan = kPlan;
  plan.holes = {ring_of({{3, 3}, {3, 6}, {6, 6}, {6, 3}})};
  Roof roof = flat_roof(plan, kEave_m);
  EXPECT_EQ(fault_of_roof(plan, kEave_m, roof), std::nullopt);
  roof.facets[0].rings.pop_back();
  EXPECT_EQ(fault_of_roof(plan, kEave_m, roof), "an open edge") << "a lid over the courtyard";
}

}  // namespace
}  // namespace vicus::test
