#pragma once
#include <functional>

#include "x3d_export/mesh.hpp"

/// A house's roof as faces.
namespace vicus {

/// Top of the facade over an edge of the footprint (house on the left), metres above ground; below the eave: none
/// there.
using WallTop = std::function<double(PlanPoint a, PlanPoint b)>;

/// The facets, seen from outside: slopes and tops in the roof's colour, gables in the facade's; of a gable into which a
/// facade reaches only what is above that.
void add_roof(FaceList& faces, const Building& house, const WallTop& facade_top = {});

/// The footprint at base_m, seen from below. Taken from the roof: its slopes and tops lie side by side in plan and
/// cover the footprint.
void add_underside(FaceList& faces, const Building& house);

}  // namespace vicus
