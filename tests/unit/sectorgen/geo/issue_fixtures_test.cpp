#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/map_checks.hpp"

namespace vicus::test {
namespace {

/// One tiny map per issue code, named after it. The houses are 14 x 22 m, all within 100 m of each other.
struct Fixture {
  const char* file;
  IssueCode code;
  const char* source_id;
  std::size_t footprints, axes;
};

std::ostream& operator<<(std::ostream& out, const Fixture& fixture) { return out << fixture.file; }

class IssueFixture : public testing::TestWithParam<Fixture> {};

TEST_P(IssueFixture, RaisesItsCodeOnceAndNothingElse) {
  const Fixture& fixture = GetParam();
  LoadOptions options;
  options.inputs = {std::filesystem::path(VICUS_TESTS) / "fixtures/issues" / fixture.file};
  options.origin = LatLon{50, 9.9995};  // beside the houses, so that every place differs from it
  const Loaded loaded = load(options);
  ASSERT_EQ(loaded.issues.size(), 1u);
  const Issue& issue = loaded.issues[0];
  EXPECT_EQ(issue.code, fixture.code);
  EXPECT_EQ(issue.source_id, fixture.source_id);
  EXPECT_GT(issue.message.size(), 10u);
  EXPECT_EQ(loaded.map.footprints.size(), fixture.footprints);
  EXPECT_EQ(loaded.map.axes.size(), fixture.axes);
  EXPECT_EQ(broken_promise(loaded.map), "");
  const bool has_place = fixture.code != IssueCode::unreadable_feature && fixture.code != IssueCode::outside_limits;
  constexpr int kNearMm = 130'000;
  EXPECT_EQ(issue.at != PlanPoint{}, has_place);
  EXPECT_LT(std::max(std::abs(issue.at.x), std::abs(issue.at.y)), kNearMm);
}

TEST_P(IssueFixture, IsNamedAfterItsCode) {
  const Fixture& fixture = GetParam();
  const std::string name = std::to_string(static_cast<int>(fixture.code)) + "_" + name_of(fixture.code);
  EXPECT_EQ(std::filesystem::path(fixture.file).stem().string(), name);
}

INSTANTIATE_TEST_SUITE_P(
    All, IssueFixture,
    testing::Values(Fixture{"101_unreadable_feature.geojson", IssueCode::unreadable_feature, "buildings#1", 1, 0},
                    Fixture{"102_outside_limits.geojson", IssueCode::outside_limits, "buildings#2", 2, 0},
                    Fixture{"103_unknown_attribute_value.osm", IssueCode::unknown_attribute_value, "way/101", 1, 0},
                    Fixture{"201_ring_open.osm", IssueCode::ring_open, "way/101", 1, 0},
                    Fixture{"202_ring_self_intersection.osm", IssueCode::ring_self_intersection, "way/101", 2, 0},
                    Fixture{"203_ring_too_few_points.osm", IssueCode::ring_too_few_points, "way/102", 1, 0},
                    Fixture{"204_duplicate.osm", IssueCode::duplicate, "way/102", 1, 0},
                    Fixture{"205_sliver.osm", IssueCode::sliver, "way/102", 1, 0},
                    Fixture{"206_overlap.osm", IssueCode::overlap, "way/102", 2, 0},
                    Fixture{"207_gap.osm", IssueCode::gap, "way/102", 2, 0},
                    Fixture{"208_building_in_street.osm", IssueCode::building_in_street, "way/102", 1, 1},
                    Fixture{"209_no_height.osm", IssueCode::no_height, "way/101", 1, 0},
                    Fixture{"210_absurd_height.osm", IssueCode::absurd_height, "way/101", 1, 0},
                    Fixture{"211_hole_outside.geojson", IssueCode::hole_outside, "buildings#0", 1, 0},
                    Fixture{"212_incomplete_relation.osm", IssueCode::incomplete_relation, "relation/201", 2, 0},
                    Fixture{"213_part_outside.osm", IssueCode::part_outside, "way/102", 2, 0},
                    Fixture{"302_street_too_short.osm", IssueCode::street_too_short, "way/102", 1, 0}),
    [](const auto& info) {
      std::string name = std::filesystem::path(info.param.file).stem().string();
      return "Code" + name.substr(0, 3);
    });

TEST(IssueRepairs, AGapIsGoneAndBothHousesShareTheirCorners) {
  const Loaded loaded = load({std::filesystem::path(VICUS_TESTS) / "fixtures/issues/207_gap.osm"});
  ASSERT_EQ(loaded.map.footprints.size(), 2u);
  std::size_t shared = 0;
  for (PlanPoint p : loaded.map.footprints[0].area.outer)
    for (PlanPoint q : loaded.map.footprints[1].area.outer) shared += p == q;
  EXPECT_EQ(shared, 2u);
}

TEST(IssueRepairs, AnAbsurdHeightFallsBackToTheLevels) {
  const Loaded loaded = load({std::filesystem::path(VICUS_TESTS) / "fixtures/issues/210_absurd_height.osm"});
  ASSERT_EQ(loaded.map.footprints.size(), 1u);
  EXPECT_EQ(loaded.map.footprints[0].height_m, 12);
  EXPECT_EQ(loaded.map.footprints[0].height_source, HeightSource::levels);
}

TEST(IssueRepairs, ALostPartBecomesAHouse) {
  const Loaded loaded = load({std::filesystem::path(VICUS_TESTS) / "fixtures/issues/213_part_outside.osm"});
  for (const Footprint& footprint : loaded.map.footprints) EXPECT_FALSE(footprint.is_part) << footprint.source_id;
}

TEST(IssueRepairs, ABowTieKeepsBothTriangles) {
  const Loaded loaded = load({std::filesystem::path(VICUS_TESTS) / "fixtures/issues/202_ring_self_intersection.osm"});
  double area = 0;
  for (const Footprint& footprint : loaded.map.footprints) area += area_by_geos_m2(footprint.area);
  // Half of the 14.33 x 22.25 m between its corners.
  EXPECT_NEAR(area, 14.33 * 22.25 / 2, 0.5);
}

}  // namespace
}  // namespace vicus::test
