#include "city_db/gables.hpp"

#include <algorithm>
#include <cmath>

namespace vicus {

std::optional<Gable> gable_of(const Building& house, const RoofFacet& facet) {
  if (facet.kind != FacetKind::gable || facet.rings.size() != 1) return std::nullopt;
  const auto& ring = facet.rings[0];
  const std::size_t n = ring.size();
  const auto eave = static_cast<std::int32_t>(std::lround(house.eave_m * kRoofStepsPerMetre));
  const auto at = [&](std::size_t i) -> const RoofPoint& { return house.roof.points.at(ring[i % n]); };
  for (std::size_t i = 0; i < n; ++i) {
    if (at(i).up != eave || at(i + 1).up != eave || at(i).at == at(i + 1).at) continue;
    Gable gable{at(i).at, at(i + 1).at, {}};
    for (std::size_t k = i + 1; k < i + n; ++k)
      if (at(k).at != at(k + 1).at) gable.rim.emplace_back(at(k), at(k + 1));
    if (gable.rim.empty() || gable.rim.front().first.at != gable.b || gable.rim.back().second.at != gable.a)
      return std::nullopt;
    return gable;
  }
  return std::nullopt;
}

std::optional<RoofStep> step_of(const Building& house, const RoofFacet& facet) {
  if (facet.kind != FacetKind::step || facet.rings.size() != 1) return std::nullopt;
  const auto& ring = facet.rings[0];
  const std::size_t n = ring.size();
  const auto at = [&](std::size_t i) -> const RoofPoint& { return house.roof.points.at(ring[i % n]); };
  // Along the wall, from any of its points; which way is from a to b the turn of the ring tells.
  std::size_t other = 0;
  while (other < n && at(other).at == at(0).at) ++other;
  if (other == n) return std::nullopt;
  double ux = double(at(other).at.x) - at(0).at.x, uy = double(at(other).at.y) - at(0).at.y, twice = 0;
  const auto along = [&](const RoofPoint& p) {
    return (double(p.at.x) - at(0).at.x) * ux + (double(p.at.y) - at(0).at.y) * uy;
  };
  for (std::size_t i = 0; i < n; ++i) twice += along(at(i)) * at(i + 1).up - along(at(i + 1)) * at(i).up;
  if (twice < 0) ux = -ux, uy = -uy;
  const auto is_left = [&](const RoofPoint& p, const RoofPoint& q) { return along(p) < along(q); };
  std::size_t first = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (is_left(at(i), at(first)) || (at(i).at == at(first).at && at(i).up < at(first).up)) first = i;
  RoofStep step{at(first).at, {}, {}, {}};
  for (std::size_t i = first; i < first + n; ++i) {
    const RoofPoint &p = at(i), &q = at(i + 1);
    if (p.at == q.at) continue;
    if (is_left(p, q) && !step.above.empty()) return std::nullopt;  // to the right only before it has turned back
    (is_left(p, q) ? step.below : step.above).emplace_back(p, q);
  }
  if (step.below.empty() || step.above.empty() || step.above.back().second.at != step.a) return std::nullopt;
  step.b = step.below.back().second.at;
  return step;
}

std::pair<double, double> full_wall(const RoofStep& step) {
  std::int32_t low = INT32_MIN, high = INT32_MAX;
  for (const auto& [p, q] : step.below) low = std::max({low, p.up, q.up});
  for (const auto& [p, q] : step.above) high = std::min({high, p.up, q.up});
  // Walls begin and end at whole millimetres.
  return {std::ceil(low / kRoofStepsPerMetre * kMmPerMetre) / kMmPerMetre,
          std::floor(high / kRoofStepsPerMetre * kMmPerMetre) / kMmPerMetre};
}

std::map<std::pair<PlanPoint, PlanPoint>, double> full_walls(const Building& house) {
  std::map<std::pair<PlanPoint, PlanPoint>, double> out;
  for (const RoofFacet& facet : house.roof.facets) {
    const auto gable = gable_of(house, facet);
    if (!gable) continue;
    std::int32_t least = INT32_MAX;
    for (const auto& [p, q] : gable->rim) least = std::min({least, p.up, q.up});
    // Walls end at whole millimetres.
    const double top_m = std::floor(least / kRoofStepsPerMetre * kMmPerMetre) / kMmPerMetre;
    if (top_m > house.eave_m) out.emplace(std::pair(gable->a, gable->b), top_m);
  }
  return out;
}

}  // namespace vicus
