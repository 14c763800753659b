#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/blockmap_layout.h"
#include "city_db/units.hpp"

/// One tile of the image-based city in our own form, "BlockMap+": a plane for each cell of a grid, one footprint line
/// for each cell that needs it, and one column of wall colours for each wall. Bytes: blockmap_layout.h, FORMAT.md.
///
/// Surface in a cell with middle m: z(p) = base(p) + height + slope (p - m) where the cell has no line or
///         n (p - m) <= d; else z(p) = base(p) + foot. n = (cos, sin) of the angle, d the offset. Walls close every
///         step.
/// Source  paper 000 §3; research/IMAGE_BASED.md §A1.
/// Differs heights have 16 bits; slopes are geometry; a line in a cell; a column for each wall instead of one for each
///         cell, found by counting instead of being stored; no distance map (a pyramid of maxima replaces it).
namespace vicus {

struct BlockMap {
  std::uint32_t side = 0;  ///< cells
  std::uint32_t rows = 0;  ///< of a wall column
  PlanPoint corner;        ///< south-west
  std::uint32_t tile_side_mm = 0;
  std::int32_t base_mm = 0, base_east = 0, base_north = 0;  ///< base plane; slopes in BLOCKMAP_BASE_ONE
  std::uint32_t step_um = 1, wall_step_um = 0;
  std::uint32_t error_mm = 0, colour_error_milli = 0;
  std::uint64_t key = 0;
  std::uint32_t top = 0;                                            ///< steps
  std::vector<std::uint16_t> height, foot;                          ///< steps, side * side each
  std::vector<std::uint8_t> slope_east, slope_north;                ///< as stored
  std::vector<std::uint8_t> angle, offset;                          ///< angle and foot are 0 where offset is
  std::string roof_image, ground_image, ambient_image, wall_image;  ///< encode_indexed of each; empty: none
  friend bool operator==(const BlockMap&, const BlockMap&) = default;
};

/// Which walls a cell has columns for.
enum WallBit : std::uint8_t { kWallEast = 1, kWallNorth = 2, kWallWest = 4, kWallSouth = 8, kWallLine = 16 };

/// The walls of every cell: a cell with a line has that one, if its middle is more than wall_step above the foot; one
/// without has its sides towards cells without a line that lie more than wall_step lower there, and towards the tile's
/// rim as if nothing stood beyond it. Whole numbers only, so that every reader counts the same columns.
std::vector<std::uint8_t> wall_bits(const BlockMap& map);
/// The number of the first column of each cell, cells in Morton order (Z order: east is the lowest bit), so that
/// columns side by side in the picture are near each other in the city; and at the end the number of all columns. Needs
/// as many cells as a square with a power of two for its side has.
std::vector<std::uint32_t> first_columns(const std::vector<std::uint8_t>& walls);
inline std::uint32_t column_total(const std::vector<std::uint32_t>& first) { return first.back(); }

/// Slope as a number: rise over run.
inline double slope_of(std::uint8_t stored) { return (stored - BLOCKMAP_SLOPE_ZERO) / double{BLOCKMAP_SLOPE_ONE}; }
/// Unit normal of a stored angle and signed distance of the line from the middle, in cells.
struct CellLine {
  double east = 0, north = 0, distance = 0;
};
CellLine line_of(std::uint8_t angle, std::uint8_t offset);

/// Needs   planes of side * side, no angle nor foot where there is no line (assert).
std::string encode_blockmap(const BlockMap& map);
/// Of hostile bytes; nullopt for what encode_blockmap cannot have made. The images are not looked into.
std::optional<BlockMap> decode_blockmap(std::string_view bytes);

}  // namespace vicus
