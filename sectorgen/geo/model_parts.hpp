#pragma once
#include <vector>

#include "sectorgen/geo/city_model.hpp"

/// What the surfaces of one modelled house make together.
/// Needs   coordinates in metres, rings of three corners and more.
namespace vicus {

/// Newell's normal, of unit length; zero for what has no area.
ModelCorner unit_normal(const ModelSurface& surface);

/// One window or door, however many surfaces it has.
struct SurfaceGroup {
  bool is_door = false;
  std::vector<ModelCorner> corners;
};

/// Surfaces of the same element whose boxes meet within 15 cm are one opening: CityJSON may have one element for many
/// windows. What looks up or down steeply (roof windows, doors of cellars) is none of a facade's and left out.
std::vector<SurfaceGroup> opening_groups(const ModelObject& object);

/// building:colour and roof:colour where the tags have none: of the materials, the one with the largest area. Plain
/// grey from white to half is what programs write where nobody chose a colour, and passed over.
void add_colours(const ModelObject& object, Tags& tags);

}  // namespace vicus
