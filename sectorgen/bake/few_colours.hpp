#pragma once
#include "city_db/indexed_picture.hpp"
#include "sectorgen/bake/webp_image.hpp"

namespace vicus {

/// The picture in at most `colours` (2 ... 256) colours, dark to light; as it is where it has no more. Equal
/// pictures give equal bytes.
IndexedPicture with_few_colours(const RgbImage& image, int colours);

RgbImage rgb_of(const IndexedPicture& picture, std::uint32_t width, std::uint32_t height);

}  // namespace vicus
