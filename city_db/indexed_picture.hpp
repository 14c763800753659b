#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/colour.hpp"

/// A picture of few colours: a palette and a byte a pixel. What is sent is packed by its content coding (FORMAT.md).
namespace vicus {

struct IndexedPicture {
  std::vector<Colour> palette;  ///< 1 ... 256
  std::string pixels;           ///< a byte each
  friend bool operator==(const IndexedPicture&, const IndexedPicture&) = default;
};

/// Number of colours less 1, then 3 bytes a colour, then a byte a pixel.   Needs   1 ... 256 colours (assert).
std::string encode_indexed(const IndexedPicture& picture);
/// Of hostile bytes; nullopt for what encode_indexed cannot have made of so many pixels.
std::optional<IndexedPicture> decode_indexed(std::string_view bytes, std::size_t pixels);

}  // namespace vicus
