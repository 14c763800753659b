#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "city_db/city.hpp"

/// How houses are built around a place: for those whose tags do not say.
namespace vicus {

struct RegionStyle {
  std::string_view name;
  std::span<const std::uint32_t> plaster, stone, brick;  ///< sRGB; few: each makes another image of every pattern
  std::span<const std::uint32_t> steep_roofs, flat_roofs;
  unsigned stone_of_ten_high, brick_of_ten_high, brick_of_ten_low;  ///< the rest: plaster
  bool has_mansards;                                                ///< on houses of four storeys and more
};

/// The smallest region known that has the place in it, else that of Central Europe.
const RegionStyle& region_style(LatLon place);

}  // namespace vicus
