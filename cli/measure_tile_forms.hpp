#pragma once
#include "cli/measure_representation.hpp"
#include "cli/measure_shared_city.hpp"

/// The city from above in tiles of a quadtree (docs/blockmaps.md), each kind down to an error on screen. No tile says
/// what stands beyond its rim; all stand on SharedCity's sheet.
namespace vicus::measure {

/// As the flying client takes them: prisms, BlockMaps of 128 cells where the houses are too many.
Form client_tiles(SharedCity& city, double tau_px);
/// Prisms alone, each with its tile of ground.
Form prism_tiles(SharedCity& city, double tau_px);
/// Our BlockMaps of `cells` x `cells`; sent as brotli of the whole.
Form blockmap_tiles(SharedCity& city, std::uint32_t cells, double tau_px);
/// As published, 2007 or 2009. Their error is half the diagonal of a voxel, as the papers take it; sent in parts
/// (paper_sent_bytes); shown without loss of colour.
Form paper_tiles(SharedCity& city, int year, std::uint32_t side, std::uint32_t columns, double tau_px);

}  // namespace vicus::measure
