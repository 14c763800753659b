#include "cli/measure_tile_choice.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/support/scratch.hpp"

namespace vicus::measure {
namespace {

using Json = nlohmann::json;

/// A tree with holes, errors that mostly fall from level to level, some tiles of prisms and some of BlockMaps.
struct RandomTree {
  explicit RandomTree(std::uint64_t seed) : random(seed) { add({}, 40); }

  void add(const TileAddress& at, double error) {
    const bool is_many = random() % 4 == 0;
    const double prism_error = std::round(error * (0.5 + unit()) * 1000) / 1000,
                 blockmap_error = std::round(error * (0.5 + unit()) * 1000) / 1000;
    const std::size_t houses = is_many ? kMostPolygonHouses + 1 : 10 + random() % 1000;
    const int forms = static_cast<int>(random() % 3);  // both, prisms alone, BlockMap alone
    const bool has_blockmap = forms != 1, has_prisms = forms != 2;
    const bool is_blockmap = !has_prisms || (has_blockmap && houses > kMostPolygonHouses);
    errors[at] = is_blockmap ? blockmap_error : prism_error;
    tiles.push_back({at.z, at.x, at.y, houses, has_blockmap ? Json(blockmap_error) : Json(), 1000,
                     has_prisms ? Json(prism_error) : Json(), 500});
    if (at.z + 1 == kLevels) return;
    for (int which = 0; which < 4; ++which)
      if (random() % 4 != 0) add(child_of(at, which), error / 2);
  }
  double unit() { return static_cast<double>(random() % 1'000'000) / 1e6; }
  TileTree tree() const {
    return {kLevels, [this](const TileAddress& at) -> std::optional<double> {
              const auto found = errors.find(at);
              return found == errors.end() ? std::nullopt : std::optional(found->second);
            }};
  }

  static constexpr int kLevels = 5;
  std::mt19937_64 random;
  std::map<TileAddress, double> errors;
  Json tiles = Json::array();
};

std::vector<TileView> flight(RandomTree& tree) {
  std::vector<TileView> views;
  const double side = metres(tile_side_mm(RandomTree::kLevels, 0));
  for (int i = 0; i < 12; ++i)
    views.push_back({{side * (tree.unit() - 0.5) * 1.4, side * (tree.unit() - 0.5) * 1.4, 1 + 600 * tree.unit()},
                     300 + 700 * tree.unit(),
                     0.5 + 30 * tree.unit()});
  return views;
}

TEST(TileChoice, IsThatOfTheClient) {
  constexpr std::uint64_t kSeeds = 40;
  Json cases = Json::array(), ours = Json::array();
  std::size_t drawn = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    RandomTree tree(seed);
    Json views = Json::array(), answers = Json::array();
    std::set<TileAddress> refined;
    for (const TileView& view : flight(tree)) {
      views.push_back({{"eye", {view.eye.east, view.eye.north, view.eye.up}},
                       {"pixelsPerRadian", view.pixels_per_radian},
                       {"pixels", view.tau_px}});
      Json paths = Json::array();
      for (const TileAddress& at : choose_tiles(tree.tree(), view, refined))
        paths.push_back(std::to_string(at.z) + "/" + std::to_string(at.x) + "/" + std::to_string(at.y));
      std::sort(paths.begin(), paths.end());
      drawn += paths.size();
      answers.push_back(std::move(paths));
    }
    cases.push_back(
        {{"tree", {{"levels", RandomTree::kLevels}, {"leafSide_m", kLeafSide_mm / 1000}, {"tiles", tree.tiles}}},
         {"views", std::move(views)}});
    ours.push_back(std::move(answers));
  }
  const test::ScratchDirectory scratch;
  test::write_bytes(scratch / "cases.json", cases.dump());
  const std::string command = "node '" VICUS_TESTS "/support/tileChoice.mjs' '" + (scratch / "cases.json").string() +
                              "' > '" + (scratch / "drawn.json").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Json theirs = Json::parse(test::read_bytes(scratch / "drawn.json"));
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) EXPECT_EQ(ours[seed], theirs[seed]) << "seed " << seed;
  EXPECT_GT(drawn, 5000u);
}

TEST(TileChoice, DrawsNoTileWithinAnotherAndForgetsNoGround) {
  RandomTree tree(7);
  for (const TileView& view : flight(tree)) {
    std::set<TileAddress> refined;
    const auto drawn = choose_tiles(tree.tree(), view, refined);
    const std::set<TileAddress> upper = above(drawn);
    EXPECT_EQ(refined, upper);
    for (const TileAddress& at : drawn) EXPECT_FALSE(upper.contains(at));
    for (const auto& [at, error] : tree.errors) {
      if (upper.contains(at)) continue;
      bool is_covered = false;  // by itself or by a tile around it
      for (TileAddress t = at;; t = {t.z - 1, t.x / 2, t.y / 2}) {
        is_covered = is_covered || std::find(drawn.begin(), drawn.end(), t) != drawn.end();
        if (t.z == 0) break;
      }
      EXPECT_TRUE(is_covered) << at.z << "/" << at.x << "/" << at.y;
    }
  }
}

TEST(TileChoice, KeepsWhatItHasUntilItIsClearlyBetter) {
  const TileTree tree{2, [](const TileAddress& at) -> std::optional<double> { return at.z == 0 ? 10.0 : 1.0; }};
  const double up = kRoofs_m + 1000;  // 1000 m away: 10 m are 10 px of 1000 px a radian
  std::set<TileAddress> refined;
  const auto count = [&](double tau) { return choose_tiles(tree, {{0, 0, up}, 1000, tau}, refined).size(); };
  EXPECT_EQ(count(10.5), 1u);
  EXPECT_EQ(count(9.5), 4u);
  EXPECT_EQ(count(11), 4u);  // 10 px are not below 0.8 of 11
  EXPECT_EQ(count(12.6), 1u);
}

}  // namespace
}  // namespace vicus::measure
