#include "city_db/ground_tile.hpp"

#include <cassert>

#include "city_db/byte_fields.hpp"
#include "city_db/ground_tile_layout.h"

namespace vicus {
namespace {

bool has_right_sizes(std::uint32_t nodes, std::uint32_t picture_side) {
  return nodes % 2 == 1 && nodes >= GROUND_LEAST_NODES && nodes <= GROUND_MOST_NODES && picture_side > 0 &&
         picture_side <= GROUND_MOST_PICTURE_SIDE;
}

}  // namespace

std::string encode_ground(const GroundTile& tile) {
  assert(has_right_sizes(tile.nodes, tile.picture_side));
  assert(tile.height.size() == std::size_t{tile.nodes} * tile.nodes);
  std::string out(GROUND_HEADER_BYTES, '\0');
  const auto put = [&](std::size_t at, std::uint64_t value, std::size_t size) { set_field(out, at, value, size); };
  put(GROUND_MAGIC_AT, GROUND_MAGIC, 4);
  put(GROUND_VERSION_AT, GROUND_VERSION, 2);
  put(GROUND_NODES_AT, tile.nodes, 2);
  put(GROUND_TILE_SIDE_AT, tile.tile_side_mm, 4);
  put(GROUND_EAST_AT, static_cast<std::uint32_t>(tile.corner.x), 4);
  put(GROUND_NORTH_AT, static_cast<std::uint32_t>(tile.corner.y), 4);
  put(GROUND_BASE_AT, static_cast<std::uint32_t>(tile.base_mm), 4);
  put(GROUND_STEP_AT, tile.step_mm, 4);
  put(GROUND_PICTURE_SIDE_AT, tile.picture_side, 4);
  put(GROUND_PICTURE_BYTES_AT, tile.picture.size(), 4);
  put(GROUND_KEY_AT, tile.key, 8);
  for (const std::uint16_t h : tile.height) out.push_back(static_cast<char>(h >> 8));
  for (const std::uint16_t h : tile.height) out.push_back(static_cast<char>(h & 0xff));
  return out + tile.picture;
}

std::optional<GroundTile> decode_ground(std::string_view bytes) {
  if (bytes.size() < GROUND_HEADER_BYTES || u32_at(bytes, GROUND_MAGIC_AT) != GROUND_MAGIC ||
      u16_at(bytes, GROUND_VERSION_AT) != GROUND_VERSION)
    return std::nullopt;
  GroundTile tile;
  tile.nodes = u16_at(bytes, GROUND_NODES_AT);
  tile.tile_side_mm = u32_at(bytes, GROUND_TILE_SIDE_AT);
  tile.corner = {i32_at(bytes, GROUND_EAST_AT), i32_at(bytes, GROUND_NORTH_AT)};
  tile.base_mm = i32_at(bytes, GROUND_BASE_AT);
  tile.step_mm = u32_at(bytes, GROUND_STEP_AT);
  tile.picture_side = u32_at(bytes, GROUND_PICTURE_SIDE_AT);
  tile.key = field_at(bytes, GROUND_KEY_AT, 8);
  const std::size_t cells = std::size_t{tile.nodes} * tile.nodes, picture = u32_at(bytes, GROUND_PICTURE_BYTES_AT);
  if (!has_right_sizes(tile.nodes, tile.picture_side) || tile.step_mm == 0 ||
      bytes.size() != GROUND_HEADER_BYTES + 2 * cells + picture)
    return std::nullopt;
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[GROUND_HEADER_BYTES + i]); };
  for (std::size_t i = 0; i < cells; ++i)
    tile.height.push_back(static_cast<std::uint16_t>(byte(i) << 8 | byte(cells + i)));
  tile.picture = bytes.substr(GROUND_HEADER_BYTES + 2 * cells);
  return tile;
}

}  // namespace vicus
