#pragma once
#include "city_db/city.hpp"

namespace vicus {

/// Grain of stone and asphalt (city_db/ground_grain.hpp): grey, 128 x 128, meets itself at its rims, no direction, no
/// pattern; mean kGrainMean. Deterministic.   Cost    about 7 kB.
Texture paint_grain();

}  // namespace vicus
