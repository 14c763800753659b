#pragma once
#include <utility>
#include <vector>

#include "sectorgen/models/roof_build.hpp"

/// Roofs without a wavefront: one plane, and rings that shrink towards a point.
namespace vicus {

/// One plane through the footprint, its lowest point at the eave; gables below its other edges.
Roof skillion_roof(const Polygon& footprint, double eave_m, const RoofRequest& request);

/// How far the footprint has shrunk (1 to 0), and the share of the rise there.
using FanProfile = std::vector<std::pair<double, double>>;
/// Of pyramidal, cone, dome and onion; empty for others.
/// Differs an onion bulges out over its walls; ours stays within the footprint, or the roof would hang over the street.
FanProfile fan_profile(RoofForm form);

/// Triangles between rings around `centre`.   Needs  the whole footprint is seen from there.
Roof fan_roof(const Polygon& footprint, PlanPoint centre, double eave_m, double rise_m, const FanProfile& profile);

/// Metres above ground of the highest point.
double top_of(const Roof& roof);

}  // namespace vicus
