#pragma once
#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// The ground as it is drawn and walked on, and everything else put onto it.
namespace vicus {

/// A carriageway lies this far below its kerb, and water below its banks.
inline constexpr double kKerb_m = 0.12, kWaterBelow_m = 0.5;
/// House walls go on this far below the lowest ground at their foot.
inline constexpr double kBuried_m = 0.1;

struct GroundFigures {
  std::size_t triangles = 0;
  double largest_gap_m = 0;  ///< between the foot of a house's wall and the ground before it; 0: none hovers
};

/// Fills City::surfaces and the heights of ground of houses, objects and viewpoints. With a terrain every vertex of the
/// ground lies on it (less the kerb), a house stands at the height before its door, or the middle one around it, with
/// walls down to below the lowest.
/// Needs   sectors with their final ids, obstacles, borders, facades, objects, viewpoints, terrain.
GroundFigures lay_ground(const SourceMap& map, City& city, unsigned threads);

}  // namespace vicus
