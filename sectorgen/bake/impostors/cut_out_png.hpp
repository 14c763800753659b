#pragma once
#include <span>
#include <string>

#include "sectorgen/bake/picture/picture.hpp"

namespace vicus {

/// Pictures of one height side by side as a PNG with a palette. Where nothing is, the colour of the horizon: it bleeds
/// into the edges of coarser images.
/// Needs   one picture or more (assert).   Fails   CityError: out of memory.
std::string cut_out_png(std::span<const CutOut> pictures, int colours);

}  // namespace vicus
