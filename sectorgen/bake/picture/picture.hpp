#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// Pictures of a city and what goes with each pixel.
namespace vicus {

/// Values of one pixel, sRGB as browsers show and blend them (not linear light), 0 ... 1.
using Rgb = std::array<float, 3>;

/// Top row first.
template <class Value>
struct PixelGrid {
  int width = 0, height = 0;
  std::vector<Value> pixels;

  PixelGrid() = default;
  PixelGrid(int w, int h, Value value = {})
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  Value& at(int column, int row) { return pixels[index(column, row)]; }
  const Value& at(int column, int row) const { return pixels[index(column, row)]; }
  friend bool operator==(const PixelGrid&, const PixelGrid&) = default;
};

using Picture = PixelGrid<Rgb>;
/// Colours not weighted by the fourth value, their opacity.
using Rgba = std::array<float, 4>;
using CutOut = PixelGrid<Rgba>;
/// Share of each pixel that is not sky, 0 ... 1.
using Coverage = PixelGrid<float>;
/// Metres before the eye, along the direction it looks in, of what the middle of each pixel shows; infinity: sky.
using DepthMap = PixelGrid<float>;

/// As portable float map (PFM, little-endian, bottom row first): exact, and read by most tools.
std::string pfm_text(const DepthMap& depth);

CutOut opaque(const Picture& picture);
/// Without what shines through.
Picture colours_of(const CutOut& picture);

/// The part of `width` x `height` pixels whose top left pixel is (column, row).   Needs  it lies in the picture.
template <class Value>
PixelGrid<Value> crop(const PixelGrid<Value>& from, int column, int row, int width, int height) {
  PixelGrid<Value> out(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out.at(x, y) = from.at(column + x, row + y);
  return out;
}

}  // namespace vicus
