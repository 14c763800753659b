#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/visibility/ground_piece.hpp"

/// Lines of sight, all at once that pass the same sides. Only orientations of the map's own points.
namespace vicus {

/// One of the two chains that bound a bundle of lines: the points at its front are nearest to where it began.
struct Chain {
  std::vector<PlanPoint> points;
  std::size_t first = 0;

  void start(PlanPoint p) {
    points.assign(1, p);
    first = 0;
  }
  PlanPoint front() const { return points[first]; }
  PlanPoint back() const { return points.back(); }
  std::size_t size() const { return points.size() - first; }
  PlanPoint second() const { return points[first + 1]; }
  PlanPoint last_but_one() const { return points[points.size() - 2]; }
};

/// All lines through the sides entered so far. Every line has the left chain on its left and the right chain on its
/// right; the outermost two run from the right chain's front to the left chain's back, and the other way round.
///
///          l2 ---- r2        left  chain: l0 l2          \ leftmost line: r0 -> l2
///         /         \        right chain: r0 r2          / rightmost line: l0 -> r2
///       l0 --------- r0
struct Bundle {
  Chain left, right;

  /// The lines beyond the side with these ends, which they pass.
  Wedge beyond(PlanPoint left_end, PlanPoint right_end) const {
    return {right.front(), left.back(), left.front(), right.back(), left_end, right_end};
  }

  std::int64_t beyond_leftmost(PlanPoint p) const { return orient(right.front(), left.back(), p); }  // > 0: left of it
  std::int64_t beyond_rightmost(PlanPoint p) const {
    return orient(left.front(), right.back(), p);
  }  // < 0: right of it

  /// Only one line is left: the outermost two are the same.
  bool is_line() const { return beyond_leftmost(right.back()) == 0 && beyond_leftmost(left.front()) == 0; }

  /// p is to be on the left of every line from now on.
  void narrow_left(PlanPoint p) {
    while (left.size() >= 2 && orient(left.last_but_one(), left.back(), p) <= 0) left.points.pop_back();
    left.points.push_back(p);
    while (right.size() >= 2 && orient(right.front(), p, right.second()) >= 0) ++right.first;
  }
  void narrow_right(PlanPoint p) {
    while (right.size() >= 2 && orient(right.last_but_one(), right.back(), p) >= 0) right.points.pop_back();
    right.points.push_back(p);
    while (left.size() >= 2 && orient(left.front(), p, left.second()) <= 0) ++left.first;
  }
};

}  // namespace vicus
