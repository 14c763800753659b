#include "city_db/blockmap.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <numbers>

#include "city_db/blockmap_layout.h"
#include "city_db/byte_fields.hpp"

namespace vicus {
namespace {

constexpr std::uint32_t kMostTileSide_mm = 1u << 30;
constexpr std::uint32_t kMostStep_um = 100'000'000;

/// Heights of cells at the middles of their sides, um.
class SideHeights {
 public:
  explicit SideHeights(const BlockMap& map) : map_(map) {
    for (std::size_t slope = 0; slope < rise_.size(); ++slope)
      rise_[slope] = (static_cast<std::int64_t>(slope) - BLOCKMAP_SLOPE_ZERO) * std::int64_t{map.tile_side_mm} * 1000 /
                     (2 * BLOCKMAP_SLOPE_ONE * std::int64_t{map.side});
  }
  std::int64_t at(std::size_t cell, int east, int north) const {
    const std::int64_t rise = east != 0 ? east * rise_[map_.slope_east[cell]] : north * rise_[map_.slope_north[cell]];
    return std::int64_t{map_.height[cell]} * map_.step_um + rise;
  }

 private:
  const BlockMap& map_;
  std::array<std::int64_t, 256> rise_{};
};

struct SideStep {
  std::uint8_t bit;
  int east, north;
};
constexpr SideStep kSides[] = {{kWallEast, 1, 0}, {kWallNorth, 0, 1}, {kWallWest, -1, 0}, {kWallSouth, 0, -1}};

bool has_wall(const BlockMap& map, const SideHeights& heights, std::size_t column, std::size_t row,
              const SideStep& side) {
  const std::size_t n = map.side, cell = row * n + column;
  const std::int64_t own = heights.at(cell, side.east, side.north);
  const bool at_rim = (side.east > 0 && column + 1 == n) || (side.east < 0 && column == 0) ||
                      (side.north > 0 && row + 1 == n) || (side.north < 0 && row == 0);
  if (at_rim) return own > std::int64_t{map.wall_step_um};
  const std::size_t other = (row + static_cast<std::size_t>(side.north)) * n + column +
                            static_cast<std::size_t>(side.east);  // wraps back to the cell below or left
  if (map.offset[other] != 0) return false;
  return own - heights.at(other, -side.east, -side.north) > std::int64_t{map.wall_step_um};
}

/// Bits 0, 2, 4 ... side by side.   Needs   v < 2^32.
std::size_t every_other_bit(std::size_t v) {
  v &= 0x5555'5555;
  v = (v | v >> 1) & 0x3333'3333;
  v = (v | v >> 2) & 0x0f0f'0f0f;
  v = (v | v >> 4) & 0x00ff'00ff;
  return (v | v >> 8) & 0x0000'ffff;
}

bool is_sound(const BlockMap& map) {
  return std::has_single_bit(map.side) && map.side >= BLOCKMAP_LEAST_SIDE && map.side <= BLOCKMAP_MOST_SIDE &&
         map.rows >= BLOCKMAP_LEAST_ROWS && map.rows <= BLOCKMAP_MOST_ROWS && map.tile_side_mm > 0 &&
         map.tile_side_mm <= kMostTileSide_mm && map.step_um > 0 && map.step_um <= kMostStep_um &&
         std::abs(std::int64_t{map.base_east}) <= 8 * BLOCKMAP_BASE_ONE &&
         std::abs(std::int64_t{map.base_north}) <= 8 * BLOCKMAP_BASE_ONE &&
         std::abs(std::int64_t{map.corner.x}) < kPlanLimit && std::abs(std::int64_t{map.corner.y}) < kPlanLimit &&
         std::abs(std::int64_t{map.base_mm}) < kPlanLimit;
}

}  // namespace

CellLine line_of(std::uint8_t angle, std::uint8_t offset) {
  static const auto kNormals = [] {
    std::array<std::pair<double, double>, 256> out;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double turn = static_cast<double>(i) * (2 * std::numbers::pi / 256);
      out[i] = {std::cos(turn), std::sin(turn)};
    }
    return out;
  }();
  return {kNormals[angle].first, kNormals[angle].second,
          (offset - BLOCKMAP_OFFSET_ZERO) * (std::numbers::sqrt2 / 2 / BLOCKMAP_OFFSET_STEPS)};
}

std::vector<std::uint8_t> wall_bits(const BlockMap& map) {
  const SideHeights heights(map);
  std::vector<std::uint8_t> bits(map.height.size());
  for (std::size_t row = 0, cell = 0; row < map.side; ++row)
    for (std::size_t column = 0; column < map.side; ++column, ++cell) {
      if (map.offset[cell] != 0) {
        const std::int64_t rise = std::int64_t{map.height[cell]} - map.foot[cell];
        if (rise * map.step_um > std::int64_t{map.wall_step_um}) bits[cell] = kWallLine;
      } else {
        for (const auto& side : kSides)
          if (has_wall(map, heights, column, row, side)) bits[cell] |= side.bit;
      }
    }
  return bits;
}

