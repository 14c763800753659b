#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vicus::measure {

/// Cost and error of something; less of both is better.
using CostError = std::pair<double, double>;

/// Indices of the points that no other point beats: none has less of one and no more of the other. By rising cost; of
/// equal points the first.
std::vector<std::size_t> pareto_front(const std::vector<CostError>& points);

/// The cost at which a sweep comes down to an error: straight between neighbouring points of the sweep's own front, in
/// the logarithm of the cost. nullopt: the sweep has no point at or below it, or begins below it (no cost is known for
/// more error).   Needs   costs > 0.
std::optional<double> cost_at(const std::vector<CostError>& sweep, double error);

}  // namespace vicus::measure
