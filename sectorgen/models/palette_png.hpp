#pragma once
#include <span>
#include <string>

#include "city_db/city.hpp"
#include "sectorgen/models/canvas.hpp"

namespace vicus {

/// The picture as a PNG with a palette of at most `colours` (2 ... 256), 1, 2, 4 or 8 bits a pixel. Deterministic.
/// Fails   CityError: out of memory.
/// Source  paper 004 §4.2 (palettes in place of true colour); PNG by the W3C's second edition.
std::string palette_png(const Canvas& picture, int colours);

/// The same as a texture; its id is a hash of the PNG.
Texture palette_texture(const Canvas& picture, int colours);

/// A grey PNG of a byte a pixel, top row first, as a texture. A browser multiplies the colours below by it.
Texture grey_texture(std::span<const unsigned char> grey, int width, int height);

/// The same of 4 bytes a pixel, top row first; the palette has opacities where some pixel has.
/// Needs   4 * width * height bytes (assert).
std::string palette_png(std::span<const unsigned char> rgba, int width, int height, int colours);

}  // namespace vicus
