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
