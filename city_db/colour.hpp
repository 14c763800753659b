#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vicus {

/// sRGB.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  friend auto operator<=>(const Colour&, const Colour&) = default;
};

constexpr Colour colour_of(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)};
}

/// sRGB's curve, both ways, 0 ... 1.   Source  IEC 61966-2-1.
double linear_of_srgb(double v);
double srgb_of_linear(double v);

/// "#rrggbb".
std::string hex_of(Colour colour);
/// "#rgb" or "#rrggbb", small letters; nullopt for anything else. colour_from_hex(hex_of(c)) == c.
std::optional<Colour> colour_from_hex(std::string_view text);

}  // namespace vicus
