#pragma once
#include "city_db/city.hpp"
#include "city_db/colour.hpp"
#include "city_db/surface_colour.hpp"

/// Colours of what is no house: houses have theirs in the city file.
namespace vicus {

/// Each channel times k >= 0, at most 255.
Colour shaded(Colour c, double k);

inline constexpr Colour kWallColour{150, 140, 126};
inline constexpr Colour kFenceColour{96, 88, 76};
inline constexpr Colour kParapetColour{170, 166, 156};

}  // namespace vicus
