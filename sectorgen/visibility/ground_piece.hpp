#pragma once
#include <array>
#include <cstdint>

#include "city_db/units.hpp"

/// Triangles of ground, and what of them lies between two lines of sight.
namespace vicus {

using Corners = std::array<PlanPoint, 3>;  ///< counter-clockwise

/// Ground of one sector (or of none) below the same houses.
struct GroundPiece {
  Corners corner{};
  std::uint32_t sector = 0;  ///< kNowhere: of none
  std::uint32_t group = 0;   ///< as SightCell::group
};

/// Lines that enter a cell by a side, as walkers over it see its ends: what they pass beyond lies right of the leftmost
/// line and left of the rightmost, or on them.
struct Wedge {
  PlanPoint leftmost_from, leftmost_to, rightmost_from, rightmost_to;
  PlanPoint left_end, right_end;  ///< of the side
};

/// Have the triangles an inner point in common?   Error  none.
bool overlap(const Corners& a, const Corners& b);

/// Do the lines meet the piece in the cell? Touching is enough, as it is for entering the next cell: not where a line
/// turns about an end of the side and has the piece beyond it, on the side to which it cannot turn.
///
/// Needs   lines that enter the cell; the piece has inner points in the cell, and a corner where one of the side's ends
///         touches it; all points within 2^29 mm of each other.
/// Error   none: crossings are compared as fractions of 128 bits, never rounded.
bool meets(const Corners& piece, const Corners& cell, const Wedge& lines);

}  // namespace vicus
