#pragma once
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "city_db/city.hpp"

/// What stands upright in a roof: over the edges of a footprint above the eave, and between its own parts.
namespace vicus {

/// A gable: over a -> b, an edge of the footprint, house on the left; its upper rim from b back to a, upright parts
/// left out: pieces from .first to .second, each over a piece of the edge.
struct Gable {
  PlanPoint a, b;
  std::vector<std::pair<RoofPoint, RoofPoint>> rim;
};
/// Nothing: no gable, or one that does not stand on the eave in one edge.
std::optional<Gable> gable_of(const Building& house, const RoofFacet& facet);

/// A wall between a low part of a roof and a high one, from a to b as seen over the low part; its lower rim from a to
/// b, its upper rim from b back to a, upright parts left out.
struct RoofStep {
  PlanPoint a, b;
  std::vector<std::pair<RoofPoint, RoofPoint>> below, above;
};
/// Nothing: no step, or one whose rims run to and fro.
std::optional<RoofStep> step_of(const Building& house, const RoofFacet& facet);

/// Where all of a step's wall stands between two heights: the full rectangle in it, metres above the house's ground;
/// first >= second: there is none.
std::pair<double, double> full_wall(const RoofStep& step);

/// Up to where, metres above ground, the wall over an edge of the footprint is a full rectangle; only edges where that
/// is above the eave.
std::map<std::pair<PlanPoint, PlanPoint>, double> full_walls(const Building& house);

}  // namespace vicus
