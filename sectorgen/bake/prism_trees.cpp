#include "sectorgen/bake/prism_trees.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/z_order.hpp"

namespace vicus {
namespace {

constexpr std::uint32_t kNearTile_mm = 128'000;
constexpr std::size_t kFewTrees = 64;

PlanBox box_of_tile(PlanPoint corner, std::uint32_t side_mm) {
  const auto side = static_cast<std::int32_t>(side_mm);
  return {corner, {corner.x + side - 1, corner.y + side - 1}};
}

bool is_in(PlanPoint p, const PlanBox& box) {
  return p.x >= box.min.x && p.y >= box.min.y && p.x <= box.max.x && p.y <= box.max.y;
}

std::uint16_t place_of(Colour colour, std::vector<Colour>& palette) {
  const auto at = std::find(palette.begin(), palette.end(), colour);
  const auto place = static_cast<std::uint16_t>(at - palette.begin());
  if (at == palette.end()) palette.push_back(colour);
  return place;
}

}  // namespace

bool has_standing_trees(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm) {
  return tile_side_mm <= kNearTile_mm || scene.trees_in(box_of_tile(corner, tile_side_mm)).size() <= kFewTrees;
}

void set_trees(const BakeScene& scene, PrismTile& tile) {
  const PlanBox box = box_of_tile(tile.corner, tile.tile_side_mm);
  const auto step = static_cast<std::int32_t>(tile.step_mm), half = static_cast<std::int32_t>(tile.tile_side_mm / 2);
  const auto steps_up = [&](double m) { return std::lround(m * kMmPerMetre / tile.up_step_mm); };
  for (const std::uint32_t i : scene.trees_in(box)) {
    const BakeTree& tree = scene.trees()[i];
    if (!is_in(tree.at, box)) continue;
    const std::int32_t x = tree.at.x - box.min.x, y = tree.at.y - box.min.y;
    PrismTree& out = tile.trees.emplace_back();
    out.at = {x / step, y / step};
    out.ground = static_cast<std::int32_t>(steps_up(tree.ground_m - metres(tile.base_mm)));
    out.height = static_cast<std::uint32_t>(steps_up(tree.shape.height_m));
    out.crown = static_cast<std::uint32_t>(steps_up(tree.shape.crown_m));
    out.form = tree.shape.form;
    out.quadrant = static_cast<std::uint8_t>((x >= half ? 1 : 0) + (y >= half ? 2 : 0));
    out.leaves = place_of(tree.shape.leaves, tile.palette);
  }
  std::stable_sort(tile.trees.begin(), tile.trees.end(),
                   [](const PrismTree& a, const PrismTree& b) { return z_order(a.at) < z_order(b.at); });
}

double flat_trees_error_m(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm) {
  double most = 0;
  for (const std::uint32_t i : scene.trees_in(box_of_tile(corner, tile_side_mm)))
    most = std::max(most, scene.trees()[i].shape.crown_m);
  return most;
}

}  // namespace vicus
