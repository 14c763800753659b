#pragma once
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "city_db/city.hpp"

/// What stands over the edges of a footprint above the eave.
namespace vicus {

/// A gable: over a -> b, an edge of the footprint, house on the left; its upper rim from b back to a, upright parts
/// left out: pieces from .first to .second, each over a piece of the edge.
struct Gable {
  PlanPoint a, b;
  std::vector<std::pair<RoofPoint, RoofPoint>> rim;
};
/// Nothing: no gable, or one that does not stand on the eave in one edge.
std::optional<Gable> gable_of(const Building& house, const RoofFacet& facet);

/// Up to where, metres above ground, the wall over an edge of the footprint is a full rectangle; only edges where that
/// is above the eave.
std::map<std::pair<PlanPoint, PlanPoint>, double> full_walls(const Building& house);

}  // namespace vicus
