#pragma once
#include <string>

#include "sectorgen/bake/picture/picture.hpp"

namespace vicus {

/// 8 bits a channel, no time or text in it: equal pictures are equal bytes.
/// Fails   CityError: out of memory.
std::string png_text(const Picture& picture);

/// Any PNG.
/// Fails   CityError: no PNG, or one of more than 2^26 pixels.
CutOut read_png(const std::string& bytes);

}  // namespace vicus
