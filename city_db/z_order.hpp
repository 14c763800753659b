#pragma once
#include <cstdint>

#include "city_db/city.hpp"

namespace vicus {

/// Place along Morton's curve: what follows each other in it is mostly near. Needs   |x|, |y| < 2^30.
inline std::uint64_t z_order(PlanPoint p) {
  const auto spread = [](std::uint64_t v) {
    std::uint64_t out = 0;
    for (int bit = 0; bit < 32; ++bit) out |= (v >> bit & 1) << (2 * bit);
    return out;
  };
  const auto shifted = [](std::int32_t v) { return static_cast<std::uint64_t>(std::int64_t{v} + (1 << 30)); };
  return spread(shifted(p.x)) | spread(shifted(p.y)) << 1;
}

}  // namespace vicus
