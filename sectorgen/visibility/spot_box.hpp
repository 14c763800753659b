#pragma once
#include <cmath>

#include "sectorgen/visibility/roof_shape.hpp"

namespace vicus {

/// The lattice's box around a box in metres.
inline PlanBox box_around(Spot low, Spot high) {
  const auto down = [](double m) { return static_cast<std::int32_t>(std::floor(m * kMmPerMetre)); };
  const auto up = [](double m) { return static_cast<std::int32_t>(std::ceil(m * kMmPerMetre)); };
  return {{down(low.x), down(low.y)}, {up(high.x), up(high.y)}};
}

}  // namespace vicus
