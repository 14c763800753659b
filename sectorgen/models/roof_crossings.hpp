#pragma once
#include <vector>

#include "sectorgen/models/plan_cover.hpp"

namespace vicus {

/// Where faces of the model pass through each other although no edge of theirs lies there: lines to cut the plan along,
/// one across each inner edge above which two faces change places by more than `least_m` on both sides. Cut there, the
/// two meet in a point of the edge.
std::vector<Segment> crossing_cuts(const PlanCover& cover, double least_m);

/// A lozenge of `radius_mm` round a point.
std::vector<Segment> lozenge(PlanPoint middle, std::int32_t radius_mm);

}  // namespace vicus
