#include "sectorgen/sectors/tours/corner_caps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sectorgen/sectors/tours/round_bends.hpp"
#include "sectorgen/sectors/tours/shortest_walk.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/walk_oracle.hpp"

namespace vicus::test {
namespace {

constexpr double kNearEnds_mm = 1500;  // who begins at a wall is at the wall
constexpr double kLeastShare = 0.5;    // of the clearance, at corners whose cap would cut off ground were it whole
constexpr double kMoved_mm = 3;        // walls by noding, points by rounding

double length_of(const Walk& walk) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < walk.points.size(); ++i)
    sum += std::hypot(double(walk.points[i + 1].x) - walk.points[i].x, double(walk.points[i + 1].y) - walk.points[i].y);
  return sum;
}

/// Is there a wall's end within the clearance from which other walls are so near that there is no room: nearer than
/// clearance / kRoomShare across ground?
bool is_narrow(const WalkGround& ground, double x, double y) {
  constexpr double kReach_mm = kWalkClearance_mm / kRoomShare;
  int near = 0;
  for (const auto& w : ground.walls) {
    const double dx = double(w.b.x) - w.a.x, dy = double(w.b.y) - w.a.y;
    const double share = std::clamp(((x - w.a.x) * dx + (y - w.a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    near += std::hypot(w.a.x + share * dx - x, w.a.y + share * dy - y) < kReach_mm;
  }
  return near > 2;  // more than the two walls of one corner
}

TEST(CornerCaps, KeepWalksOffWallsWhereThereIsRoom) {
  std::size_t samples = 0, narrow = 0, smaller = 0;
  for (const auto seed : seeds(1, 8)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const City city = random_town_city(seed);
    const WalkMesh walk = make_clear_walk_mesh(city.sectors, city.gates, kWalkClearance_mm);
    const WalkPlaces places(walk);
    const SightGraph graph = make_sight_graph(walk);
    ShortestWalk shortest(walk, places, graph);
    const WalkGround ground = walk_ground(city.sectors, city.gates);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 12; ++i) {
      const auto place = [&] {
        const auto& t = ground.triangles[random() % ground.triangles.size()];
        return places.nearest({(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3}, 5000);
      };
      const auto from = place(), to = place();
      ASSERT_TRUE(from && to);
      const auto found = shortest.find(from->at, to->at);
      if (!found) continue;
      const auto rounded = round_bends(*found);
      for (std::size_t p = 0; p + 1 < rounded.size(); ++p)
        for (double share = 0; share < 1; share += 0.25) {
          const double walked = std::lerp(rounded[p].walked_mm, rounded[p + 1].walked_mm, share);
          if (walked < kNearEnds_mm || walked > rounded.back().walked_mm - kNearEnds_mm) continue;
          const double x = std::lerp(rounded[p].east_mm, rounded[p + 1].east_mm, share),
                       y = std::lerp(rounded[p].north_mm, rounded[p + 1].north_mm, share);
          ++samples;
          if (clearance_mm(ground, x, y) >= kWalkClearance_mm - kMoved_mm) continue;
          ++narrow;
          if (is_narrow(ground, x, y)) continue;
          // A cap that would cut off much ground is smaller.
          ++smaller;
          EXPECT_GE(clearance_mm(ground, x, y), kLeastShare * kWalkClearance_mm) << x << "," << y;
        }
    }
  }
  EXPECT_GT(samples, 1000u);
  EXPECT_LT(narrow, samples / 5);
  EXPECT_LT(smaller, samples / 100);
}

/// Whoever is joined without caps is joined with them, and walks not much farther.
TEST(CornerCaps, CutNothingOff) {
  for (const auto seed : seeds(1, 8)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const City city = random_town_city(seed);
    const WalkMesh bare = make_walk_mesh(city.sectors, city.gates),
                   capped = make_clear_walk_mesh(city.sectors, city.gates, kWalkClearance_mm);
    const WalkPlaces bare_places(bare), capped_places(capped);
    const SightGraph bare_graph = make_sight_graph(bare), capped_graph = make_sight_graph(capped);
    ShortestWalk without(bare, bare_places, bare_graph), with(capped, capped_places, capped_graph);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 30; ++i) {
      const auto place = [&] {
        return capped_places.nearest(city.sectors[random() % city.sectors.size()].ground.outer[0], 5000);
      };
      const auto from = place(), to = place();
      ASSERT_TRUE(from && to);
      const auto a = without.find(from->at, to->at), b = with.find(from->at, to->at);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      EXPECT_GE(b->length_mm, a->length_mm - 10);
      EXPECT_LE(b->length_mm, 1.1 * a->length_mm + 5000);
      EXPECT_NEAR(length_of(*b), b->length_mm, 1e-6);
    }
  }
}

}  // namespace
}  // namespace vicus::test
