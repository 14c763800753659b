#pragma once
#include "sectorgen/bake/picture/picture.hpp"

/// Two older measures of how equal pictures are, for comparing with what others publish.
/// Needs   equal sizes (assert).
namespace vicus {

/// Peak signal-to-noise ratio over all channels, dB; infinity: equal.
double psnr_db(const Picture& a, const Picture& b);

/// Structural similarity of the luma, mean over all windows that lie in the picture; 1: equal.
/// Needs   at least 11 x 11 pixels (assert).
/// Source  Wang et al., Image Quality Assessment, IEEE TIP 13 (2004): 11 x 11, sigma 1.5, K1 0.01, K2 0.03.
double ssim(const Picture& a, const Picture& b);

}  // namespace vicus
