#include "sectorgen/sectors/tours/shortest_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/sectors/tours/corner_caps.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/random_partition.hpp"
#include "tests/support/walk_oracle.hpp"

namespace vicus::test {
namespace {

constexpr double kLittle_mm = 1e-6;

double length_of(const Walk& walk) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < walk.points.size(); ++i)
    sum += std::hypot(double(walk.points[i + 1].x) - walk.points[i].x, double(walk.points[i + 1].y) - walk.points[i].y);
  return sum;
}

/// Ground as dealt out, walls where it ends or a gate is missing.
WalkGround ground_of(const RandomCity& rc, const std::vector<Gate>& gates) {
  WalkGround ground = walk_ground(rc.city.sectors, gates);
  ground.triangles.clear();
  for (std::uint32_t r = 0; r < rc.regions.size(); ++r)
    if (rc.regions[r].use == RandomCity::Use::sector)
      for (const std::uint32_t t : rc.triangles[r]) {
        const auto& corners = rc.field.triangles[t];
        ground.triangles.push_back(
            {rc.field.points[corners[0]], rc.field.points[corners[1]], rc.field.points[corners[2]]});
      }
  return ground;
}

/// Some on the lattice anywhere, some on walls' ends.
PlanPoint random_place(std::mt19937_64& random, const RandomCity& rc, std::uint32_t side) {
  if (random() % 4 == 0) return rc.field.points[random() % rc.field.points.size()];
  const auto span = static_cast<std::uint64_t>(side) * 1000;
  return {static_cast<std::int32_t>(random() % span), static_cast<std::int32_t>(random() % span)};
}

void expect_as_short_as_brute_force(const WalkMesh& walk, const WalkGround& ground, PlanPoint from, PlanPoint to) {
  const WalkPlaces places(walk);
  if (places.standing_at(from).empty() || places.standing_at(to).empty()) return;
  const SightGraph graph = make_sight_graph(walk);
  const auto found = ShortestWalk(walk, places, graph).find(from, to);
  const auto expected = shortest_by_brute_force(ground, from, to);
  ASSERT_EQ(found.has_value(), expected.has_value())
      << from.x << "," << from.y << " to " << to.x << "," << to.y << (expected ? " " + std::to_string(*expected) : "");
  if (!found) return;
  EXPECT_NEAR(found->length_mm, *expected, kLittle_mm)
      << from.x << "," << from.y << " to " << to.x << "," << to.y << ", bends " << found->points.size() - 2;
  EXPECT_NEAR(length_of(*found), found->length_mm, kLittle_mm);
  EXPECT_EQ(found->points.front(), from);
  EXPECT_EQ(found->points.back(), to);
}

TEST(ShortestWalk, IsAsShortAsBruteForceInRandomCities) {
  auto all = seeds(1, 150);
  all.push_back(13854);  // round the end of a wall without breadth, and back along its other side
  for (const auto seed : all) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto side = static_cast<std::uint32_t>(6 + seed % 5);
    const auto rc = random_city(seed, side, 6 + static_cast<std::uint32_t>(seed % 17));
    std::mt19937_64 random(seed);
    std::vector<Gate> gates = rc.city.gates;
    if (seed % 2 == 0)  // walls without breadth
      std::erase_if(gates, [&](const Gate& g) { return std::hash<std::string>{}(std::min(g.id, g.twin_id)) % 3 == 0; });
    const auto ground = ground_of(rc, gates);
    const WalkMesh walk = make_walk_mesh(rc.city.sectors, gates);
    for (int i = 0; i < 4; ++i)
      expect_as_short_as_brute_force(walk, ground, random_place(random, rc, side), random_place(random, rc, side));
    if (testing::Test::HasFailure()) return;
  }
}

