#include "city_db/tile_tree.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace vicus {

int tile_levels(const PlanBox& box) {
  std::int64_t reach = 0;
  if (!box.is_empty())
    for (const std::int64_t v : {box.min.x, box.min.y, box.max.x, box.max.y}) reach = std::max(reach, std::abs(v));
  int levels = 2;  // one tile of the smallest has no middle at the origin
  while (std::int64_t{tile_side_mm(levels, 0)} / 2 < reach && levels < kMostTileLevels) ++levels;
  return levels;
}

std::uint32_t tile_side_mm(int levels, int z) { return kLeafSide_mm << (levels - 1 - z); }

PlanPoint tile_corner(int levels, const TileAddress& tile) {
  const auto half = static_cast<std::int64_t>(tile_side_mm(levels, 0) / 2);
  const std::int64_t side = tile_side_mm(levels, tile.z);
  return {static_cast<std::int32_t>(side * tile.x - half), static_cast<std::int32_t>(side * tile.y - half)};
}

PlanBox tile_box(int levels, const TileAddress& tile) {
  const PlanPoint corner = tile_corner(levels, tile);
  const auto side = static_cast<std::int32_t>(tile_side_mm(levels, tile.z));
  return {corner, {corner.x + side, corner.y + side}};
}

TileAddress child_of(const TileAddress& tile, int which) {
  return {tile.z + 1, tile.x * 2 + static_cast<std::uint32_t>(which & 1),
          tile.y * 2 + static_cast<std::uint32_t>(which >> 1)};
}

std::string tile_path(const TileAddress& tile) {
  return "blockmaps/" + std::to_string(tile.z) + "/" + std::to_string(tile.x) + "/" + std::to_string(tile.y);
}

std::optional<TileAddress> parse_tile(std::string_view text, int levels) {
  std::uint32_t numbers[3] = {};
  for (int i = 0; i < 3; ++i) {
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
    const auto length = static_cast<std::size_t>(end - text.data());
    if (fault != std::errc() || (length > 1 && text[0] == '0')) return std::nullopt;
    text.remove_prefix(length);
    if (i == 2) break;
    if (text.empty() || text[0] != '/') return std::nullopt;
    text.remove_prefix(1);
  }
  if (!text.empty() || numbers[0] >= static_cast<std::uint32_t>(levels) || levels > kMostTileLevels)
    return std::nullopt;
  const std::uint32_t across = 1u << numbers[0];
  if (numbers[1] >= across || numbers[2] >= across) return std::nullopt;
  return TileAddress{static_cast<int>(numbers[0]), numbers[1], numbers[2]};
}

}  // namespace vicus
