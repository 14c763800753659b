#pragma once
#include <vector>

#include "city_db/city.hpp"
#include "x3d_export/colours.hpp"

/// What stands on the ground by itself (trees, lamps, fountains, benches, statues), as prisms and cones.
namespace vicus {

/// One piece of an object: as FaceList::add_spindle draws it, around the object's place.
struct Spindle {
  int sides;
  double radius_low_m, radius_high_m, low_m, high_m;
  Colour colour;
};

/// From the ground upwards; empty for a kind that is not drawn. Sizes typical of the kind where the map names none.
std::vector<Spindle> spindles_of(const StandaloneObject& object);

/// The same of few triangles, for who is far; empty for what is too small to be seen from there.
std::vector<Spindle> far_spindles_of(const StandaloneObject& object);

/// Radius of the disc that a visitor cannot enter: the widest the object is between his shin and the top of his head.
/// 0: nothing is in his way.
double body_radius_m(const StandaloneObject& object);

}  // namespace vicus
