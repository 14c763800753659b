#pragma once
#include <utility>
#include <vector>

#include "city_db/units.hpp"

namespace vicus {

/// Directed edges as lines, each as long as one edge goes on where another ends. A closed line begins at a corner, and
/// has its first point again as its last; where more than one edge goes on from a point, lines end there.
/// Every edge is in exactly one line.
std::vector<std::vector<PlanPoint>> joined_lines(const std::vector<std::pair<PlanPoint, PlanPoint>>& edges);

}  // namespace vicus
