#pragma once
#include "city_db/city.hpp"

namespace vicus {

/// A gate's line as one straight opening: from its left end to its right end, seen from its own sector.
struct GateWindow {
  PlanPoint left, right;
};
GateWindow window_of(const Gate& gate);

/// m that an eye keeps from the edge of the ground: a visitor's radius.
inline constexpr double kKeepOff_m = 0.25;

/// Where a picture of what lies beyond the gate is taken: of all places in the sector that see the whole gate over
/// walkable ground, and not from its side, the farthest. `share` of the way from the gate to there.
///
/// Places looked at: the corners of the ground, moved inwards, and the middles of its triangles. Where none sees the
/// whole gate: before the gate's middle, as far as there is ground.
/// Source  paper 004 §4.1.7: "the most distant position within a sector and oriented toward a gate".
PlanPoint capture_point(const Sector& sector, const Gate& gate, double share = 1);

}  // namespace vicus
