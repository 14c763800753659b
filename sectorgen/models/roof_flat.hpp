#pragma once
#include "city_db/city.hpp"

/// The roof that any footprint can have, and the triangles of facets.
namespace vicus {

/// Height above ground as a roof stores it.
std::int32_t roof_steps(double up_m);

/// One level facet over the footprint.
Roof flat_roof(const Polygon& footprint, double up_m);

/// Gives every facet its triangles: slopes and tops in plan, gables seen from outside.
/// Needs   facets' rings simple where they are looked at from there (solid_check.hpp).
void triangulate_facets(Roof& roof);

}  // namespace vicus