std::vector<std::uint32_t> first_columns(const std::vector<std::uint8_t>& walls) {
  std::vector<std::uint32_t> first(walls.size() + 1);
  const int bits = std::countr_zero(walls.size()) / 2;
  std::uint32_t next = 0;
  for (std::size_t place = 0; place < walls.size(); ++place) {
    const std::size_t cell = (every_other_bit(place >> 1) << bits) + every_other_bit(place);
    first[cell] = next;
    next += static_cast<std::uint32_t>(std::popcount(walls[cell]));
  }
  first.back() = next;
  return first;
}

std::string encode_blockmap(const BlockMap& map) {
  const std::size_t cells = std::size_t{map.side} * map.side;
  assert(is_sound(map) && map.height.size() == cells && map.foot.size() == cells && map.slope_east.size() == cells &&
         map.slope_north.size() == cells && map.angle.size() == cells && map.offset.size() == cells);
  for (std::size_t i = 0; i < cells; ++i) assert(map.offset[i] != 0 || (map.angle[i] == 0 && map.foot[i] == 0));
  std::string out(BLOCKMAP_HEADER_BYTES + BLOCKMAP_PLANES * cells, '\0');
  const auto put = [&](std::size_t at, std::uint64_t value, std::size_t size) { set_field(out, at, value, size); };
  put(BLOCKMAP_MAGIC_AT, BLOCKMAP_MAGIC, 4);
  put(BLOCKMAP_VERSION_AT, BLOCKMAP_VERSION, 2);
  put(BLOCKMAP_SIDE_AT, map.side, 2);
  put(BLOCKMAP_ROWS_AT, map.rows, 2);
  put(BLOCKMAP_FLAGS_AT, map.ambient_image.empty() ? 0 : BLOCKMAP_FLAG_AMBIENT, 2);
  put(BLOCKMAP_COLUMNS_AT, first_columns(wall_bits(map)).back(), 4);
  put(BLOCKMAP_TILE_SIDE_AT, map.tile_side_mm, 4);
  put(BLOCKMAP_EAST_AT, static_cast<std::uint32_t>(map.corner.x), 4);
  put(BLOCKMAP_NORTH_AT, static_cast<std::uint32_t>(map.corner.y), 4);
  put(BLOCKMAP_BASE_AT, static_cast<std::uint32_t>(map.base_mm), 4);
  put(BLOCKMAP_BASE_EAST_AT, static_cast<std::uint32_t>(map.base_east), 4);
  put(BLOCKMAP_BASE_NORTH_AT, static_cast<std::uint32_t>(map.base_north), 4);
  put(BLOCKMAP_STEP_AT, map.step_um, 4);
  put(BLOCKMAP_WALL_STEP_AT, map.wall_step_um, 4);
  put(BLOCKMAP_ERROR_AT, map.error_mm, 4);
  put(BLOCKMAP_COLOUR_ERROR_AT, map.colour_error_milli, 4);
  put(BLOCKMAP_KEY_AT, map.key, 8);
  put(BLOCKMAP_TOP_AT, map.top, 4);
  put(BLOCKMAP_ROOF_BYTES_AT, map.roof_image.size(), 4);
  put(BLOCKMAP_GROUND_BYTES_AT, map.ground_image.size(), 4);
  put(BLOCKMAP_AMBIENT_BYTES_AT, map.ambient_image.size(), 4);
  put(BLOCKMAP_WALL_BYTES_AT, map.wall_image.size(), 4);
  const auto plane = [&](std::size_t which, auto value) {
    for (std::size_t i = 0; i < cells; ++i)
      out[BLOCKMAP_HEADER_BYTES + which * cells + i] = static_cast<char>(value(i) & 0xff);
  };
  plane(BLOCKMAP_PLANE_HEIGHT_HIGH, [&](std::size_t i) { return map.height[i] >> 8; });
  plane(BLOCKMAP_PLANE_HEIGHT_LOW, [&](std::size_t i) { return map.height[i]; });
  plane(BLOCKMAP_PLANE_SLOPE_EAST, [&](std::size_t i) { return map.slope_east[i]; });
  plane(BLOCKMAP_PLANE_SLOPE_NORTH, [&](std::size_t i) { return map.slope_north[i]; });
  plane(BLOCKMAP_PLANE_OFFSET, [&](std::size_t i) { return map.offset[i]; });
  const auto of_lines = [&](auto value) {
    for (std::size_t i = 0; i < cells; ++i)
      if (map.offset[i] != 0) out.push_back(static_cast<char>(value(i) & 0xff));
  };
  static_assert(BLOCKMAP_LINE_ANGLE == 0 && BLOCKMAP_LINE_FOOT_HIGH == 1 && BLOCKMAP_LINE_FOOT_LOW == 2);
  of_lines([&](std::size_t i) { return map.angle[i]; });
  of_lines([&](std::size_t i) { return map.foot[i] >> 8; });
  of_lines([&](std::size_t i) { return map.foot[i]; });
  return out + map.roof_image + map.ground_image + map.ambient_image + map.wall_image;
}

