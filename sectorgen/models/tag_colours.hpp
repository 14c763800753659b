#pragma once
#include <optional>
#include <string_view>

#include "city_db/city.hpp"
#include "sectorgen/models/region_style.hpp"

/// What colour a house has: from its tags, else from its region's palette of plaster, tile and slate, steady by id.
namespace vicus {

/// "#abc", "#aabbcc" or a CSS colour name; case, spaces, '_' and '-' are passed over.
std::optional<Colour> parse_colour(std::string_view text);

Colour facade_colour(const Building& building, FacadeStyle style, const RegionStyle& region);
/// Flat roofs are felt and gravel, others what the region covers its roofs with. Needs   roof_shape as built.
Colour roof_colour(const Building& building, const RegionStyle& region);

}  // namespace vicus
