#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "city_db/city.hpp"

/// What colour a thing has: from its tags, else from a palette of plaster, tile and slate, steady by id.
namespace vicus {

/// sRGB.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  friend auto operator<=>(const Colour&, const Colour&) = default;
};

/// "#abc", "#aabbcc" or a CSS colour name; case, spaces, '_' and '-' are passed over.
std::optional<Colour> parse_colour(std::string_view text);
/// "#rrggbb". parse_colour(hex_of(c)) == c.
std::string hex_of(Colour colour);

Colour facade_colour(const Building& building);
Colour roof_colour(const Building& building);
Colour ground_colour(SectorKind kind);

inline constexpr Colour kWallColour{150, 140, 126};
inline constexpr Colour kFenceColour{96, 88, 76};
inline constexpr Colour kParapetColour{170, 166, 156};
/// At the horizon; the backdrop of end-of-city gates has it too, so that the city seems to end in haze.
inline constexpr Colour kSkyColour{196, 213, 228};

}  // namespace vicus
