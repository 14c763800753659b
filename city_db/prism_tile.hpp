#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/city.hpp"

/// The houses of a tile as prisms with simple roofs: what a client turns into polygons. Bytes: prism_tile_layout.h.
/// Source  research/IMAGE_BASED.md §0: for prisms the polygon wins near and mid.
namespace vicus {

enum class PrismKind : std::uint8_t { flat, tent, gabled, hipped };

struct PrismHouse {
  PrismKind kind = PrismKind::flat;
  bool is_owned = true;       ///< its middle lies in the tile
  std::uint8_t quadrant = 0;  ///< of the middle: 0 south-west, 1 south-east, 2 north-west, 3 north-east; 0 if not owned
  /// Steps from the tile's corner; outer counter-clockwise, then holes clockwise; at least three points each.
  std::vector<std::vector<PlanPoint>> rings;
  std::int32_t ground = 0;           ///< steps above the tile's base
  std::uint32_t eave = 0, rise = 0;  ///< steps above the ground, above the eave
  std::uint16_t wall = 0, roof = 0;  ///< of the palette
  friend bool operator==(const PrismHouse&, const PrismHouse&) = default;
};

struct PrismTile {
  PlanPoint corner;
  std::uint32_t tile_side_mm = 0;
  std::int32_t base_mm = 0;
  std::uint32_t step_mm = 1, up_step_mm = 1, error_mm = 0;
  std::uint64_t key = 0;
  std::vector<Colour> palette;
  std::vector<PrismHouse> houses;
  friend bool operator==(const PrismTile&, const PrismTile&) = default;
};

/// Needs   gabled and hipped houses have one ring of four points; palette indices exist.
std::string encode_prisms(const PrismTile& tile);
/// Of hostile bytes; nullopt for what encode_prisms cannot have made.
std::optional<PrismTile> decode_prisms(std::string_view bytes);

}  // namespace vicus
