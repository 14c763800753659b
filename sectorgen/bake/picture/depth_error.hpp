#pragma once
#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/picture/picture.hpp"

namespace vicus {

/// A pixel's depth is found again where another picture has it within this share (and 2 cm), sky where sky is.
inline constexpr double kDepthShare = 0.01;
/// Looked for within so many pixels; what is not found there counts one more.
inline constexpr int kDepthReach_px = 3;

/// Projected error of geometry: for each pixel, how many pixels away the other picture has its depth, both ways (the
/// larger of both). mean, 99th percentile and maximum (the Hausdorff distance on the screen, cut at 4 px).
/// Needs   equal sizes (assert).   Source  research on image-based representations, metrics.
ErrorSummary projected_depth_error_px(const DepthMap& a, const DepthMap& b);

}  // namespace vicus
