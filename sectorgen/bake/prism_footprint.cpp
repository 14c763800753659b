#include "sectorgen/bake/prism_footprint.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/segment.hpp"

namespace vicus {
namespace {

/// Douglas and Peucker between two corners that stay; `last` may go round the ring's end, and is left to the caller.
void append_simplified(const Ring& ring, std::size_t first, std::size_t last, double tolerance_mm,
                       std::vector<std::size_t>& out) {
  std::size_t farthest = first;
  double distance = tolerance_mm;
  const auto at = [&](std::size_t i) { return ring[i % ring.size()]; };
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double d = distance_to_segment_mm(at(i), at(first), at(last)); d > distance) farthest = i, distance = d;
  if (farthest == first) {
    out.push_back(first % ring.size());
    return;
  }
  append_simplified(ring, first, farthest, tolerance_mm, out);
  append_simplified(ring, farthest, last, tolerance_mm, out);
}

}  // namespace

std::vector<std::size_t> simplified_ring(const Ring& ring, double tolerance_mm, const std::vector<bool>& forced) {
  const auto lowest = static_cast<std::size_t>(std::min_element(ring.begin(), ring.end()) - ring.begin());
  std::size_t farthest = lowest;
  double most = -1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double d = std::hypot(double(ring[i].x) - ring[lowest].x, double(ring[i].y) - ring[lowest].y);
    if (d > most) most = d, farthest = i;
  }
  std::vector<std::size_t> stay{lowest, farthest};
  for (std::size_t i = 0; i < forced.size(); ++i)
    if (forced[i]) stay.push_back(i);
  std::sort(stay.begin(), stay.end());
  stay.erase(std::unique(stay.begin(), stay.end()), stay.end());
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < stay.size(); ++k)
    append_simplified(ring, stay[k], k + 1 < stay.size() ? stay[k + 1] : stay[0] + ring.size(), tolerance_mm, out);
  return out;
}

PlanPoint steps_from(PlanPoint p, PlanPoint corner, std::int64_t step_mm) {
  const auto rounded = [&](std::int64_t v) {
    return static_cast<std::int64_t>(std::floor(double(v) / double(step_mm) + 0.5));
  };
  return {static_cast<std::int32_t>(rounded(p.x) - rounded(corner.x)),
          static_cast<std::int32_t>(rounded(p.y) - rounded(corner.y))};
}

double doubled_area(const std::vector<PlanPoint>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += double(a.x) * b.y - double(a.y) * b.x;
  }
  return sum;
}

std::vector<std::vector<PlanPoint>> rounded_rings(const Polygon& footprint, PlanPoint corner, std::int64_t step_mm) {
  std::vector<std::vector<PlanPoint>> out;
  const auto add = [&](const Ring& ring) {
    std::vector<PlanPoint> points;
    for (const std::size_t i : simplified_ring(ring, double(step_mm) / 2, {})) {
      const PlanPoint q = steps_from(ring[i], corner, step_mm);
      if (points.empty() || points.back() != q) points.push_back(q);
    }
    while (points.size() > 1 && points.front() == points.back()) points.pop_back();
    if (points.size() >= 3 && doubled_area(points) != 0) out.push_back(std::move(points));
    return !out.empty();
  };
  if (!add(footprint.outer)) return out;
  for (const auto& hole : footprint.holes) add(hole);
  return out;
}

}  // namespace vicus
