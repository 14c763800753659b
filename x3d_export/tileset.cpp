#include "x3d_export/tileset.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "x3d_export/earth_frame.hpp"
#include "x3d_export/glb.hpp"
#include "x3d_export/text.hpp"
#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kSectorsInAGroup = 8;
constexpr double kLargestOpening_m = 2.5;

struct Box {
  std::array<double, 3> min{1e300, 1e300, 1e300}, max{-1e300, -1e300, -1e300};
  void add(const std::array<double, 3>& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      min[i] = std::min(min[i], p[i]);
      max[i] = std::max(max[i], p[i]);
    }
  }
  /// Centre and half axes.
  Json json() const {
    Json numbers = Json::array();
    for (std::size_t i = 0; i < 3; ++i) numbers.push_back((min[i] + max[i]) / 2);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < 3; ++i) numbers.push_back(axis == i ? (max[i] - min[i]) / 2 : 0.0);
    return {{"box", numbers}};
  }
};

/// Column after column, as 3D Tiles writes a matrix.
Json matrix_of(const Placement& placement) {
  Json numbers = Json::array();
  for (std::size_t column = 0; column < 4; ++column) {
    for (const double v : placement.columns[column]) numbers.push_back(v);
    numbers.push_back(column == 3 ? 1.0 : 0.0);
  }
  return numbers;
}

struct SectorTile {
  const Sector* sector = nullptr;
  Json json;
  Box in_city;  ///< in the root's frame
  double height_m = 0;
};

/// glTF's y is up; a tile's z is.
Box tile_box(const CityIndex& index, const Sector& sector, Detail detail) {
  const auto b = glb_bounds(index, sector, detail);
  Box box;
  box.add({b[0], -b[5], b[1]});
  box.add({b[3], -b[2], b[4]});
  return box;
}

SectorTile sector_tile(const CityIndex& index, const Sector& sector, const Placement& root) {
  const LatLon origin = index.city().origin;
  const Placement to_city = relative(earth_from_plan(origin, sector.origin, 0), root);
  const Box near = tile_box(index, sector, Detail::near);
  Box both = tile_box(index, sector, Detail::far);
  both.add(near.min);
  both.add(near.max);
  SectorTile tile{&sector, {}, {}, both.max[2] - both.min[2]};
  for (int corner = 0; corner < 8; ++corner) {
    std::array<double, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = (corner >> i) & 1 ? both.max[i] : both.min[i];
    tile.in_city.add(to_city(p));
  }
  const Json child{
      {"boundingVolume", near.json()}, {"geometricError", 0}, {"content", {{"uri", "sectors/" + sector.id + ".glb"}}}};
  tile.json = {{"transform", matrix_of(to_city)},
               {"boundingVolume", both.json()},
               {"geometricError", kLargestOpening_m},
               {"refine", "REPLACE"},
               {"content", {{"uri", "sectors/" + sector.id + ".far.glb"}}},
               {"children", Json::array({child})}};
  return tile;
}

/// Needs   !tiles.empty().
Json group_of(std::span<SectorTile> tiles) {
  Box box;
  double error = kLargestOpening_m;
  for (const SectorTile& tile : tiles) {
    box.add(tile.in_city.min);
    box.add(tile.in_city.max);
    error = std::max(error, tile.height_m);
  }
  Json children = Json::array();
  if (tiles.size() <= kSectorsInAGroup) {
    for (SectorTile& tile : tiles) children.push_back(std::move(tile.json));
  } else {
    const std::size_t axis = box.max[0] - box.min[0] >= box.max[1] - box.min[1] ? 0 : 1;
    const auto middle = [&](const SectorTile& t) {
      return std::tuple(t.in_city.min[axis] + t.in_city.max[axis], t.sector->id);
    };
    const auto half = tiles.begin() + static_cast<std::ptrdiff_t>(tiles.size() / 2);
    std::nth_element(tiles.begin(), half, tiles.end(),
                     [&](const auto& a, const auto& b) { return middle(a) < middle(b); });
    children.push_back(group_of({tiles.begin(), half}));
    children.push_back(group_of({half, tiles.end()}));
  }
  return {{"boundingVolume", box.json()}, {"geometricError", error}, {"refine", "ADD"}, {"children", children}};
}

}  // namespace

std::string tileset_json(const CityIndex& index) {
  const City& city = index.city();
  const Placement root = earth_from_plan(city.origin, {0, 0}, 0);
  std::vector<SectorTile> tiles;
  for (const Sector& sector : city.sectors) tiles.push_back(sector_tile(index, sector, root));
  Json tree = group_of(tiles);
  tree["transform"] = matrix_of(root);
  Json asset{{"version", "1.1"}, {"generator", kGenerator}};
  if (const auto at = city.meta.find("licences"); at != city.meta.end() && !at->second.empty())
    asset["copyright"] = clean_text(at->second);
  // Where not even the root is drawn, all of the city is missing.
  const double all = tree["geometricError"].get<double>() * 2;
  return Json{{"asset", asset}, {"geometricError", all}, {"root", tree}}.dump(1) + "\n";
}

}  // namespace vicus
