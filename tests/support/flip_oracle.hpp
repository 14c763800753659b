#pragma once
#include "sectorgen/bake/picture/picture.hpp"

namespace vicus::test {

/// FLIP straight from the paper's formulas: every filter as one kernel in two dimensions, weights summed as they come.
/// Slow; shares no line with sectorgen/picture.
double slow_flip(const Picture& reference, const Picture& test, int column, int row, double pixels_per_degree);

}  // namespace vicus::test
