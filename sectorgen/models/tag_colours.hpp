#pragma once
#include <optional>
#include <string_view>

#include "city_db/city.hpp"

/// What colour a house has: from its tags, else from a palette of plaster, tile and slate, steady by id.
namespace vicus {

/// "#abc", "#aabbcc" or a CSS colour name; case, spaces, '_' and '-' are passed over.
std::optional<Colour> parse_colour(std::string_view text);

Colour facade_colour(const Building& building, FacadeStyle style);
Colour roof_colour(const Building& building);

}  // namespace vicus
