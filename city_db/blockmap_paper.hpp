#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/units.hpp"

/// BlockMaps as published, 2007 (paper 000 §3) and 2009 (paper 001 §4): what ours is measured against. Bytes:
/// blockmap2007_layout.h, blockmap2009_layout.h.
namespace vicus {

enum class PaperYear { y2007, y2009 };

struct PaperBlockMap {
  PaperYear year = PaperYear::y2007;
  std::uint32_t side = 0, columns = 0, slices = 1;  ///< n, w, s: "n:w"
  PlanPoint corner;
  std::uint32_t tile_side_mm = 0;
  std::int32_t base_mm = 0;
  std::uint32_t top_mm = 0;          ///< of the height 255 above the base
  std::vector<std::uint8_t> texels;  ///< rows of width() texels of channels() bytes, north row first

  std::uint32_t width() const { return 2 * side + columns; }
  std::uint32_t channels() const { return year == PaperYear::y2007 ? 3 : 4; }
  const std::uint8_t* texel(std::size_t column, std::size_t row) const {
    return &texels[(row * width() + column) * channels()];
  }
  std::uint8_t* texel(std::size_t column, std::size_t row) { return &texels[(row * width() + column) * channels()]; }
  /// The geometry of a cell, counted from the south-west.
  const std::uint8_t* cell(std::size_t column, std::size_t row) const { return texel(column, side - 1 - row); }
  std::uint8_t* cell(std::size_t column, std::size_t row) { return texel(column, side - 1 - row); }
  /// 0: none, else 1 + the wall column of a cell.
  std::uint32_t wall_column(std::size_t column, std::size_t row) const;
  void set_wall_column(std::size_t column, std::size_t row, std::uint32_t wall);  ///< 1 + the column
  friend bool operator==(const PaperBlockMap&, const PaperBlockMap&) = default;
};

/// Needs   texels of side rows.
std::string encode_paper(const PaperBlockMap& map);
/// Of hostile bytes; nullopt for what encode_paper cannot have made.
std::optional<PaperBlockMap> decode_paper(std::string_view bytes);

}  // namespace vicus
