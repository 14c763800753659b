#pragma once
#include "city_db/blockmap.hpp"
#include "sectorgen/bake/bake_scene.hpp"
#include "sectorgen/bake/blockmap_colours.hpp"

/// A tile of the image-based city in our own form.
namespace vicus {

struct BlockMapOptions {
  std::uint32_t side = 128;  ///< cells: a power of two, BLOCKMAP_LEAST_SIDE ... BLOCKMAP_MOST_SIDE
  std::uint32_t rows = 0;    ///< of a wall column; 0: a texel is as high as two cells are wide
  int colours = 24;          ///< of each picture: 2 ... 256
  bool with_ambient = true;
};

/// A tile before its pictures are coded.
struct BakedBlockMap {
  BlockMap map;  ///< without images
  TilePictures pictures;
};

/// The tile of the square with south-west corner `corner`. Analytic: exact areas of cut polygons, exact means of facade
/// pictures; equal scenes give equal bytes on any number of threads.
///
/// Error   map.error_mm bounds how far any point of a roof, wall or of the ground in the square lies from the tile's
///         surface, and back (cell_fit.hpp); what lies under a house's underside is not counted.
/// Source  paper 000 §3.3; paper 001 §5 for slopes and ambient light; research/IMAGE_BASED.md §A1.
/// Differs no views of the geometry: facades are means of their pictures over exactly the stretch and height a texel
///         stands for.
/// Cost    docs/blockmaps.md, "Speed".
BakedBlockMap bake_unpacked(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm,
                            const BlockMapOptions& options = {});

/// The same with coded pictures, and their error measured.
BlockMap bake_blockmap(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm,
                       const BlockMapOptions& options = {});

}  // namespace vicus
