#include "sectorgen/bake/picture/filter.hpp"

#include <algorithm>
#include <cassert>

namespace vicus {

PixelGrid<double> filtered(const PixelGrid<double>& from, const Kernel& across, const Kernel& down) {
  assert(across.size() == down.size() && across.size() % 2 == 1);
  const int radius = static_cast<int>(across.size() / 2), width = from.width, height = from.height;
  // Sums run along whole rows, tap by tap, which compilers widen.
  const auto add_row = [width](const double* in, double weight, double* out) {
    for (int x = 0; x < width; ++x) out[x] += weight * in[x];
  };
  PixelGrid<double> rows(width, height), out(width, height);
  std::vector<double> wide(static_cast<std::size_t>(width + 2 * radius));
  for (int y = 0; y < height; ++y) {
    for (int x = -radius; x < width + radius; ++x)
      wide[static_cast<std::size_t>(x + radius)] = from.at(std::clamp(x, 0, width - 1), y);
    for (int k = 0; k <= 2 * radius; ++k)
      add_row(&wide[static_cast<std::size_t>(k)], across[static_cast<std::size_t>(k)], &rows.at(0, y));
  }
  for (int y = 0; y < height; ++y)
    for (int k = -radius; k <= radius; ++k)
      add_row(&rows.at(0, std::clamp(y + k, 0, height - 1)), down[static_cast<std::size_t>(k + radius)], &out.at(0, y));
  return out;
}

}  // namespace vicus
