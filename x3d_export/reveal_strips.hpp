#pragma once
#include <cstdint>
#include <vector>

#include "city_db/facade_layout.hpp"

/// The sides of openings set into a facade, as few faces as show the same.
///
/// All openings of a facade have one depth, and the wall hides what is behind it: sides that lie in one plane may be
/// one face, which runs on behind the wall from opening to opening. Only where it would come out in the middle of
/// another opening must it end.
namespace vicus {

/// Along the facade (or up it) from `from` to `to`, at the height (or place) `at`; mm in the facade's own frame.
struct RevealStrip {
  std::int32_t at = 0, from = 0, to = 0;
  bool operator==(const RevealStrip&) const = default;
};

struct RevealStrips {
  std::vector<RevealStrip> left, right;  ///< upright: openings' x0 and x1, from z to z
  std::vector<RevealStrip> sill, head;   ///< level: openings' z0 and z1, from x to x
};

/// Each side of each opening lies in a strip of its kind, and no strip crosses the inside of an opening.
/// Order   by place, then from below or left: the same for the same openings in any order.
/// Cost    O(n log n + s n) for n openings, s strips before they end at others.
RevealStrips reveal_strips(const std::vector<Opening>& openings);

}  // namespace vicus
