#pragma once
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "city_db/tile_tree.hpp"
#include "city_db/units.hpp"

/// Which tiles a view needs: the rule of client_scripts/core/TileTree.js, where all tiles are there at once.
namespace vicus::measure {

/// The numbers of TileTree.js; tile_choice_test holds both to each other.
inline constexpr double kCoarsenShare = 0.8, kRoofs_m = 100, kNearest_m = 10;
/// Where prisms and BlockMaps are mixed: tiles of more houses are BlockMaps.
inline constexpr std::size_t kMostPolygonHouses = 1500;

struct TileView {
  Enu eye;
  double pixels_per_radian = 0, tau_px = 0;
};

struct TileTree {
  int levels = 1;
  /// Stated error of the form that a tile is sent in, m; nullopt: there is no such tile.
  std::function<std::optional<double>(const TileAddress&)> error_m;
};

/// From an eye to the nearest point that something of the tile may be at, m.
double distance_m(int levels, const TileAddress& tile, const Enu& eye);

/// The tiles to draw, depth first; none twice, none within another. `refined`: tiles that gave way to their children in
/// the last view, replaced by those of this one.
/// Source  paper 001 §6; docs/blockmaps.md, "Which tiles a view needs".
std::vector<TileAddress> choose_tiles(const TileTree& tree, const TileView& view, std::set<TileAddress>& refined);

/// All tiles above these.
std::set<TileAddress> above(const std::vector<TileAddress>& tiles);

}  // namespace vicus::measure
