#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/colour.hpp"

/// Pictures as WebP, by libwebp.
namespace vicus {

/// sRGB, the top row first.
struct RgbImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
  RgbImage() = default;
  RgbImage(std::uint32_t w, std::uint32_t h) : width(w), height(h), rgb(std::size_t{3} * w * h) {}
  Colour at(std::size_t column, std::size_t row) const {
    const auto* p = &rgb[3 * (row * width + column)];
    return {p[0], p[1], p[2]};
  }
  void set(std::size_t column, std::size_t row, Colour c) {
    auto* p = &rgb[3 * (row * width + column)];
    p[0] = c.r, p[1] = c.g, p[2] = c.b;
  }
};

/// quality 0 ... 100; over 100: lossless. Equal pictures give equal bytes.
/// Fails   CityError: out of memory, or a side of more than 16383.
std::string encode_webp(const RgbImage& image, int quality);
inline constexpr int kLossless = 101;

/// Of hostile bytes: nullopt for what is no WebP of exactly this size.
std::optional<RgbImage> decode_webp(std::string_view bytes, std::uint32_t width, std::uint32_t height);

}  // namespace vicus
