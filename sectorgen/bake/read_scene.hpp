#pragma once
#include "city_db/store.hpp"
#include "sectorgen/bake/bake_scene.hpp"

namespace vicus {

/// What a tile of this box is baked from, out of a city file.
/// Error   none: tiles are equal to the last byte, but for the key, to those of the whole city.
/// Fails   CityError as CityReader does.
BakeScene read_scene(const CityReader& reader, const PlanBox& box);

}  // namespace vicus
