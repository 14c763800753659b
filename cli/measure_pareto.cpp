#include "cli/measure_pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vicus::measure {

std::vector<std::size_t> pareto_front(const std::vector<CostError>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order)
    if (points[i].second < least) {
      least = points[i].second;
      front.push_back(i);
    }
  return front;
}

std::optional<double> cost_at(const std::vector<CostError>& sweep, double error) {
  const auto front = pareto_front(sweep);
  for (std::size_t k = 0; k < front.size(); ++k) {
    const CostError& fine = sweep[front[k]];
    if (fine.second == error) return fine.first;
    if (fine.second > error) continue;
    if (k == 0) return std::nullopt;
    const CostError& coarse = sweep[front[k - 1]];
    const double share = (coarse.second - error) / (coarse.second - fine.second);
    return std::exp(std::lerp(std::log(coarse.first), std::log(fine.first), share));
  }
  return std::nullopt;
}

}  // namespace vicus::measure
