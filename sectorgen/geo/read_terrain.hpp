#pragma once
#include <filesystem>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geo/plan_frame.hpp"

/// Heights of the ground from a raster that GDAL reads (GeoTIFF, ...), on a grid of the plan frame.
namespace vicus {

struct TerrainOptions {
  std::int32_t step_mm = 5000;
  std::size_t most_nodes = 4'000'000;  ///< of more, the step is widened to whole metres
};

struct ReadTerrain {
  Terrain terrain;            ///< heights above base_m; covers `box`
  int base_m = 0;             ///< the lowest height there, rounded down, above the raster's zero
  std::size_t filled = 0;     ///< nodes whose height was taken from those around
  bool is_coarsened = false;  ///< the step is wider than asked for
};

/// The raster's first band, in metres or feet as it says, bilinear between the middles of its pixels.
/// Error   that of the raster, and 0.5 mm; where a window of the raster has more than 40 million pixels, it is read
///         averaged down to fewer.
/// Holes   no value, a value outside -500 ... 9000 m, or no raster there: filled from the nodes around, ring by ring,
///         and told by one issue 105.
/// Needs   a box that is not empty.
/// Fails   CityError: no raster; no usable coordinate system or one that does not reach the city; no height in the box.
ReadTerrain read_terrain(const std::filesystem::path& path, const PlanFrame& frame, const PlanBox& box,
                         const TerrainOptions& options, std::vector<Issue>& issues);

}  // namespace vicus
