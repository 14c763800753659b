#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "city_db/units.hpp"

/// The quadtree over the plan that flying uses (paper 000 §4, 001 §6): the root is a square around the plan's origin,
/// each level halves it, the smallest tiles are kLeafSide_mm wide. A city that grows keeps its tiles: only roots are
/// added.
namespace vicus {

inline constexpr std::uint32_t kLeafSide_mm = 128'000;
inline constexpr int kMostTileLevels = 12;

/// Tile x, y of level z, counted from the south-west corner of the root.
struct TileAddress {
  int z = 0;
  std::uint32_t x = 0, y = 0;
  friend auto operator<=>(const TileAddress&, const TileAddress&) = default;
};

/// Levels of the tree that covers `box`: the root alone is 1.   Needs   a box within the plan.
int tile_levels(const PlanBox& box);
std::uint32_t tile_side_mm(int levels, int z);
PlanPoint tile_corner(int levels, const TileAddress& tile);
PlanBox tile_box(int levels, const TileAddress& tile);
TileAddress child_of(const TileAddress& tile, int which);  ///< 0 ... 3: south-west, south-east, north-west, north-east

/// "blockmaps/Z/X/Y"
std::string tile_path(const TileAddress& tile);
/// Of "Z/X/Y"; nullopt for any other text and for tiles outside of a tree of so many levels.
std::optional<TileAddress> parse_tile(std::string_view text, int levels);

}  // namespace vicus
