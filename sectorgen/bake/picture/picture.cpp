#include "sectorgen/bake/picture/picture.hpp"

#include <bit>
#include <cstdint>

namespace vicus {

std::string pfm_text(const DepthMap& depth) {
  std::string out = "Pf\n" + std::to_string(depth.width) + " " + std::to_string(depth.height) + "\n-1.0\n";
  for (int row = depth.height - 1; row >= 0; --row)
    for (int column = 0; column < depth.width; ++column) {
      const auto bits = std::bit_cast<std::uint32_t>(depth.at(column, row));
      for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>((bits >> shift) & 0xff));
    }
  return out;
}

CutOut opaque(const Picture& picture) {
  CutOut out(picture.width, picture.height);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const Rgb& p = picture.pixels[i];
    out.pixels[i] = {p[0], p[1], p[2], 1};
  }
  return out;
}

Picture colours_of(const CutOut& picture) {
  Picture out(picture.width, picture.height);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const Rgba& p = picture.pixels[i];
    out.pixels[i] = {p[0], p[1], p[2]};
  }
  return out;
}

}  // namespace vicus
