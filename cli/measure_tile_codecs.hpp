#pragma once
#include "cli/measure_run.hpp"

namespace vicus::measure {

/// The pictures of BlockMaps of 128 cells, as a view from each pose takes them at 4 pixels: as WebP from quality 5 to
/// lossless, and as PNG with palettes of 4 to 256 colours. Bytes of a view's tiles, planes with them; FLIP against the
/// same tiles with pictures that were not coded.
std::vector<CodecRow> compare_tile_codecs(SharedCity& city, const std::vector<Pose>& poses, const RunOptions& options);

}  // namespace vicus::measure
