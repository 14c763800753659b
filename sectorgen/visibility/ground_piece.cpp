#include "sectorgen/visibility/ground_piece.hpp"

#include <algorithm>
#include <cstddef>

#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

/// A share of a segment, from 0 at its begin to 1 at its end.
struct Share {
  Int128 part = 0, whole = 1;
  bool operator<(const Share& other) const { return part * other.whole < other.part * whole; }
};

/// What half-planes leave of a segment.
struct Stretch {
  Share low{0, 1}, high{1, 1};
  bool is_gone = false;

  /// Keeps where a value that runs evenly from one end's to the other's is not negative.
  void keep(std::int64_t begin, std::int64_t end) {
    if (begin >= 0 && end >= 0) return;
    if (begin < 0 && end < 0) {
      is_gone = true;
      return;
    }
    const Int128 from = begin < 0 ? -Int128{begin} : begin, to = end < 0 ? -Int128{end} : end;
    const Share zero{from, from + to};
    if (begin < 0)
      low = std::max(low, zero);
    else
      high = std::min(high, zero);
  }
  bool is_empty() const { return is_gone || high < low; }
};

constexpr std::size_t kHalfPlanes = 5;
using Values = std::array<std::int64_t, kHalfPlanes>;

/// Not negative: inside. First the wedge's two, then the cell's three.
Values values_at(PlanPoint p, const Corners& cell, const Wedge& wedge) {
  return {orient(wedge.leftmost_to, wedge.leftmost_from, p), orient(wedge.rightmost_from, wedge.rightmost_to, p),
          orient(cell[0], cell[1], p), orient(cell[1], cell[2], p), orient(cell[2], cell[0], p)};
}

bool are_apart(const std::array<Values, 3>& at) {
  for (std::size_t h = 0; h < kHalfPlanes; ++h)
    if (at[0][h] < 0 && at[1][h] < 0 && at[2][h] < 0) return true;
  return false;
}

/// Is that place of the segment ab in the piece?
bool holds(const Corners& piece, PlanPoint a, PlanPoint b, const Share& share) {
  for (std::size_t k = 0; k < 3; ++k) {
    const PlanPoint from = piece[k], to = piece[(k + 1) % 3];
    if (orient(from, to, a) * (share.whole - share.part) + orient(from, to, b) * share.part < 0) return false;
  }
  return true;
}

/// No side of the piece is met: so the wedge's part of the cell is within the piece, or wholly without; one point
/// tells.
bool holds_a_point(const Corners& piece, const Corners& cell, const Wedge& wedge) {
  std::array<Values, 3> at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = values_at(cell[k], cell, wedge);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    Stretch stretch;
    for (std::size_t h = 0; h < 2; ++h) stretch.keep(at[k][h], at[next][h]);
    if (!stretch.is_empty()) return holds(piece, cell[k], cell[next], stretch.low);
  }
  return false;
}

/// Beyond the line all but one corner of the piece, which is the turning point.
bool turns_away(const Corners& piece, PlanPoint turn, PlanPoint from, PlanPoint to, int side) {
  if (orient(from, to, turn) != 0) return false;
  std::size_t beyond = 0;
  bool has_turn = false;
  for (const PlanPoint p : piece) {
    const std::int64_t at = orient(from, to, p);
    beyond += side > 0 ? at > 0 : at < 0;
    has_turn |= p == turn;
  }
  return has_turn && beyond == 2;
}

/// All of b lies beyond a side of a, or on it.
bool is_beyond_a_side(const Corners& a, const Corners& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const PlanPoint from = a[k], to = a[(k + 1) % 3];
    if (orient(from, to, b[0]) <= 0 && orient(from, to, b[1]) <= 0 && orient(from, to, b[2]) <= 0) return true;
  }
  return false;
}

/// Boxes without a common inner point: the quick answer to most questions.
bool are_boxes_apart(const Corners& a, const Corners& b) {
  const auto [a_west, a_east] = std::minmax({a[0].x, a[1].x, a[2].x});
  const auto [b_west, b_east] = std::minmax({b[0].x, b[1].x, b[2].x});
  if (a_east <= b_west || b_east <= a_west) return true;
  const auto [a_south, a_north] = std::minmax({a[0].y, a[1].y, a[2].y});
  const auto [b_south, b_north] = std::minmax({b[0].y, b[1].y, b[2].y});
  return a_north <= b_south || b_north <= a_south;
}

}  // namespace

bool overlap(const Corners& a, const Corners& b) {
  return !are_boxes_apart(a, b) && !is_beyond_a_side(a, b) && !is_beyond_a_side(b, a);
}

bool meets(const Corners& piece, const Corners& cell, const Wedge& wedge) {
  if (turns_away(piece, wedge.right_end, wedge.rightmost_from, wedge.rightmost_to, -1) ||
      turns_away(piece, wedge.left_end, wedge.leftmost_from, wedge.leftmost_to, 1))
    return false;
  std::array<Values, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = values_at(piece[k], cell, wedge);
    if (std::all_of(at[k].begin(), at[k].end(), [](std::int64_t v) { return v >= 0; })) return true;
  }
  if (are_apart(at)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    Stretch stretch;
    for (std::size_t h = 0; h < kHalfPlanes && !stretch.is_gone; ++h) stretch.keep(at[k][h], at[(k + 1) % 3][h]);
    if (!stretch.is_empty()) return true;
  }
  return holds_a_point(piece, cell, wedge);
}

}  // namespace vicus
