#pragma once
#include <cstdlib>

/// Of fuzz targets, which have no test framework around them.
inline void require(bool holds) {
  if (!holds) std::abort();
}
