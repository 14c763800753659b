#include "sectorgen/visibility/look_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/visibility/rim_map.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/grid_city.hpp"
#include "tests/support/random_partition.hpp"

namespace vicus::test {
namespace {

std::int64_t area2(const Corners& t) { return orient(t[0], t[1], t[2]); }

/// Random partitions and towns, and a grid whose outer streets lie open.
std::vector<City> cities() {
  std::vector<City> cities;
  GridOptions grid;
  grid.side = 5;
  grid.niches = 2;
  cities.push_back(grid_city(grid));
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const auto side = static_cast<std::uint32_t>(4 + seed % 7);
    cities.push_back(random_city(seed, side, side * side / 2).city);
  }
  for (std::uint64_t seed = 1; seed <= 10; ++seed) cities.push_back(random_town_city(seed));
  return cities;
}

std::set<PlanPoint> wall_corners(const SightMap& sight) {
  std::set<PlanPoint> corners;
  for (const auto& cell : sight.cells)
    for (std::size_t k = 0; k < 3; ++k)
      if (cell.beyond[k] >= kWall) corners.insert({cell.corner[(k + 1) % 3], cell.corner[(k + 2) % 3]});
  return corners;
}

TEST(LookMap, CoversTheSameGroundWithCornersAtWallsOnly) {
  std::size_t fewer = 0;
  for (const City& city : cities()) {
    const SightMap sight = make_sight_map(city);
    const LookMap looks = make_look_map(sight);
    const std::set<PlanPoint> walls = wall_corners(sight);
    std::int64_t fine = 0, wide = 0;
    std::map<std::pair<PlanPoint, PlanPoint>, std::uint32_t> fine_walls, wide_walls;
    for (const auto& cell : sight.cells) {
      fine += area2(cell.corner);
      for (std::size_t k = 0; k < 3; ++k)
        if (cell.beyond[k] >= kWall) fine_walls[{cell.corner[(k + 1) % 3], cell.corner[(k + 2) % 3]}] = cell.beyond[k];
    }
    for (const auto& cell : looks.cells) {
      wide += area2(cell.corner);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(walls.contains(cell.corner[k]));
        if (cell.beyond[k] >= kWall) wide_walls[{cell.corner[(k + 1) % 3], cell.corner[(k + 2) % 3]}] = cell.beyond[k];
      }
    }
    EXPECT_EQ(fine, wide);
    EXPECT_EQ(fine_walls, wide_walls);
    fewer += looks.cells.size() < sight.cells.size();
  }
  EXPECT_GT(fewer, 20u);
}

TEST(LookMap, SaysOfEachCellWhichSectorsLieInIt) {
  for (const City& city : cities()) {
    const SightMap sight = make_sight_map(city);
    const LookMap looks = make_look_map(sight);
    for (const auto& look : looks.cells) {
      std::set<std::uint32_t> told, expected;
      if (look.sector != kNowhere) told.insert(look.sector);
      for (std::uint32_t p = look.first_piece; p < look.pieces_behind; ++p)
        if (looks.pieces[p].sector != kNowhere) told.insert(looks.pieces[p].sector);
      for (const auto& cell : sight.cells)
        if (cell.sector != kNowhere && overlap(cell.corner, look.corner)) expected.insert(cell.sector);
      EXPECT_EQ(told, expected);
    }
  }
}

void expect_linked(const RimMap& map, std::uint32_t first, std::set<std::uint32_t>& reached) {
  std::vector<std::uint32_t> queue{first};
  reached.insert(first);
  while (!queue.empty()) {
    const LookCell& cell = map.cell(queue.back());
    const std::uint32_t at = queue.back();
    queue.pop_back();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t side = cell.beyond[k];
      if (side >= kWall) continue;
      const LookCell& other = map.cell(side >> 2);
      ASSERT_EQ(other.beyond[side & 3], 4 * at + k);
      EXPECT_EQ(other.corner[((side & 3) + 1) % 3], cell.corner[(k + 2) % 3]);
      EXPECT_EQ(other.corner[((side & 3) + 2) % 3], cell.corner[(k + 1) % 3]);
      if (reached.insert(side >> 2).second) queue.push_back(side >> 2);
    }
  }
}

TEST(RimMap, HasTheSectorsGroundInCellsOfItsOwn) {
  std::size_t loose = 0;
  for (const City& city : cities()) {
    const SightMap sight = make_sight_map(city);
    const LookMap looks = make_look_map(sight);
    RimMap map(sight, looks);
    for (std::uint32_t s = 0; s < sight.sector_count(); ++s) {
      map.turn_to(s);
      std::int64_t own = 0, expected = 0;
      for (const std::uint32_t c : map.own_cells()) {
        EXPECT_EQ(map.cell(c).sector, s);
        own += area2(map.cell(c).corner);
      }
      for (std::uint32_t c = sight.begin[s]; c < sight.begin[s + 1]; ++c) expected += area2(sight.cells[c].corner);
      EXPECT_EQ(own, expected);
      std::set<std::uint32_t> reached;
      if (!map.own_cells().empty()) expect_linked(map, map.own_cells().front(), reached);
      for (const std::uint32_t c : reached) {
        if (map.cell(c).sector == s) continue;
        for (std::uint32_t p = map.cell(c).first_piece; p < map.cell(c).pieces_behind; ++p)
          EXPECT_NE(map.piece(p).sector, s);
      }
      loose += looks.is_loose[s] != 0;
    }
    // What was cut is as it was: another map that never turned has the same sides.
    map.turn_to(0);
    RimMap fresh(sight, looks);
    fresh.turn_to(0);
    ASSERT_EQ(map.size(), fresh.size());
    for (std::uint32_t c = 0; c < map.size(); ++c) EXPECT_EQ(map.cell(c).beyond, fresh.cell(c).beyond);
  }
  EXPECT_GT(loose, 50u);
}

}  // namespace
}  // namespace vicus::test
