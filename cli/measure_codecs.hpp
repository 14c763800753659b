#pragma once
#include "cli/measure_run.hpp"

/// Ways of coding one content, each over a range of its own quality, so that bytes can be compared at equal FLIP.
namespace vicus::measure {

/// Two contents. "street": the near sectors around some views of the walk as X3D, GLB with Draco and GLB with meshopt,
/// positions in steps of 1 mm to 1 m; error against the same triangles not coded. "colours of tiles": leaf tiles of 128
/// cells around some views of the flight, WebP from quality 5 to lossless; error against the pictures not coded.
std::vector<CodecRow> compare_codecs(SharedCity& city, const Course& course, const RunOptions& options);

}  // namespace vicus::measure