std::optional<BlockMap> decode_blockmap(std::string_view bytes) {
  if (bytes.size() < BLOCKMAP_HEADER_BYTES || u32_at(bytes, BLOCKMAP_MAGIC_AT) != BLOCKMAP_MAGIC ||
      u16_at(bytes, BLOCKMAP_VERSION_AT) != BLOCKMAP_VERSION)
    return std::nullopt;
  BlockMap map;
  map.side = u16_at(bytes, BLOCKMAP_SIDE_AT);
  map.rows = u16_at(bytes, BLOCKMAP_ROWS_AT);
  map.tile_side_mm = u32_at(bytes, BLOCKMAP_TILE_SIDE_AT);
  map.corner = {i32_at(bytes, BLOCKMAP_EAST_AT), i32_at(bytes, BLOCKMAP_NORTH_AT)};
  map.base_mm = i32_at(bytes, BLOCKMAP_BASE_AT);
  map.base_east = i32_at(bytes, BLOCKMAP_BASE_EAST_AT);
  map.base_north = i32_at(bytes, BLOCKMAP_BASE_NORTH_AT);
  map.step_um = u32_at(bytes, BLOCKMAP_STEP_AT);
  map.wall_step_um = u32_at(bytes, BLOCKMAP_WALL_STEP_AT);
  map.error_mm = u32_at(bytes, BLOCKMAP_ERROR_AT);
  map.colour_error_milli = u32_at(bytes, BLOCKMAP_COLOUR_ERROR_AT);
  map.key = field_at(bytes, BLOCKMAP_KEY_AT, 8);
  map.top = u32_at(bytes, BLOCKMAP_TOP_AT);
  if (!is_sound(map)) return std::nullopt;
  const std::uint16_t flags = u16_at(bytes, BLOCKMAP_FLAGS_AT);
  const std::size_t cells = std::size_t{map.side} * map.side;
  const std::uint64_t lengths[] = {u32_at(bytes, BLOCKMAP_ROOF_BYTES_AT), u32_at(bytes, BLOCKMAP_GROUND_BYTES_AT),
                                   u32_at(bytes, BLOCKMAP_AMBIENT_BYTES_AT), u32_at(bytes, BLOCKMAP_WALL_BYTES_AT)};
  const std::size_t planes_end = BLOCKMAP_HEADER_BYTES + BLOCKMAP_PLANES * cells;
  if (bytes.size() < planes_end) return std::nullopt;
  const auto offsets = bytes.substr(BLOCKMAP_HEADER_BYTES + BLOCKMAP_PLANE_OFFSET * cells, cells);
  const auto lines = cells - static_cast<std::size_t>(std::count(offsets.begin(), offsets.end(), '\0'));
  std::size_t at = planes_end + BLOCKMAP_LINE_BYTES * lines;
  if (bytes.size() != at + lengths[0] + lengths[1] + lengths[2] + lengths[3]) return std::nullopt;
  if (flags != (lengths[2] != 0 ? BLOCKMAP_FLAG_AMBIENT : 0)) return std::nullopt;
  const auto plane = [&](std::size_t which, std::size_t i) {
    return static_cast<std::uint8_t>(bytes[BLOCKMAP_HEADER_BYTES + which * cells + i]);
  };
  const auto wide = [&](std::size_t high, std::size_t low, std::size_t i) {
    return static_cast<std::uint16_t>(plane(high, i) << 8 | plane(low, i));
  };
  for (auto* list : {&map.height, &map.foot}) list->resize(cells);
  for (auto* list : {&map.slope_east, &map.slope_north, &map.angle, &map.offset}) list->resize(cells);
  const auto of_line = [&](std::size_t which, std::size_t line) {
    return static_cast<std::uint8_t>(bytes[planes_end + which * lines + line]);
  };
  for (std::size_t i = 0, line = 0; i < cells; ++i) {
    map.height[i] = wide(BLOCKMAP_PLANE_HEIGHT_HIGH, BLOCKMAP_PLANE_HEIGHT_LOW, i);
    map.slope_east[i] = plane(BLOCKMAP_PLANE_SLOPE_EAST, i);
    map.slope_north[i] = plane(BLOCKMAP_PLANE_SLOPE_NORTH, i);
    map.offset[i] = plane(BLOCKMAP_PLANE_OFFSET, i);
    if (map.offset[i] == 0) continue;
    map.angle[i] = of_line(BLOCKMAP_LINE_ANGLE, line);
    map.foot[i] =
        static_cast<std::uint16_t>(of_line(BLOCKMAP_LINE_FOOT_HIGH, line) << 8 | of_line(BLOCKMAP_LINE_FOOT_LOW, line));
    ++line;
  }
  if (u32_at(bytes, BLOCKMAP_COLUMNS_AT) != first_columns(wall_bits(map)).back()) return std::nullopt;
  std::string* images[] = {&map.roof_image, &map.ground_image, &map.ambient_image, &map.wall_image};
  for (std::size_t i = 0; i < 4; ++i) {
    images[i]->assign(bytes.substr(at, lengths[i]));
    at += lengths[i];
  }
  return map;
}

}  // namespace vicus
