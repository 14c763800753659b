#pragma once
#include <optional>
#include <string>

#include "city_db/city.hpp"

/// Does a roof close its house? Nothing of how roofs are made is used here.
///
/// The house is the footprint as underside, walls over its edges up to the eave, and the facets. Checked:
///   closed      every directed edge of a facet has its opposite once, in another facet or as the top of a wall;
///   planar      no point of a facet is farther than kMostOffPlane_m from the plane through it;
///   no overlap  slopes and tops are simple polygons in plan, counter-clockwise, exact on the lattice; gables rise over
///               one edge of the footprint, seen from outside counter-clockwise, and lean at most kMostLean_mm inwards;
///               steps stand exactly upright, so they cover nothing.
/// That suffices: as all inner edges cancel, the facets' winding numbers add up to the footprint's, 1 inside and 0
/// outside, and none is negative; so each place lies below one facet only.
/// Needs   a valid footprint (simple rings, holes inside).   Error  none but planarity's doubles.
namespace vicus {

inline constexpr double kMostOffPlane_m = 0.001;
inline constexpr double kMostLean_mm = 2;

/// What is wrong first; nullopt: nothing.
std::optional<std::string> fault_of_roof(const Polygon& footprint, double eave_m, const Roof& roof);

/// The largest distance of a facet's points from the plane through them (Newell), metres.
double off_plane_m(const Roof& roof, const RoofFacet& facet);

}  // namespace vicus
