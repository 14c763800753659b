#pragma once
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// What stands on the ground, ready for noding: houses with their passages cut out, water without the bridges, walls
/// with their openings.
namespace vicus {

struct House {
  std::uint32_t footprint = 0;  ///< index into SourceMap::footprints
  Polygon area;
  bool is_overhead = false;  ///< above a passage, or base_m > kWalkUnderMetres: blocks nothing
  double base_m = 0;
};

struct Blocks {
  std::vector<House> houses;
  std::vector<Polygon> water;
  struct Wall {
    std::uint32_t barrier = 0;
    Polygon area;
  };
  std::vector<Wall> walls;
  std::vector<Polygon> passages;  ///< ground below the houses
};

/// One walks below whatever leaves this much head room.
inline constexpr double kWalkUnderMetres = 2.5;
/// Head room of a passage through a house, unless the house is too low for it.
inline constexpr double kPassageHeadroom = 3.5;

/// Error   0.71 mm at points made by cutting.
Blocks make_blocks(const SourceMap& map);

}  // namespace vicus
