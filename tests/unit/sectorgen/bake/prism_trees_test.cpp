#include "sectorgen/bake/prism_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "city_db/tile_tree.hpp"
#include "sectorgen/bake/bake_prisms.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "sectorgen/bake/ground_colours.hpp"

namespace vicus {
namespace {

constexpr std::uint32_t kLeaf_mm = 128'000;

/// Pavement of 500 m by 500 m around the origin, and trees on it.
City grove(int trees, unsigned seed) {
  City city;
  Surface pavement;
  for (const PlanPoint p : {PlanPoint{-250'000, -250'000}, PlanPoint{250'000, -250'000}, PlanPoint{250'000, 250'000},
                            PlanPoint{-250'000, 250'000}})
    pavement.points.push_back({p, 0});
  pavement.triangles = {0, 1, 2, 0, 2, 3};
  city.surfaces.push_back(pavement);
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int32_t> place(-250'000, 249'999), height(3, 20);
  for (int i = 0; i < trees; ++i) {
    StandaloneObject tree{
        "tree-" + std::to_string(i), "s", "tree", "", {place(random), place(random)}, 1.5, 0, 0, "", {}};
    tree.height_m = i % 3 == 0 ? 0 : height(random);
    if (i % 5 == 0) tree.tags["genus"] = "Picea";
    city.objects.push_back(tree);
  }
  // On the seams of tiles and quadrants.
  for (const std::int32_t x : {-128'000, -64'000, 0, 64'000, 127'999})
    city.objects.push_back({"seam-" + std::to_string(x), "s", "tree", "", {x, x}, 0, 6, 0, "", {}});
  return city;
}

BakeScene scene_of(const City& city) {
  return BakeScene(
      city, [](const std::string&) { return std::string(); }, 1);
}

TEST(PrismTrees, StandOnceInTheTileAndQuadrantTheyAreIn) {
  const City city = grove(300, 1);
  const BakeScene scene = scene_of(city);
  const int levels = levels_of(city);
  std::size_t found = 0;
  for (std::uint32_t y = 0; y < 1u << (levels - 1); ++y)
    for (std::uint32_t x = 0; x < 1u << (levels - 1); ++x) {
      const PlanPoint corner = tile_corner(levels, {levels - 1, x, y});
      const PrismTile tile = bake_prisms(scene, corner, kLeaf_mm);
      EXPECT_EQ(decode_prisms(encode_prisms(tile)), tile);
      found += tile.trees.size();
      for (const PrismTree& tree : tile.trees) {
        EXPECT_GE(tree.at.x, 0);
        EXPECT_LT(tree.at.x * std::int64_t{tile.step_mm}, kLeaf_mm);
        const std::int64_t half = kLeaf_mm / 2 / tile.step_mm;
        EXPECT_EQ(tree.quadrant, (tree.at.x >= half ? 1 : 0) + (tree.at.y >= half ? 2 : 0));
        // The tree of the city that stands there, as high and wide as on foot.
        const auto is_it = [&](const BakeTree& t) {
          return std::abs(corner.x + (tree.at.x + 0.5) * tile.step_mm - t.at.x) <= tile.step_mm / 2.0 &&
                 std::abs(corner.y + (tree.at.y + 0.5) * tile.step_mm - t.at.y) <= tile.step_mm / 2.0 &&
                 std::abs(tree.height * 0.1 - t.shape.height_m) <= 0.051 &&
                 std::abs(tree.crown * 0.1 - t.shape.crown_m) <= 0.051 && tree.form == t.shape.form &&
                 std::abs(metres(tile.base_mm) + tree.ground * 0.1 - t.ground_m) <= 0.051 &&
                 tile.palette.at(tree.leaves) == t.shape.leaves;
        };
        EXPECT_TRUE(std::any_of(scene.trees().begin(), scene.trees().end(), is_it)) << tree.at.x << ' ' << tree.at.y;
      }
    }
  EXPECT_EQ(found, scene.trees().size());
}

TEST(PrismTrees, OfAParentsQuadrantAreThoseOfTheChild) {
  const City city = grove(40, 2);
  const BakeScene scene = scene_of(city);
  const int levels = levels_of(city);
  ASSERT_GE(levels, 2);
  for (int z = 0; z + 1 < levels; ++z)
    for (std::uint32_t y = 0; y < 1u << z; ++y)
      for (std::uint32_t x = 0; x < 1u << z; ++x) {
        const PlanPoint corner = tile_corner(levels, {z, x, y});
        ASSERT_TRUE(has_standing_trees(scene, corner, tile_side_mm(levels, z)));
        std::size_t mine[4] = {};
        for (const PrismTree& tree : bake_prisms(scene, corner, tile_side_mm(levels, z)).trees) ++mine[tree.quadrant];
        for (int q = 0; q < 4; ++q)
          EXPECT_EQ(mine[q],
                    bake_prisms(scene, tile_corner(levels, child_of({z, x, y}, q)), tile_side_mm(levels, z + 1))
                        .trees.size());
      }
}

TEST(PrismTrees, AreDiscsOnTheGroundWhereTheyAreManyAndTheTileIsWide) {
  const City city = grove(2000, 3);
  const BakeScene scene = scene_of(city);
  const int levels = levels_of(city);
  const PlanPoint corner = tile_corner(levels, {0, 0, 0});
  const std::uint32_t side = tile_side_mm(levels, 0);
  EXPECT_FALSE(has_standing_trees(scene, corner, side));
  const PrismTile tile = bake_prisms(scene, corner, side);
  EXPECT_TRUE(tile.trees.empty());
  EXPECT_GE(tile.error_mm / 1000.0, flat_trees_error_m(scene, corner, side));
  EXPECT_GT(flat_trees_error_m(scene, corner, side), 3);

  const TileFrame frame{corner, 512, side, {}};
  const GroundColours with(scene, frame, true), without(scene, frame, false);
  std::size_t leaves = 0, pavement = 0;
  for (const BakeTree& tree : scene.trees()) {
    const auto cell = [&](std::int32_t at, std::int32_t from) {
      return static_cast<std::size_t>(metres(at - from) / frame.cell_m());
    };
    const std::size_t column = cell(tree.at.x, corner.x), row = cell(tree.at.y, corner.y);
    const ColourMean a = with.of_cell(column, row), b = without.of_cell(column, row);
    leaves += a.g > a.r + 20;
    pavement += std::abs(b.g - b.r) < 20;
  }
  EXPECT_GT(leaves, scene.trees().size() * 9 / 10);
  EXPECT_EQ(pavement, scene.trees().size());
}

TEST(PrismTrees, MakeTilesWhereNoHouseStandsAndChangeTheKeyWhenOneMoves) {
  City city = grove(2000, 4);
  const BakeScene scene = scene_of(city);
  const int levels = levels_of(city);
  const auto before = plan_tiles(scene, levels, 1);
  EXPECT_GT(std::count_if(before.begin(), before.end(), [&](const TileNode& n) { return n.at.z == levels - 1; }), 8);
  for (const TileNode& n : before) EXPECT_TRUE(n.has_prisms);
  city.objects[0].height_m = 31;
  const auto after = plan_tiles(scene_of(city), levels, 1);
  ASSERT_EQ(after.size(), before.size());
  std::size_t changed = 0;
  for (std::size_t i = 0; i < after.size(); ++i) changed += after[i].key != before[i].key;
  EXPECT_GE(changed, static_cast<std::size_t>(levels));
  EXPECT_LT(changed, before.size() / 2);
}

}  // namespace
}  // namespace vicus
