#pragma once
#include "city_db/blockmap.hpp"
#include "sectorgen/bake/cast_hit.hpp"

namespace vicus {

/// The nearest hit of a ray with a tile, by looking at every cell on its way: slow, obvious, in double, written from
/// blockmap.hpp's description of the surface alone. What the fast caster and the shader are held against.
CastHit raycast_reference(const BlockMap& map, const PlanRay& ray);

}  // namespace vicus
