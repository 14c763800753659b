#include "cli/measure_tile_choice.hpp"

#include <algorithm>
#include <cmath>

namespace vicus::measure {
namespace {

class Chooser {
 public:
  Chooser(const TileTree& tree, const TileView& view, const std::set<TileAddress>& before)
      : tree_(tree), view_(view), before_(before) {}

  void visit(const TileAddress& tile, double error_m) {
    std::vector<std::pair<TileAddress, double>> children;
    if (tile.z + 1 < tree_.levels)
      for (int which = 0; which < 4; ++which)
        if (const auto error = tree_.error_m(child_of(tile, which)))
          children.emplace_back(child_of(tile, which), *error);
    const double on_screen =
        error_m * view_.pixels_per_radian / std::max(distance_m(tree_.levels, tile, view_.eye), kNearest_m);
    if (children.empty() || on_screen <= view_.tau_px * (before_.contains(tile) ? kCoarsenShare : 1)) {
      draw.push_back(tile);
      return;
    }
    refined.insert(tile);
    for (const auto& [child, error] : children) visit(child, error);
  }

  std::vector<TileAddress> draw;
  std::set<TileAddress> refined;

 private:
  const TileTree& tree_;
  const TileView& view_;
  const std::set<TileAddress>& before_;
};

}  // namespace

double distance_m(int levels, const TileAddress& tile, const Enu& eye) {
  const PlanBox box = tile_box(levels, tile);
  const double east = std::max({metres(box.min.x) - eye.east, 0.0, eye.east - metres(box.max.x)}),
               north = std::max({metres(box.min.y) - eye.north, 0.0, eye.north - metres(box.max.y)});
  return std::hypot(east, north, std::max(eye.up - kRoofs_m, 0.0));
}

std::vector<TileAddress> choose_tiles(const TileTree& tree, const TileView& view, std::set<TileAddress>& refined) {
  Chooser chooser(tree, view, refined);
  if (const auto error = tree.error_m({})) chooser.visit({}, *error);
  refined = std::move(chooser.refined);
  return std::move(chooser.draw);
}

std::set<TileAddress> above(const std::vector<TileAddress>& tiles) {
  std::set<TileAddress> out;
  for (TileAddress tile : tiles)
    while (tile.z > 0) {
      tile = {tile.z - 1, tile.x / 2, tile.y / 2};
      out.insert(tile);
    }
  return out;
}

}  // namespace vicus::measure
