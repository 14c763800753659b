#pragma once
#include "sectorgen/bake/picture/picture.hpp"

/// How far apart the outlines against the sky are.
/// Needs   equal sizes (assert).
namespace vicus {

/// Soft intersection over union: sum of the smaller over sum of the larger coverage; 1: equal, or nothing in both.
double silhouette_iou(const Coverage& a, const Coverage& b);

/// Column by column, how many rows the highest pixel that is at least half covered lies apart; a column without one
/// counts as if it began below the picture.
struct SkylineDistance {
  double mean_px = 0, max_px = 0;
};
SkylineDistance skyline_distance(const Coverage& a, const Coverage& b);

}  // namespace vicus
