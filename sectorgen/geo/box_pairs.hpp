#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "city_db/units.hpp"

namespace vicus {

/// Pairs (i, j), i < j, of boxes that overlap or touch when each is grown by half of `margin_mm`; sorted by j, then i.
/// Cost    n log n and the boxes that share an x: fine for houses, quadratic for boxes as wide as the city.
std::vector<std::pair<std::uint32_t, std::uint32_t>> box_pairs(const std::vector<PlanBox>& boxes,
                                                               std::int32_t margin_mm);

/// The same between two lists: (index in a, index in b), sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> box_pairs(const std::vector<PlanBox>& a,
                                                               const std::vector<PlanBox>& b);

}  // namespace vicus
