#pragma once
#include <vector>

#include "sectorgen/bake/picture/picture.hpp"

namespace vicus {

/// Weights of an odd number of neighbours, the pixel itself in the middle.
using Kernel = std::vector<double>;

/// Rows by `across`, then columns by `down`; borders repeat.
/// Needs   kernels of one length (assert).
PixelGrid<double> filtered(const PixelGrid<double>& from, const Kernel& across, const Kernel& down);

}  // namespace vicus
