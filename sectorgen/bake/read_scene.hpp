#pragma once
#include "city_db/store.hpp"
#include "sectorgen/bake/bake_scene.hpp"

namespace vicus {

/// What a tile of this box is baked from, out of a city file.
/// Error   seen in Rochechouart against the bake of the whole city: tiles of 128 m are equal but for the key, one of
/// 1024 m had
///         other bytes in its pictures. Why is not known yet; the order of the ground's triangles may be the reason.
/// Fails   CityError as CityReader does.
BakeScene read_scene(const CityReader& reader, const PlanBox& box);

}  // namespace vicus
