#pragma once
#include "city_db/city.hpp"

namespace vicus {

/// What the ground of a kind looks like, in walked sectors and in tiles seen from the air alike.
Colour surface_colour(SurfaceKind kind);
/// The same of a sector without surfaces.
Colour ground_colour(SectorKind kind);

}  // namespace vicus
