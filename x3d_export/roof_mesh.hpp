#pragma once
#include <functional>
#include <optional>
#include <utility>

#include "x3d_export/mesh.hpp"

/// A house's roof as faces.
namespace vicus {

/// Top of the facade over an edge of the footprint (house on the left), metres above ground; below the eave: none
/// there.
using WallTop = std::function<double(PlanPoint a, PlanPoint b)>;

/// Bottom and top of the facade on a step between parts of the roof, a to b as seen from outside; nothing: none.
using StepWall = std::function<std::optional<std::pair<double, double>>(PlanPoint a, PlanPoint b)>;

/// The facets, seen from outside: slopes and tops in the roof's colour, gables and steps in the facade's; of a gable
/// into which a facade reaches only what is above that, of a step with a facade what is above and below.
void add_roof(FaceList& faces, const Building& house, const WallTop& facade_top = {}, const StepWall& step_wall = {});

/// The footprint at base_m, seen from below. Taken from the roof: its slopes and tops lie side by side in plan and
/// cover the footprint.
void add_underside(FaceList& faces, const Building& house);

}  // namespace vicus
