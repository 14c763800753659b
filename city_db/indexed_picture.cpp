#include "city_db/indexed_picture.hpp"

#include <algorithm>
#include <cassert>

namespace vicus {

std::string encode_indexed(const IndexedPicture& picture) {
  assert(!picture.palette.empty() && picture.palette.size() <= 256);
  std::string out(1, static_cast<char>(picture.palette.size() - 1));
  for (const Colour c : picture.palette)
    for (const std::uint8_t v : {c.r, c.g, c.b}) out.push_back(static_cast<char>(v));
  return out + picture.pixels;
}

std::optional<IndexedPicture> decode_indexed(std::string_view bytes, std::size_t pixels) {
  if (bytes.empty()) return std::nullopt;
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); };
  const std::size_t colours = byte(0) + std::size_t{1};
  if (bytes.size() != 1 + 3 * colours + pixels) return std::nullopt;
  IndexedPicture out;
  for (std::size_t i = 0; i < colours; ++i) out.palette.push_back({byte(1 + 3 * i), byte(2 + 3 * i), byte(3 + 3 * i)});
  out.pixels = bytes.substr(1 + 3 * colours);
  const auto is_known = [&](char c) { return static_cast<std::uint8_t>(c) < colours; };
  if (!std::all_of(out.pixels.begin(), out.pixels.end(), is_known)) return std::nullopt;
  return out;
}

}  // namespace vicus
