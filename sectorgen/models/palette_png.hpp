#pragma once
#include <string>

#include "sectorgen/models/canvas.hpp"

namespace vicus {

/// The picture as a PNG with a palette of at most `colours` (2 ... 256), 1, 2, 4 or 8 bits a pixel. Deterministic.
/// Fails   CityError: out of memory.
/// Source  paper 004 §4.2 (palettes in place of true colour); PNG by the W3C's second edition.
std::string palette_png(const Canvas& picture, int colours);

}  // namespace vicus
