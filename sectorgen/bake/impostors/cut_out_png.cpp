#include "sectorgen/bake/impostors/cut_out_png.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "city_db/surroundings.hpp"
#include "sectorgen/models/palette_png.hpp"

namespace vicus {

std::string cut_out_png(std::span<const CutOut> pictures, int colours) {
  assert(!pictures.empty());
  const int height = pictures.front().height;
  int width = 0;
  for (const CutOut& picture : pictures) width += picture.width;
  std::vector<unsigned char> rgba;
  rgba.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto byte = [](float v) { return static_cast<unsigned char>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); };
  for (int row = 0; row < height; ++row)
    for (const CutOut& picture : pictures)
      for (int column = 0; column < picture.width; ++column) {
        const Rgba& p = picture.at(column, row);
        if (p[3] < 1.0f / 255)
          rgba.insert(rgba.end(), {kSkyColour.r, kSkyColour.g, kSkyColour.b, 0});
        else
          for (const float v : p) rgba.push_back(byte(v));
      }
  return palette_png(rgba, width, height, colours);
}

}  // namespace vicus
