#pragma once
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"
#include "sectorgen/sectors/obstacles.hpp"
#include "sectorgen/sectors/overlay.hpp"
#include "sectorgen/sectors/raster.hpp"

/// What belongs to the city, and the kerbs of streets in open ground.
namespace vicus {

/// The city's outline: the given boundary, else everything within kCityGrow of a house, shrunk again by kCityShrink and
/// without holes, and the corridors of streets that leave it and come back (research/SECTORS.md §4.1).
/// The polygons may overlap.
/// Differs by a distance raster instead of buffers: 26 s -> 0.3 s in Graz, and corridors are kept.
std::vector<Polygon> make_domain(const SourceMap& map, const Blocks& blocks);

/// Lines that block nobody and yet bound a street: a virtual kerb where a street runs through open ground
/// (research/SECTORS.md §4.9), and outline_kerbs. No axis crosses one.
std::vector<std::vector<PlanPoint>> make_kerbs(const SourceMap& map, const Blocks& blocks,
                                               const std::vector<Polygon>& domain);

/// Plot lines, and the outlines of parks and squares above 2,000 m2, where they bound something that no obstacle,
/// street or kerb beside them bounds already.   Needs  kerbs: those made so far.
std::vector<std::vector<PlanPoint>> outline_kerbs(const SourceMap& map, const Blocks& blocks,
                                                  const std::vector<Polygon>& domain,
                                                  const std::vector<std::vector<PlanPoint>>& kerbs);

inline constexpr double kCityGrow = 45, kCityShrink = 28;  // m
/// A street's side is open where the ground beside the kerb is free of obstacles to about twice this depth.
inline constexpr double kOpenSide = 15;  // m

}  // namespace vicus