/// Sectors of random towns: a few next to each other, with the gates between them.
TEST(ShortestWalk, IsAsShortAsBruteForceInPartsOfRandomTowns) {
  for (const auto seed : seeds(1, 12)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const City city = random_town_city(seed);
    std::mt19937_64 random(seed);
    std::vector<Sector> sectors;
    std::vector<std::string> ids{city.sectors[random() % city.sectors.size()].id};
    for (std::size_t i = 0; i < ids.size() && ids.size() < 7; ++i)
      for (const auto& gate : city.gates)
        if (gate.sector_id == ids[i] && !gate.to_sector_id.empty() && ids.size() < 7 &&
            std::find(ids.begin(), ids.end(), gate.to_sector_id) == ids.end())
          ids.push_back(gate.to_sector_id);
    const auto is_in = [&](const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
    PlanPoint corner{kPlanLimit, kPlanLimit};
    for (const auto& s : city.sectors)
      if (is_in(s.id)) {
        sectors.push_back(s);
        for (const PlanPoint p : s.ground.outer) corner = {std::min(corner.x, p.x), std::min(corner.y, p.y)};
      }
    std::vector<Gate> gates;
    for (const auto& g : city.gates)
      if (is_in(g.sector_id) && is_in(g.to_sector_id)) gates.push_back(g);
    for (auto& s : sectors) {  // near the origin, for the oracle
      for (auto& p : s.ground.outer) p = {p.x - corner.x, p.y - corner.y};
      for (auto& hole : s.ground.holes)
        for (auto& p : hole) p = {p.x - corner.x, p.y - corner.y};
    }
    for (auto& g : gates)
      for (auto& p : g.line) p = {p.x - corner.x, p.y - corner.y};
    const auto ground = walk_ground(sectors, gates);
    const WalkMesh walk = make_walk_mesh(sectors, gates);
    for (int i = 0; i < 3; ++i) {
      const auto middle = [&] {
        const auto& t = ground.triangles[random() % ground.triangles.size()];
        return PlanPoint{(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3};
      };
      expect_as_short_as_brute_force(walk, ground, middle(), middle());
    }
    if (testing::Test::HasFailure()) return;
  }
}

/// Also where walks keep off corners: the ground is then the mesh's own triangles.
TEST(ShortestWalk, IsAsShortAsBruteForceBetweenCaps) {
  for (const auto seed : seeds(1, 60)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto side = static_cast<std::uint32_t>(6 + seed % 3);
    const auto rc = random_city(seed, side, 5 + static_cast<std::uint32_t>(seed % 9));
    const WalkMesh walk = make_clear_walk_mesh(rc.city.sectors, rc.city.gates, 150);
    WalkGround ground;
    for (std::uint32_t t = 0; t < walk.sector.size(); ++t) {
      if (walk.sector[t] == kNone) continue;
      ground.triangles.push_back({walk.at(t, 0), walk.at(t, 1), walk.at(t, 2)});
      for (int k = 0; k < 3; ++k)
        if (!walk.is_open(t, k)) ground.walls.push_back({walk.at(t, k + 1), walk.at(t, k + 2)});
    }
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3; ++i)
      expect_as_short_as_brute_force(walk, ground, random_place(random, rc, side), random_place(random, rc, side));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ShortestWalk, NamesSectorsThatGatesJoinInOrder) {
  std::size_t entered = 0;
  for (const auto seed : seeds(1, 10)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const City city = random_town_city(seed);
    const WalkMesh walk = make_clear_walk_mesh(city.sectors, city.gates, kWalkClearance_mm);
    const WalkPlaces places(walk);
    const SightGraph graph = make_sight_graph(walk);
    ShortestWalk shortest(walk, places, graph);
    std::map<std::pair<std::string, std::string>, bool> joined;
    for (const auto& g : city.gates) joined[{g.sector_id, g.to_sector_id}] = true;
    std::mt19937_64 random(seed);
    for (int i = 0; i < 40; ++i) {
      const auto place = [&] {
        return places.nearest(city.sectors[random() % city.sectors.size()].ground.outer.front(), 5000);
      };
      const auto from = place(), to = place();
      ASSERT_TRUE(from && to);
      const auto found = shortest.find(from->at, to->at);
      if (!found) continue;
      entered += found->sectors.size();
      ASSERT_FALSE(found->sectors.empty());
      for (std::size_t s = 0; s + 1 < found->sectors.size(); ++s) {
        EXPECT_TRUE(
            (joined[{city.sectors[found->sectors[s].sector].id, city.sectors[found->sectors[s + 1].sector].id}]));
        EXPECT_LE(found->sectors[s].at_mm, found->sectors[s + 1].at_mm + 1e-6);
      }
      EXPECT_LE(found->sectors.back().at_mm, found->length_mm + 1e-6);
      // Where it says that a sector is entered, that sector's ground is.
      for (const auto& e : found->sectors) {
        double left = e.at_mm;
        std::size_t leg = 0;
        const auto leg_mm = [&] {
          return std::hypot(double(found->points[leg + 1].x) - found->points[leg].x,
                            double(found->points[leg + 1].y) - found->points[leg].y);
        };
        while (leg + 2 < found->points.size() && left > leg_mm()) left -= leg_mm(), ++leg;
        const double share = leg_mm() > 0 ? left / leg_mm() : 0;
        const PlanPoint at{static_cast<std::int32_t>(std::lround(
                               found->points[leg].x + share * (found->points[leg + 1].x - found->points[leg].x))),
                           static_cast<std::int32_t>(std::lround(
                               found->points[leg].y + share * (found->points[leg + 1].y - found->points[leg].y)))};
        bool is_near = false;
        for (int dx = -2; dx <= 2; ++dx)
          for (int dy = -2; dy <= 2; ++dy)
            is_near |= locate(city.sectors[e.sector].ground, {at.x + dx, at.y + dy}) != Side::outside;
        EXPECT_TRUE(is_near) << city.sectors[e.sector].id << " at " << e.at_mm << " of " << found->length_mm;
      }
    }
  }
  EXPECT_GT(entered, 500u);
}

}  // namespace
}  // namespace vicus::test
