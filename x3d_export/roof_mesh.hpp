#pragma once
#include "x3d_export/mesh.hpp"

/// A house's roof as faces.
namespace vicus {

/// The facets, seen from outside: slopes and tops in the roof's colour, gables in the facade's.
void add_roof(FaceList& faces, const Building& house);

/// The footprint at base_m, seen from below. Taken from the roof: its slopes and tops lie side by side in plan and
/// cover the footprint.
void add_underside(FaceList& faces, const Building& house);

}  // namespace vicus
