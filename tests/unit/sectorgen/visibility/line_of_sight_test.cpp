#include "sectorgen/visibility/line_of_sight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/grid_city.hpp"
#include "tests/support/sight_oracle.hpp"

/// The hard cases of research/VISIBILITY.md §5, each by itself.
namespace vicus::test {
namespace {

using Lists = std::vector<std::vector<std::uint32_t>>;

Lists lists_of(const City& city) { return lines_of_sight(make_sight_map(city), {}).visible; }

void expect_brute_force_agrees(const City& city) {
  const SightMap map = make_sight_map(city);
  const Lists lists = lines_of_sight(map, {}).visible;
  Pairs pairs;
  for (std::uint32_t a = 0; a < lists.size(); ++a)
    for (const std::uint32_t b : lists[a]) pairs.insert({a, b});
  EXPECT_EQ(pairs, sights_by_brute_force(map).sectors);
}

bool sees(const Lists& lists, std::uint32_t a, std::uint32_t b) {
  EXPECT_EQ(std::binary_search(lists[a].begin(), lists[a].end(), b),
            std::binary_search(lists[b].begin(), lists[b].end(), a));
  return std::binary_search(lists[a].begin(), lists[a].end(), b);
}

Ring box(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

void add_sector(City& city, Ring ring) {
  Sector sector;
  sector.id = "s" + std::to_string(city.sectors.size());
  sector.ground.outer = std::move(ring);
  city.sectors.push_back(std::move(sector));
}
void add_house(City& city, Ring ring, double base_m = 0, double height_m = 10) {
  Building house;
  house.id = "h" + std::to_string(city.buildings.size());
  house.footprint.outer = std::move(ring);
  house.base_m = base_m;
  house.height_m = house.eave_m = height_m;
  city.buildings.push_back(std::move(house));
}

/// Two yards of 10 m with a strip of 4 m between them, which the caller fills; houses above and below the strip.
City two_yards() {
  City city;
  add_sector(city, {{0, 0}, {10'000, 0}, {10'000, 4'000}, {10'000, 6'000}, {10'000, 10'000}, {0, 10'000}});
  add_sector(city, {{14'000, 0}, {24'000, 0}, {24'000, 10'000}, {14'000, 10'000}, {14'000, 6'000}, {14'000, 4'000}});
  add_house(city, box(-5'000, 10'000, 30'000, 20'000));
  add_house(city, box(-5'000, -10'000, 30'000, 0));
  // noded with the yards' corners
  city.buildings[0].footprint.outer = {{-5'000, 10'000}, {0, 10'000},      {10'000, 10'000}, {14'000, 10'000},
                                       {24'000, 10'000}, {30'000, 10'000}, {30'000, 20'000}, {-5'000, 20'000}};
  city.buildings[1].footprint.outer = {{-5'000, -10'000}, {30'000, -10'000}, {30'000, 0}, {24'000, 0},
                                       {14'000, 0},       {10'000, 0},       {0, 0},      {-5'000, 0}};
  return city;
}
const Ring kStrip = {{10'000, 0},      {14'000, 0},      {14'000, 4'000}, {14'000, 6'000},
                     {14'000, 10'000}, {10'000, 10'000}, {10'000, 6'000}, {10'000, 4'000}};

TEST(LineOfSight, PassesWhatLiesLowAndStopsAtWhatStands) {
  City water = two_yards();
  water.obstacles.push_back({ObstacleKind::water, "", 0, {kStrip, {}}});
  EXPECT_TRUE(sees(lists_of(water), 0, 1));
  City fence = two_yards();
  fence.obstacles.push_back({ObstacleKind::fence, "", 1.2, {kStrip, {}}});
  EXPECT_TRUE(sees(lists_of(fence), 0, 1));
  City wall = two_yards();
  wall.obstacles.push_back({ObstacleKind::wall, "", 3, {kStrip, {}}});
  EXPECT_FALSE(sees(lists_of(wall), 0, 1));
  City house = two_yards();
  add_house(house, kStrip);
  EXPECT_FALSE(sees(lists_of(house), 0, 1));
  City shed = two_yards();
  add_house(shed, kStrip, 0, 2.4);
  EXPECT_TRUE(sees(lists_of(shed), 0, 1));
  City arch = two_yards();
  add_house(arch, kStrip, 2.8);
  EXPECT_TRUE(sees(lists_of(arch), 0, 1)) << "one walks below";
}

TEST(LineOfSight, SeesAcrossTheEdgeOfTheCityUnlessAHouseStandsThere) {
  City open = two_yards();
  EXPECT_TRUE(sees(lists_of(open), 0, 1)) << "nothing is known between the yards";
}

TEST(LineOfSight, OfAShutYardIsTheYardItself) {
  City city = two_yards();
  add_house(city, kStrip);
  add_house(city, {{-5'000, 0}, {0, 0}, {0, 10'000}, {-5'000, 10'000}});
  EXPECT_EQ(lists_of(city)[0], (std::vector<std::uint32_t>{0}));
}

/// The left yard, water, then a house that belongs to the right yard behind it.
City quay() {
  City city = two_yards();
  for (auto& p : city.sectors[1].ground.outer) p.x += 20'000;
  for (auto& b : city.buildings) b.sector_id = "s0";
  city.buildings[0].footprint.outer = {{-5'000, 10'000}, {0, 10'000},      {10'000, 10'000},
                                       {14'000, 10'000}, {34'000, 10'000}, {44'000, 10'000},
                                       {50'000, 10'000}, {50'000, 20'000}, {-5'000, 20'000}};
  city.buildings[1].footprint.outer = {{-5'000, -10'000}, {50'000, -10'000}, {50'000, 0}, {44'000, 0}, {34'000, 0},
                                       {14'000, 0},       {10'000, 0},       {0, 0},      {-5'000, 0}};
  city.obstacles.push_back({ObstacleKind::water, "", 0, {kStrip, {}}});
  add_house(city, {{14'000, 0},
                   {34'000, 0},
                   {34'000, 4'000},
                   {34'000, 6'000},
                   {34'000, 10'000},
                   {14'000, 10'000},
                   {14'000, 6'000},
                   {14'000, 4'000}});
  city.buildings[2].sector_id = "s1";
  return city;
}

using Houses = std::vector<std::uint32_t>;

TEST(HousesInSight, ListABackAcrossWaterWhoseOwnerIsNot) {
  const SightLists lists = lines_of_sight(make_sight_map(quay()), {});
  EXPECT_EQ(lists.visible[0], Houses{0});
  EXPECT_EQ(lists.houses[0], Houses{2});
  EXPECT_EQ(lists.houses[1], (Houses{0, 1})) << "the walls beside it belong to the other yard";
}

TEST(HousesInSight, LeaveOutWhatComesWithASectorOrFromNobody) {
  City own = quay();
  own.buildings[2].sector_id = "s0";
  EXPECT_EQ(lines_of_sight(make_sight_map(own), {}).houses[0], Houses{});
  City nobodys = quay();
  nobodys.buildings[2].sector_id.clear();
  EXPECT_EQ(lines_of_sight(make_sight_map(nobodys), {}).houses[0], Houses{});
  City open = two_yards();
  for (auto& b : open.buildings) b.sector_id = "s1";
  EXPECT_EQ(lines_of_sight(make_sight_map(open), {}).houses[0], Houses{}) << "their owner is in sight";
}

TEST(HousesInSight, LeaveOutWhatStandsBehindAHouseOrAWall) {
  City house = quay();
  add_house(house, kStrip);
  EXPECT_EQ(lines_of_sight(make_sight_map(house), {}).houses[0], Houses{});
  City wall = quay();
  wall.obstacles[0] = {ObstacleKind::wall, "", 3, {kStrip, {}}};
  EXPECT_EQ(lines_of_sight(make_sight_map(wall), {}).houses[0], Houses{});
}

TEST(HousesInSight, ListShedsAndHousesInTheAirThatStopNoLook) {
  for (const auto& [base_m, height_m] : {std::pair(0.0, 2.0), {3.0, 8.0}}) {
    City city = quay();
    add_house(city, {{11'000, 3'000}, {13'000, 3'000}, {13'000, 5'000}, {11'000, 5'000}}, base_m, height_m);
    city.buildings[3].sector_id = "s1";
    EXPECT_EQ(lines_of_sight(make_sight_map(city), {}).houses[0], (Houses{2, 3}));
  }
}

TEST(HousesInSight, AreNeverLostByASectorOverBudget) {
  GridOptions grid;
  grid.side = 6;
  City city = grid_city(grid);
  for (std::size_t i = 0; i < city.buildings.size(); ++i)
    city.buildings[i].sector_id = city.sectors[(i * 31) % city.sectors.size()].id;
  const SightMap map = make_sight_map(city);
  const SightLists exact = lines_of_sight(map, {});
  SightOptions tight;
  tight.step_budget = 20;
  const SightLists bounded = lines_of_sight(map, tight);
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < exact.houses.size(); ++s)
    for (const std::uint32_t house : exact.houses[s]) {
      const auto& visible = bounded.visible[s];
      EXPECT_TRUE(std::binary_search(bounded.houses[s].begin(), bounded.houses[s].end(), house) ||
                  std::binary_search(visible.begin(), visible.end(), map.owner[house]));
      ++count;
    }
  EXPECT_GT(count, 100u);
}

/// Four corridors in line, 1 km each, houses around; between them slots of 1 m depth. The first and the last slot are
/// 2 mm wide around y = 0; the one between begins `slack` below the highest line through these two.
City needle(std::int32_t slack_mm) {
  City city;
  const std::int32_t far = 1'000'000, low = 1 - slack_mm;
  for (int i = 0; i < 4; ++i) add_sector(city, {});
  const auto corridor = [&](std::int32_t x0, std::int32_t x1, std::int32_t l0, std::int32_t h0, std::int32_t l1,
                            std::int32_t h1) {
    return Ring{{x0, -5'000}, {x1, -5'000}, {x1, l1}, {x1, h1}, {x1, 5'000}, {x0, 5'000}, {x0, h0}, {x0, l0}};
  };
  const auto slot = [](std::int32_t x, std::int32_t l, std::int32_t h) {
    return Ring{{x, l}, {x + 1'000, l}, {x + 1'000, h}, {x, h}};
  };
  const std::int32_t x[] = {0, far, 2 * far}, l[] = {-1, low, -1}, h[] = {1, low + 3'000, 1};
  city.sectors[0].ground.outer = {{-10'000, -5'000}, {0, -5'000}, {0, l[0]}, {0, h[0]}, {0, 5'000}, {-10'000, 5'000}};
  city.sectors[1].ground.outer = corridor(1'000, far, l[0], h[0], l[1], h[1]);
  city.sectors[2].ground.outer = corridor(far + 1'000, 2 * far, l[1], h[1], l[2], h[2]);
  city.sectors[3].ground.outer = {{2 * far + 1'000, -5'000}, {2 * far + 10'000, -5'000}, {2 * far + 10'000, 5'000},
                                  {2 * far + 1'000, 5'000},  {2 * far + 1'000, h[2]},    {2 * far + 1'000, l[2]}};
  for (int i = 0; i < 3; ++i) {
    add_sector(city, slot(x[i], l[i], h[i]));
    add_house(city, {{x[i], -5'000}, {x[i] + 1'000, -5'000}, {x[i] + 1'000, l[i]}, {x[i], l[i]}});
    add_house(city, {{x[i], h[i]}, {x[i] + 1'000, h[i]}, {x[i] + 1'000, 5'000}, {x[i], 5'000}});
  }
  const Ring south = {{-10'000, -9'000},
                      {2 * far + 10'000, -9'000},
                      {2 * far + 10'000, -5'000},
                      {2 * far + 1'000, -5'000},
                      {2 * far, -5'000},
                      {far + 1'000, -5'000},
                      {far, -5'000},
                      {1'000, -5'000},
                      {0, -5'000},
                      {-10'000, -5'000}};
  Ring north;
  for (auto p = south.rbegin(); p != south.rend(); ++p) north.push_back({p->x, -p->y});
  add_house(city, south);
  add_house(city, north);
  return city;
}

TEST(LineOfSight, KeepsAMillimetreApartOverTwoKilometres) {
  EXPECT_TRUE(sees(lists_of(needle(1)), 0, 3));
  EXPECT_TRUE(sees(lists_of(needle(0)), 0, 3)) << "touching counts: closed semantics";
  EXPECT_FALSE(sees(lists_of(needle(-1)), 0, 3));
}

TEST(LineOfSight, IsExactWhereAllFrontsAreInLine) {
  GridOptions options;
  options.side = 4;
  options.jitter_mm = 0;
  const City city = grid_city(options);
  expect_brute_force_agrees(city);
  const Lists lists = lists_of(city);
  EXPECT_TRUE(sees(lists, 0, 3)) << "along the whole street";
  EXPECT_FALSE(sees(lists, 0, 5)) << "across the block";
}

TEST(LineOfSight, IsExactWithConcaveSectors) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    GridOptions options;
    options.side = 3;
    options.niches = 2;
    options.seed = seed;
    expect_brute_force_agrees(grid_city(options));
  }
}

/// Four squares round one point, two of them houses: the other two touch in that point only.
TEST(LineOfSight, DoesNotPassAPoint) {
  City city;
  add_sector(city, box(0, 0, 10'000, 10'000));
  add_sector(city, box(10'000, 10'000, 20'000, 20'000));
  add_house(city, box(10'000, 0, 20'000, 10'000));
  add_house(city, box(0, 10'000, 10'000, 20'000));
  // and houses all around, so that there is no way outside
  add_house(city, {{-5'000, -5'000},
                   {25'000, -5'000},
                   {25'000, 25'000},
                   {20'000, 20'000},
                   {20'000, 10'000},
                   {20'000, 0},
                   {10'000, 0},
                   {0, 0}});
  add_house(city, {{-5'000, -5'000},
                   {0, 0},
                   {0, 10'000},
                   {0, 20'000},
                   {10'000, 20'000},
                   {20'000, 20'000},
                   {25'000, 25'000},
                   {-5'000, 25'000}});
  EXPECT_FALSE(sees(lists_of(city), 0, 1));
  expect_brute_force_agrees(city);
}

/// Gates that share a point: a look may turn about it.
TEST(LineOfSight, IsExactAtGatesThatTouchInAPoint) {
  City city;
  const PlanPoint hub{0, 0};
  const PlanPoint rim[] = {{10'000, 0},  {7'000, 7'000},   {0, 10'000}, {-7'000, 7'000},
                           {-10'000, 0}, {-7'000, -7'000}, {0, -10'000}};
  for (std::size_t i = 0; i + 1 < std::size(rim); ++i) add_sector(city, {hub, rim[i], rim[i + 1]});
  add_house(city, {hub, {0, -10'000}, {10'000, -10'000}, {10'000, 0}});
  expect_brute_force_agrees(city);
  const Lists lists = lists_of(city);
  EXPECT_TRUE(sees(lists, 0, 3));
}

TEST(LineOfSight, IsTheSameAtTheMagnitudeOfUtmAndTurnedByANanoradian) {
  for (const std::int32_t jitter : {0, 19'200}) {
    GridOptions options;
    options.side = 8;
    options.jitter_mm = jitter;
    options.niches = 1;
    const City city = grid_city(options);
    // As a file in UTM, turned, would come back: in doubles out there, rounded to the lattice here.
    const double easting = 455'000'000, northing = 5'540'000'000, turn = 1e-9;
    const auto there = [&](PlanPoint p) {
      const double x = p.x + easting, y = p.y + northing;
      return std::pair(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y);
    };
    const auto [x0, y0] = there({0, 0});
    const auto move = [&](Ring& ring) {
      for (auto& p : ring) {
        const auto [x, y] = there(p);
        p = {static_cast<std::int32_t>(std::lround(x - x0)), static_cast<std::int32_t>(std::lround(y - y0))};
      }
    };
    City moved = city;
    for (auto& s : moved.sectors) move(s.ground.outer);
    for (auto& b : moved.buildings) move(b.footprint.outer);
    EXPECT_EQ(lists_of(moved), lists_of(city));
    // And as far from the origin as the lattice reaches.
    City far = city;
    const auto push = [](Ring& ring) {
      for (auto& p : ring) p = {p.x + 1'000'000'000, p.y - 1'070'000'000};
    };
    for (auto& s : far.sectors) push(s.ground.outer);
    for (auto& b : far.buildings) push(b.footprint.outer);
    EXPECT_EQ(lists_of(far), lists_of(city));
  }
}

TEST(LineOfSight, FallsBackToASupersetAndSaysSo) {
  GridOptions options;
  options.side = 6;
  const SightMap map = make_sight_map(grid_city(options));
  const SightLists exact = lines_of_sight(map, {});
  EXPECT_TRUE(exact.over_budget.empty());
  SightOptions tight;
  tight.step_budget = 20;
  const SightLists bounded = lines_of_sight(map, tight);
  ASSERT_GT(bounded.over_budget.size(), 1u);
  bool is_looser = false;
  for (std::uint32_t s = 0; s < exact.visible.size(); ++s) {
    const auto& list = bounded.visible[s];
    EXPECT_TRUE(std::includes(list.begin(), list.end(), exact.visible[s].begin(), exact.visible[s].end()));
    EXPECT_TRUE(std::binary_search(list.begin(), list.end(), s));
    is_looser |= list.size() > exact.visible[s].size();
    for (const std::uint32_t t : list)
      EXPECT_TRUE(std::binary_search(bounded.visible[t].begin(), bounded.visible[t].end(), s)) << s << ' ' << t;
  }
  EXPECT_TRUE(is_looser);
}

/// A search over budget loses nothing where every other one ends.
TEST(LineOfSight, OneSectorOverBudgetIsToldByTheOthers) {
  GridOptions options;
  options.side = 6;
  options.niches = 2;
  const SightMap map = make_sight_map(grid_city(options));
  const SightLists exact = lines_of_sight(map, {});
  bool has_met_one = false;
  for (std::uint64_t budget = 20; budget < 1'000'000; budget += budget / 8) {
    SightOptions tight;
    tight.step_budget = budget;
    const SightLists bounded = lines_of_sight(map, tight);
    if (bounded.over_budget.size() != 1) continue;
    has_met_one = true;
    EXPECT_EQ(bounded.visible, exact.visible) << budget;
  }
  EXPECT_TRUE(has_met_one);
}

TEST(LineOfSight, IsTheSameForAnyNumberOfThreads) {
  GridOptions options;
  options.side = 7;
  options.niches = 2;
  const SightMap map = make_sight_map(grid_city(options));
  SightOptions one, four;
  one.threads = 1;
  four.threads = 4;
  EXPECT_EQ(lines_of_sight(map, one).visible, lines_of_sight(map, four).visible);
}

TEST(SightMap, CoversEachSectorWithItsOwnCells) {
  GridOptions options;
  options.side = 5;
  options.niches = 2;
  const City city = grid_city(options);
  const SightMap map = make_sight_map(city);
  ASSERT_EQ(map.sector_count(), city.sectors.size());
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) {
    std::int64_t area2 = 0, cells2 = 0;
    const Ring& ring = city.sectors[s].ground.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      area2 += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
    }
    for (std::uint32_t c = map.begin[s]; c < map.begin[s + 1]; ++c) {
      EXPECT_EQ(map.cells[c].sector, s);
      const auto& [p, q, r] = map.cells[c].corner;
      cells2 +=
          (std::int64_t{q.x} - p.x) * (std::int64_t{r.y} - p.y) - (std::int64_t{q.y} - p.y) * (std::int64_t{r.x} - p.x);
    }
    EXPECT_EQ(cells2, area2);
  }
}

TEST(SightMap, OfAnEmptyCityIsEmpty) {
  EXPECT_EQ(make_sight_map({}).sector_count(), 0u);
  EXPECT_TRUE(lines_of_sight(make_sight_map({}), {}).visible.empty());
}

}  // namespace
}  // namespace vicus::test
