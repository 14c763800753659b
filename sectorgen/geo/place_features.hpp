#pragma once
#include <vector>

#include "sectorgen/geo/plan_frame.hpp"
#include "sectorgen/geo/raw_map.hpp"
#include "sectorgen/geo/source_map.hpp"

/// From raw features in degrees to valid records on the lattice.
namespace vicus {

/// The centre of the footprints' box (of all features' where there is no footprint), rounded to 1e-5 degrees so that a
/// small edit at the rim keeps it. Where that box is larger than any city, the median position: one lost feature does
/// not move a city.
/// Fails   CityError (exit 4): no feature at all.
LatLon default_origin(const RawMap& raw);

/// Appends every feature to `map`, projected, rounded, repaired (research DESIGN §3: valid by itself). Heights are not
/// set yet. `is_cut[i]` tells whether footprint i is a piece of a house.
void place_features(RawMap raw, const PlanFrame& frame, SourceMap& map, std::vector<bool>& is_cut,
                    std::vector<Issue>& issues);

}  // namespace vicus
