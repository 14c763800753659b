#pragma once
#include "city_db/prism_tile.hpp"
#include "sectorgen/bake/bake_scene.hpp"

namespace vicus {

/// Makes a house faceted: its rings, points, facets, eave and rise are those of its own roof, rounded to steps. False,
/// and nothing changed: it has no roof that is closed with its walls once it is rounded.
///
/// Facets are cut into fans (of a convex one: itself). Corners of the footprint that lie within half a step of the line
/// between their neighbours and where no other facet begins are dropped.
///
/// Error   each point of a fan is as far from the facet as the corners around it were moved, at most: 1.25 steps in
///         plan, half a step of height. The triangles are the true ones' images, so this holds in both directions.
bool set_own_roof(const BakeHouse& house, PlanPoint corner, std::uint32_t step_mm, std::uint32_t up_step_mm,
                  PrismHouse& prism);

}  // namespace vicus
