#include "sectorgen/visibility/over_roofs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sectorgen/visibility/horizon.hpp"
#include "sectorgen/visibility/line_of_sight.hpp"
#include "tests/support/grid_city.hpp"

/// Houses over roofs: small streets whose answer is known, and every bound against sampling.
namespace vicus::test {
namespace {

Ring box(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Building house(const std::string& id, Ring ring, double height_m, double base_m = 0) {
  Building b;
  b.id = id;
  b.footprint.outer = std::move(ring);
  b.base_m = base_m;
  b.height_m = b.eave_m = height_m;
  return b;
}

/// A street of 10 m, a row of 12 m depth north of it, a yard of 20 m behind, and a second row of 12 m at its far side.
/// The yard owns the second row. From the street's south side the first row's top is 10 m off, the second's 42 m.
City two_rows(double first_m, double second_m, double first_base_m = 0) {
  City city;
  for (const auto& [id, ring] : {std::pair<std::string, Ring>{"street", box(0, 0, 100'000, 10'000)},
                                 {"yard", box(0, 22'000, 100'000, 42'000)}}) {
    Sector sector;
    sector.id = id;
    sector.ground.outer = ring;
    city.sectors.push_back(std::move(sector));
  }
  city.buildings.push_back(house("first", box(-300'000, 10'000, 400'000, 22'000), first_m, first_base_m));
  city.buildings.push_back(house("second", box(0, 42'000, 100'000, 54'000), second_m));
  for (auto& b : city.buildings) b.sector_id = "yard";
  return city;
}

SightLists level_lists(std::vector<std::vector<std::uint32_t>> visible) {
  SightLists lists;
  lists.houses.resize(visible.size());
  lists.visible = std::move(visible);
  return lists;
}

std::vector<RoofSight> seen_from_street(const City& city, const RoofOptions& options = {}) {
  return sights_over_roofs(city, level_lists({{0}, {1}}), options).visible[0];
}
bool lists(const std::vector<RoofSight>& sights, std::uint32_t house) {
  return std::any_of(sights.begin(), sights.end(), [&](const RoofSight& s) { return s.house == house; });
}

// Eyes at 2 m on the south side, 10 m before the first row and 42 m before the second: a line that rises just over the
// first row's near edge is 2 + (first - 2) * 42 / 10 high at the second.
TEST(SightsOverRoofs, ListAHouseThatRisesAboveTheLineAndNoOther) {
  const double first_m = 10, line_m = 2 + (first_m - 2) * 42 / 10;
  EXPECT_TRUE(lists(seen_from_street(two_rows(first_m, line_m + 1)), 1));
  EXPECT_FALSE(lists(seen_from_street(two_rows(first_m, line_m - 6)), 1));
  RoofOptions patient;
  patient.most_pairs = 1'000'000;
  EXPECT_FALSE(lists(seen_from_street(two_rows(first_m, line_m - 1), patient), 1));
  const auto seen = seen_from_street(two_rows(first_m, line_m + 1));
  const auto tower = std::find_if(seen.begin(), seen.end(), [](const RoofSight& s) { return s.house == 1; });
  EXPECT_EQ(tower->sector, 1u);
  EXPECT_TRUE(tower->is_proven);
}

/// Ground that rises northwards: 0 up to y = 0, then by that much each 5 m.
Terrain slope(double rise_per_5_m) {
  Terrain terrain{{-310'000, -100'000}, 5'000, 150, 60, {}};
  for (std::uint32_t row = 0; row < terrain.rows; ++row)
    for (std::uint32_t column = 0; column < terrain.columns; ++column)
      terrain.height_mm.push_back(static_cast<std::int32_t>(std::max(0.0, row - 20.0) * rise_per_5_m * 1000));
  return terrain;
}

std::vector<RoofSight> seen_on(const Terrain& terrain, City city, std::uint32_t from) {
  city.terrain = terrain;
  for (auto& sector : city.sectors) sector.ground_triangles = {0, 1, 2, 0, 2, 3};
  return sights_over_roofs(city, level_lists({{0}, {1}}), {}).visible[from];
}

TEST(SightsOverRoofs, ListAHouseThatStandsHigherUpASlope) {
  const City city = two_rows(10, 10);
  EXPECT_FALSE(lists(seen_on({}, city, 0), 1));
  EXPECT_FALSE(lists(seen_on(slope(0.2), city, 0), 1)) << "too gentle: the second row ends 1.6 m above the first";
  EXPECT_TRUE(lists(seen_on(slope(6), city, 0), 1)) << "the second row stands above the first one's roof";
}

TEST(SightsOverRoofs, ListARoofBelowThatIsLookedDownAt) {
  // From the yard over the first row to a third one south of the street: hidden on the flat, far below on a slope.
  City city = two_rows(10, 10);
  city.buildings.push_back(house("third", box(0, -15'000, 100'000, 0), 6));
  city.buildings[2].sector_id = "street";
  EXPECT_FALSE(lists(seen_on({}, city, 1), 2));
  EXPECT_TRUE(lists(seen_on(slope(5), city, 1), 2)) << "eyes 38 m up, the first row ends at 20 to 35 m";
}

/// The street's ground, from the yard over the first row.
const RoofSight* ground_seen(const std::vector<RoofSight>& sights) {
  const auto at = std::find_if(sights.begin(), sights.end(),
                               [](const RoofSight& s) { return s.sector == 0 && s.house == RoofSight::kGround; });
  return at == sights.end() ? nullptr : &*at;
}

TEST(SightsOverRoofs, ListGroundBelowThatIsLookedDownAt) {
  const City city = two_rows(10, 10);
  EXPECT_FALSE(ground_seen(seen_on({}, city, 1)));
  EXPECT_FALSE(ground_seen(seen_on(slope(0.5), city, 1)));
  EXPECT_TRUE(ground_seen(seen_on(slope(5), city, 1))) << "eyes 44 m up, the first row surely ends at 20 m";
}

TEST(SightsOverRoofs, HideGroundBehindAHill) {
  // No house between: a wall of earth, 40 m high, where the first row stood.
  City city = two_rows(1, 1);
  Terrain hill{{-310'000, -100'000}, 2'000, 400, 150, {}};
  for (std::uint32_t row = 0; row < hill.rows; ++row)
    for (std::uint32_t column = 0; column < hill.columns; ++column)
      hill.height_mm.push_back(std::max(0, 40'000 - 10'000 * std::abs(static_cast<int>(row) - 58)));
  EXPECT_FALSE(ground_seen(seen_on(hill, city, 1)));
  for (auto& height : hill.height_mm) height /= 40;
  EXPECT_TRUE(ground_seen(seen_on(hill, city, 1))) << "a bank of 1 m hides nothing";
}

TEST(SightsOverRoofs, StillHideOnASlope) {
  // Down a gentle slope the nearer row hides the farther one, as on flat ground.
  City city = two_rows(14, 10);
  city.buildings.push_back(house("third", box(0, -15'000, 100'000, 0), 6));
  city.buildings[2].sector_id = "street";
  EXPECT_FALSE(lists(seen_on(slope(0.5), city, 1), 2));
}

TEST(SightsOverRoofs, SayWhatWasNotTold) {
  // 1 mm above the line: the finest pieces do not tell it from hidden, no ray to a piece's middle finds it.
  const double line_m = 2 + (10 - 2) * 42.0 / 10;
  const auto seen = seen_from_street(two_rows(10, line_m + 0.001));
  ASSERT_TRUE(lists(seen, 1)) << "what is not proven hidden stays";
  EXPECT_FALSE(std::find_if(seen.begin(), seen.end(), [](const RoofSight& s) { return s.house == 1; })->is_proven);
}

TEST(SightsOverRoofs, LeaveOutSectorsInSightOnTheLevel) {
  const City city = two_rows(10, 80);
  EXPECT_TRUE(sights_over_roofs(city, level_lists({{0, 1}, {0, 1}}), {}).visible[0].empty());
}

TEST(SightsOverRoofs, LookBelowAHouseThatHangsInTheAir) {
  EXPECT_TRUE(lists(seen_from_street(two_rows(10, 12, 3)), 1))
      << "a house on columns is no proof that anything is hidden";
}

TEST(SightsOverRoofs, HideOnlyUpToTheEave) {
  City city = two_rows(10, 30);
  EXPECT_FALSE(lists(seen_from_street(city), 1));
  city.buildings[0].height_m = 14;
  city.buildings[0].eave_m = 4;
  EXPECT_TRUE(lists(seen_from_street(city), 1)) << "a steep roof may leave the view free";
}

TEST(SightsOverRoofs, LookUpToTheRidge) {
  // Its walls end below the line over the first row, its ridge does not.
  const double line_m = 2 + (10 - 2) * 42.0 / 10;
  City city = two_rows(10, line_m - 6);
  EXPECT_FALSE(lists(seen_from_street(city), 1));
  city.buildings[1].height_m = line_m + 3;
  EXPECT_TRUE(lists(seen_from_street(city), 1));
}

TEST(SightsOverRoofs, AreTheSameForAnyNumberOfThreadsAndSmallerWithFinerPieces) {
  GridOptions grid;
  grid.side = 6;
  grid.niches = 1;
  City city = grid_city(grid);
  for (std::size_t i = 0; i < city.buildings.size(); ++i) {
    city.buildings[i].height_m = city.buildings[i].eave_m = i % 7 == 0 ? 60 : 8 + static_cast<double>(i % 5);
    city.buildings[i].sector_id = city.sectors[i].id;
  }
  const SightLists level = lines_of_sight(make_sight_map(city), {});
  const auto pairs_of = [&](unsigned threads, double least_m) {
    RoofOptions options;
    options.threads = threads;
    options.least_radius_m = least_m;
    std::vector<std::array<std::uint32_t, 4>> pairs;
    const RoofLists lists = sights_over_roofs(city, level, options);
    for (std::uint32_t s = 0; s < lists.visible.size(); ++s)
      for (const auto& sight : lists.visible[s]) pairs.push_back({s, sight.sector, sight.house, sight.is_proven});
    return pairs;
  };
  const auto fine = pairs_of(1, 0.125);
  EXPECT_FALSE(fine.empty());
  EXPECT_EQ(fine, pairs_of(4, 0.125));
  EXPECT_LE(fine.size(), pairs_of(1, 2).size());
}

/// Houses of random height in rows that share walls.
class RandomBlock {
 public:
  explicit RandomBlock(std::uint64_t seed) : random_(seed) {
    std::int32_t x = 0;
    for (int i = 0; i < 12; ++i) {
      const auto width = static_cast<std::int32_t>(5'000 + random_() % 9'000),
                 tilt = static_cast<std::int32_t>(random_() % 3'000);
      const std::int32_t left = i == 0 ? 0 : tilt_;
      city_.buildings.push_back(house("h" + std::to_string(i),
                                      {{x, 0}, {x + width, 0}, {x + width + tilt, 15'000}, {x + left, 15'000}},
                                      3 + static_cast<double>(random_() % 20)));
      tilt_ = tilt;
      x += width;
    }
    width_m_ = metres(x);
  }
  const City& city() const { return city_; }
  double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  Spot anywhere() { return {-10 + share() * (width_m_ + 20), -10 + share() * 35}; }
  /// The height above a point, by looking at every house.
  double height_at(Spot p) const {
    double height = 0;
    for (const auto& b : city_.buildings) {
      bool is_inside = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const Spot a = spot_of(b.footprint.outer[i]), c = spot_of(b.footprint.outer[(i + 1) % 4]);
        is_inside &= (c.x - a.x) * (p.y - a.y) - (c.y - a.y) * (p.x - a.x) >= 0;
      }
      if (is_inside) height = std::max(height, b.height_m);
    }
    return height;
  }

 private:
  std::mt19937_64 random_;
  City city_;
  std::int32_t tilt_ = 0;
  double width_m_ = 0;
};

TEST(RoofField, IsNeverHigherThanAnyPlaceOfTheDisc) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomBlock block(seed);
    const HouseWalls walls(block.city());
    const RoofField field(walls, 1'000'000);
    int sure = 0;
    for (int i = 0; i < 4000; ++i) {
      const Spot x = block.anywhere();
      const double radius = 5 * block.share() * block.share();
      const WornGrid* grid = field.grid_for(radius);
      ASSERT_NE(grid, nullptr);
      const double height = field.sure_height(*grid, x);
      sure += height > 0;
      for (int k = 0; k < 24 && height > 0; ++k) {
        const double r = radius * (k % 3 == 0 ? 1 : block.share());
        ASSERT_LE(height, block.height_at({x.x + r * std::cos(k), x.y + r * std::sin(k)}));
      }
    }
    EXPECT_GT(sure, 400) << "else nothing was tested";
  }
}

TEST(HouseWalls, CallADiscRoofedOnlyWhereEveryPlaceOfItIs) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomBlock block(seed);
    const HouseWalls walls(block.city());
    int roofed = 0;
    for (int i = 0; i < 4000; ++i) {
      const Spot x = block.anywhere();
      const double radius = 3 * block.share() * block.share(), up_m = 2 + 15 * block.share();
      for (std::uint32_t h = 0; h < block.city().buildings.size(); ++h) {
        if (!walls.is_roofed(x, radius, h, up_m)) continue;
        ++roofed;
        for (int k = 0; k < 24; ++k)
          ASSERT_GE(block.height_at({x.x + radius * std::cos(k), x.y + radius * std::sin(k)}), up_m);
      }
    }
    EXPECT_GT(roofed, 200) << "else nothing was tested";
  }
}

TEST(HouseWalls, CutALineWhereSamplingDoes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomBlock block(seed);
    const HouseWalls walls(block.city());
    std::vector<Crossing> crossings;
    for (int i = 0; i < 300; ++i) {
      Spot p = block.anywhere();
      const Spot q = block.anywhere();
      p.y = -1 - 9 * block.share();              // eyes are not in houses
      walls.cut(p, q, kNoRoof_m, 0, crossings);  // however high the houses are
      for (int k = 0; k < 50; ++k) {
        const double t = block.share();
        double height = 0;
        for (const Crossing& c : crossings)
          if (t >= c.from && t <= c.to) height = std::max(height, walls.houses()[c.house].sure_top_m);
        ASSERT_EQ(height, block.height_at({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}));
      }
    }
  }
}

TEST(Horizon, NeverHidesWhatSomeEyeOfTheDiscSees) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomBlock block(seed);
    const HouseWalls walls(block.city());
    const RoofField field(walls, 1'000'000);
    Horizon horizon(field);
    int hidden = 0;
    for (int i = 0; i < 200; ++i) {
      const double radius = 0.2 + 2 * block.share();
      const Spot centre{block.share() * 90, -0.1 - radius - 12 * block.share()};  // eyes are not in houses
      horizon.start(centre, radius, kEyeTop_m, i % 2 ? 512 : 1024);
      for (int k = 0; k < 40; ++k) {
        const Spot a{block.share() * 90, 17 + 40 * block.share()}, b{a.x + 6 * block.share(), a.y + 2};
        const double top_m = 3 + 25 * block.share();
        const bool by_disc = horizon.hides_disc(a, 2, top_m), by_segment = horizon.hides_segment(a, b, top_m);
        hidden += by_segment;
        for (int eye = 0; eye < 12; ++eye) {
          const double r = radius * std::sqrt(block.share()), turn = 7 * block.share(), t = block.share();
          const Spot p{centre.x + r * std::cos(turn), centre.y + r * std::sin(turn)};
          const Spot on_segment{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
          const Spot in_disc{a.x + 2 * t * std::cos(eye), a.y + 2 * t * std::sin(eye)};
          ASSERT_FALSE(by_segment && walls.is_clear(p, kEyeTop_m, on_segment, top_m));
          ASSERT_FALSE(by_disc && walls.is_clear(p, kEyeTop_m, in_disc, top_m));
        }
      }
    }
    EXPECT_GT(hidden, 500) << "else nothing was tested";
  }
}

}  // namespace
}  // namespace vicus::test
