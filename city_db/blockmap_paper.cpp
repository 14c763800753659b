#include "city_db/blockmap_paper.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

#include "city_db/blockmap2007_layout.h"
#include "city_db/blockmap2009_layout.h"
#include "city_db/byte_fields.hpp"

namespace vicus {
namespace {

constexpr std::uint32_t kMostSide = 512, kMostColumns = 4096;

/// The same fields of both layouts.
struct HeaderPlaces {
  std::uint32_t magic;
  std::size_t magic_at, side, columns, slices, tile_side, east, north, base, top, bytes;
};
constexpr HeaderPlaces kPlaces[] = {
    {BLOCKMAP2007_MAGIC, BLOCKMAP2007_MAGIC_AT, BLOCKMAP2007_SIDE_AT, BLOCKMAP2007_COLUMNS_AT, BLOCKMAP2007_SLICES_AT,
     BLOCKMAP2007_TILE_SIDE_AT, BLOCKMAP2007_EAST_AT, BLOCKMAP2007_NORTH_AT, BLOCKMAP2007_BASE_AT, BLOCKMAP2007_TOP_AT,
     BLOCKMAP2007_HEADER_BYTES},
    {BLOCKMAP2009_MAGIC, BLOCKMAP2009_MAGIC_AT, BLOCKMAP2009_SIDE_AT, BLOCKMAP2009_COLUMNS_AT, BLOCKMAP2009_SLICES_AT,
     BLOCKMAP2009_TILE_SIDE_AT, BLOCKMAP2009_EAST_AT, BLOCKMAP2009_NORTH_AT, BLOCKMAP2009_BASE_AT, BLOCKMAP2009_TOP_AT,
     BLOCKMAP2009_HEADER_BYTES}};

bool is_sound(const PaperBlockMap& map) {
  return std::has_single_bit(map.side) && map.side >= 8 && map.side <= kMostSide && map.columns >= 1 &&
         map.columns <= kMostColumns && map.slices >= 1 && map.slices <= std::max(1u, map.side / 4) &&
         (map.year == PaperYear::y2009 || map.slices == 1) && map.tile_side_mm > 0;
}

/// The columns spread over the values that the channels have.
struct ColumnRange {
  std::uint32_t first, last;
};
ColumnRange range_of(const PaperBlockMap& map) {
  if (map.year == PaperYear::y2007) return {BLOCKMAP2007_FIRST_COLUMN, BLOCKMAP2007_LAST_COLUMN};
  return {BLOCKMAP2009_FIRST_COLUMN, BLOCKMAP2009_LAST_COLUMN};
}

}  // namespace

std::uint32_t PaperBlockMap::wall_column(std::size_t column, std::size_t row) const {
  const std::uint8_t* p = cell(column, row);
  std::uint32_t value = p[BLOCKMAP2007_COLUMN_CHANNEL];
  if (year == PaperYear::y2009)
    value = p[BLOCKMAP2009_HEIGHT_CHANNEL] == 0 ? 0 : value + 256u * p[BLOCKMAP2009_COLUMN_HIGH_CHANNEL];
  if (value == 0) return 0;
  const auto [first, last] = range_of(*this);
  if (columns >= last) return std::min(value, columns);
  return 1 + ((value - first) * (columns - 1) + (last - first) / 2) / (last - first);
}

void PaperBlockMap::set_wall_column(std::size_t column, std::size_t row, std::uint32_t wall) {
  const auto [first, last] = range_of(*this);
  std::uint32_t value = wall;
  if (wall != 0 && columns < last)
    value = columns == 1 ? first : first + ((wall - 1) * (last - first) + (columns - 1) / 2) / (columns - 1);
  std::uint8_t* p = cell(column, row);
  p[BLOCKMAP2007_COLUMN_CHANNEL] = static_cast<std::uint8_t>(value & 0xff);
  if (year == PaperYear::y2009) p[BLOCKMAP2009_COLUMN_HIGH_CHANNEL] = static_cast<std::uint8_t>(value >> 8);
}

std::string encode_paper(const PaperBlockMap& map) {
  assert(is_sound(map) && map.texels.size() == std::size_t{map.width()} * map.side * map.channels());
  const HeaderPlaces& at = kPlaces[static_cast<int>(map.year)];
  std::string out(at.bytes, '\0');
  set_field(out, at.magic_at, at.magic, 4);
  set_field(out, at.side, map.side, 2);
  set_field(out, at.columns, map.columns, 2);
  set_field(out, at.slices, map.slices, 2);
  set_field(out, at.tile_side, map.tile_side_mm, 4);
  set_field(out, at.east, static_cast<std::uint32_t>(map.corner.x), 4);
  set_field(out, at.north, static_cast<std::uint32_t>(map.corner.y), 4);
  set_field(out, at.base, static_cast<std::uint32_t>(map.base_mm), 4);
  set_field(out, at.top, map.top_mm, 4);
  out.append(reinterpret_cast<const char*>(map.texels.data()), map.texels.size());
  return out;
}

std::optional<PaperBlockMap> decode_paper(std::string_view bytes) {
  for (const PaperYear year : {PaperYear::y2007, PaperYear::y2009}) {
    const HeaderPlaces& at = kPlaces[static_cast<int>(year)];
    if (bytes.size() < at.bytes || u32_at(bytes, at.magic_at) != at.magic) continue;
    PaperBlockMap map;
    map.year = year;
    map.side = u16_at(bytes, at.side);
    map.columns = u16_at(bytes, at.columns);
    map.slices = u16_at(bytes, at.slices);
    map.tile_side_mm = u32_at(bytes, at.tile_side);
    map.corner = {i32_at(bytes, at.east), i32_at(bytes, at.north)};
    map.base_mm = i32_at(bytes, at.base);
    map.top_mm = u32_at(bytes, at.top);
    if (!is_sound(map)) return std::nullopt;
    const std::size_t texels = std::size_t{map.width()} * map.side * map.channels();
    if (bytes.size() != at.bytes + texels) return std::nullopt;
    const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data()) + at.bytes;
    map.texels.assign(from, from + texels);
    return map;
  }
  return std::nullopt;
}

}  // namespace vicus
