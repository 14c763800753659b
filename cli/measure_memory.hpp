#pragma once
#include "city_db/blockmap.hpp"
#include "city_db/blockmap_paper.hpp"
#include "sectorgen/bake/render/render_mesh.hpp"

/// Bytes that a graphics card holds: unindexed triangles of position, normal, colour or place; images as RGBA with
/// mipmaps; tiles as textures of the values they are decoded to.
namespace vicus::measure {

inline constexpr double kVertex_bytes = 12 + 12 + 8;
inline constexpr double kPixel_bytes = 4 * 4.0 / 3;

double memory_of(const RenderMesh& mesh);
/// Planes as stored (height, foot: 2 bytes; slopes, angle, offset: 1), the pyramid of maxima (2 bytes), the first
/// column of each cell (4), and the four pictures without mipmaps, as a height field needs none.
double memory_of(const BlockMap& map);
double memory_of(const PaperBlockMap& map);

/// CPU time of this process, ms.
double cpu_ms();

}  // namespace vicus::measure
