#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/units.hpp"

/// The ground of a tile seen from the air: heights at nodes and one picture. Bytes: ground_tile_layout.h.
namespace vicus {

struct GroundTile {
  PlanPoint corner;  ///< south-west
  std::uint32_t tile_side_mm = 0, nodes = 0;
  std::int32_t base_mm = 0;
  std::uint32_t step_mm = 1;
  std::uint64_t key = 0;
  std::vector<std::uint16_t> height;  ///< steps above the base, nodes * nodes, row by row from the south
  std::uint32_t picture_side = 0;     ///< texels
  std::string picture;                ///< WebP, north row first
  friend bool operator==(const GroundTile&, const GroundTile&) = default;
};

/// Needs   height of nodes * nodes; nodes and picture_side within the layout's bounds (assert).
std::string encode_ground(const GroundTile& tile);
/// Of hostile bytes; nullopt for what encode_ground cannot have made. The picture is not looked into.
std::optional<GroundTile> decode_ground(std::string_view bytes);

}  // namespace vicus
