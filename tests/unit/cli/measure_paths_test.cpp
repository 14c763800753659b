#include "cli/measure_paths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "city_db/store.hpp"
#include "city_db/surroundings.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/bake/render/camera.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"

namespace vicus::measure {
namespace {

double apart(const Enu& a, const Enu& b) { return std::hypot(a.east - b.east, a.north - b.north, a.up - b.up); }

struct Sample {
  Sample() { write_city(scratch / "city.gpkg", city, nullptr); }
  test::ScratchDirectory scratch;
  City city = test::sample_city();
};

TEST(WalkTour, IsTheSameForTheSameSeedAndLeadsOnWithoutLeaps) {
  const Sample sample;
  const Guide guide(sample.scratch / "city.gpkg");
  const Tour tour = walk_tour(guide, sample.city, 5), again = walk_tour(guide, sample.city, 5);
  EXPECT_GT(tour.length_m, 50);
  EXPECT_LE(tour.length_m, kWalk_m);
  ASSERT_EQ(tour.points.size(), again.points.size());
  for (std::size_t i = 0; i < tour.points.size(); ++i) EXPECT_EQ(tour.points[i].at, again.points[i].at);
  constexpr double kStep_m = 0.25;
  Pose before = walk_pose(tour, 0);
  for (double s = kStep_m; s <= tour.length_m; s += kStep_m) {
    const Pose pose = walk_pose(tour, s);
    const double ground = height_m(sample.city.terrain, {lattice_mm(pose.eye.east), lattice_mm(pose.eye.north)});
    EXPECT_NEAR(pose.eye.up, ground + kTourEye_m, 0.5);
    EXPECT_LE(std::hypot(pose.eye.east - before.eye.east, pose.eye.north - before.eye.north), kStep_m + 0.001);
    EXPECT_GT(apart(pose.eye, pose.look), 0.05);
    EXPECT_NEAR(pose.eye.up, pose.look.up, 1e-9);
    const auto is_here = [&](const Sector& sector) { return sector.id == pose.sector_id; };
    EXPECT_TRUE(std::any_of(sample.city.sectors.begin(), sample.city.sectors.end(), is_here));
    before = pose;
  }
}

TEST(FlyPath, KeepsItsHeightAndLooksThirtyDegreesDown) {
  const City city = test::sample_city();
  const FlyPath path(city);
  Pose before = path.at(0);
  for (double s = 10; s <= kFly_m; s += 10) {
    const Pose pose = path.at(s);
    EXPECT_NEAR(std::hypot(pose.eye.east - before.eye.east, pose.eye.north - before.eye.north), 10, 0.05);
    EXPECT_NEAR(pose.eye.up - kFlyUp_m, height_m(city.terrain, {lattice_mm(pose.eye.east), lattice_mm(pose.eye.north)}),
                1e-9);
    const double level = std::hypot(pose.look.east - pose.eye.east, pose.look.north - pose.eye.north);
    EXPECT_NEAR(std::atan2(pose.eye.up - pose.look.up, level), kFlyDown_deg * 3.14159265 / 180, 1e-6);
    before = pose;
  }
}

TEST(OverviewPose, SeesEveryHouse) {
  const City city = test::sample_city();
  const Pose pose = overview_pose(city, kFieldOfView);
  const Camera camera = camera_at(pose.eye, pose.look, kFieldOfView, 640, 480);
  for (const Building& house : city.buildings)
    for (const PlanPoint p : house.footprint.outer) {
      const Vec3 seen = seen_at(camera, {metres(p.x), metres(p.y), house.ground_m});
      EXPECT_GT(seen[2], 0);
      for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        EXPECT_GE(seen[axis], 0) << house.id;
        EXPECT_LE(seen[axis], 1) << house.id;
      }
    }
}

TEST(KeyPlaces, BeginAndEndWithThePath) {
  EXPECT_EQ(key_places(400, 5), (std::vector<double>{0, 100, 200, 300, 400}));
  EXPECT_EQ(key_places(400, 1), (std::vector<double>{200}));
  EXPECT_TRUE(key_places(400, 0).empty());
}

}  // namespace
}  // namespace vicus::measure
