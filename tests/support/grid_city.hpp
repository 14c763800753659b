#pragma once
#include <cstdint>

#include "city_db/city.hpp"

/// A city of crossroads and streets on a grid, for hard cases and for speed: sectors and houses, gates left out.
namespace vicus::test {

struct GridOptions {
  std::int32_t side = 40;           ///< crossroads a side: side^2 crossroads, 2 side (side - 1) streets
  std::int32_t pitch_mm = 80'000;   ///< from crossroads to crossroads
  std::int32_t width_mm = 12'000;   ///< of streets
  std::int32_t jitter_mm = 19'200;  ///< crossroads are moved by up to half of this; 0: all fronts in line
  std::int32_t niches = 0;          ///< niches per front: sectors become concave
  double height_m = 15;
  std::uint64_t seed = 1;
};

/// Sectors: crossroads first, row by row, then streets going east, then streets going north. Each block is a house.
City grid_city(const GridOptions& options);

}  // namespace vicus::test
