#include "sectorgen/bake/bake_ground.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/boxes.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/bake/ground_colours.hpp"
#include "sectorgen/bake/prism_trees.hpp"

namespace vicus {
namespace {

constexpr std::uint32_t kPictureSide = 256, kLevelNodes = 3, kNodes = 33, kLeastStep_mm = 10;
/// Ground without surfaces in a block is like the ground around; squares as wide as this are beyond the city.
constexpr std::uint32_t kYard_mm = kGroundSquare_mm;
constexpr int kQuality = 82;
constexpr double kDarkest = 0.45;  // of the light where no sky is seen: what walls reflect

std::vector<double> heights_m(const BakeScene& scene, PlanPoint corner, std::uint32_t side_mm, std::uint32_t nodes) {
  std::vector<double> out;
  for (std::uint32_t row = 0; row < nodes; ++row)
    for (std::uint32_t column = 0; column < nodes; ++column) {
      const auto at = [&](std::int32_t from, std::uint32_t i) {
        return static_cast<std::int32_t>(from + std::int64_t{side_mm} * i / (nodes - 1));
      };
      out.push_back(height_m(scene.terrain(), {at(corner.x, column), at(corner.y, row)}));
    }
  return out;
}

/// Where the city ends in or beside the tile, what is wide without ground is filled in coarser squares first, with a
/// square of kYard_mm around the tile: so the colours meet those of the tiles around, whose squares are the same.
RgbImage filled_colours(const BakeScene& scene, const TileFrame& tile, bool has_leaves) {
  constexpr std::uint32_t kCoarser = 8;
  const GroundColours colours(scene, tile, has_leaves);
  const std::uint32_t square_mm = kCoarser * 2 * tile.tile_side_mm / tile.side;
  const PlanBox around = grown(tile.box(), std::int32_t{kYard_mm});
  if (square_mm > kYard_mm || !scene.lacks_ground(grown(around, -1))) return colours.filled(metres(kYard_mm));
  const std::uint32_t side_mm = tile.tile_side_mm + 2 * kYard_mm;
  const RgbImage larger =
      GroundColours(scene, {around.min, 2 * side_mm / square_mm, side_mm, {}}, has_leaves).filled(metres(kYard_mm));
  return colours.filled(metres(square_mm), &larger);
}

std::uint8_t darkened(std::uint8_t colour, std::uint8_t ambient) {
  const double light = kDarkest + (1 - kDarkest) * ambient / 255.0;
  return static_cast<std::uint8_t>(std::lround(colour * light));
}

}  // namespace

GroundTile bake_ground(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm, bool with_ambient) {
  GroundTile tile;
  tile.corner = corner;
  tile.tile_side_mm = tile_side_mm;
  tile.nodes = scene.terrain().height_mm.empty() ? kLevelNodes : kNodes;
  const auto heights = heights_m(scene, corner, tile_side_mm, tile.nodes);
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  tile.base_mm = static_cast<std::int32_t>(std::floor(*low * kMmPerMetre));
  const double range_mm = *high * kMmPerMetre - tile.base_mm;
  tile.step_mm = std::max(kLeastStep_mm, static_cast<std::uint32_t>(std::ceil(range_mm / 65'000)));
  for (const double h : heights)
    tile.height.push_back(static_cast<std::uint16_t>(std::lround((h * kMmPerMetre - tile.base_mm) / tile.step_mm)));

  const TileFrame frame{corner, 2 * kPictureSide, tile_side_mm, {}};
  RgbImage picture = filled_colours(scene, frame, !has_standing_trees(scene, corner, tile_side_mm));
  const auto ambient = with_ambient ? ambient_light(scene, frame) : std::vector<std::uint8_t>{};  // south row first
  for (std::size_t row = 0; with_ambient && row < kPictureSide; ++row)
    for (std::size_t column = 0; column < kPictureSide; ++column) {
      const Colour c = picture.at(column, row);
      const std::uint8_t a = ambient[(kPictureSide - 1 - row) * kPictureSide + column];
      picture.set(column, row, {darkened(c.r, a), darkened(c.g, a), darkened(c.b, a)});
    }
  tile.picture_side = kPictureSide;
  tile.picture = encode_webp(picture, kQuality);
  return tile;
}

}  // namespace vicus
