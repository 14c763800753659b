#pragma once
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/mesh.hpp"

/// The geometry of one sector: ground, houses as prisms, barriers, objects, the end of the city.
namespace vicus {

enum class Detail { near, far, tall };

/// One layer per material that the sector has, never an empty one, at most five.
/// near: without the facades that come with levels of detail (house_nodes.hpp).
/// Frame   the sector's own.
/// far: one layer, houses and ground only, facade lines simplified by at most kFarTolerance.
/// tall: of far, only what belongs to houses that some other sector sees over roofs; no layer where there are none.
std::vector<Layer> sector_layers(const CityIndex& index, const Sector& sector, Detail detail);

/// Facades of far and tall sectors may leave out corners that stand out by no more than this: 0.3 m at 200 m is one
/// pixel of a 640-pixel window.
inline constexpr double kFarTolerance_mm = 300;

}  // namespace vicus
