#include "cli/measure_memory.hpp"

#include <ctime>

#include "sectorgen/bake/bake_blockmap.hpp"

namespace vicus::measure {

double memory_of(const RenderMesh& mesh) {
  double sum = 3 * kVertex_bytes * static_cast<double>(mesh.triangles.size());
  for (const auto& image : mesh.images) sum += kPixel_bytes * image->width() * image->height();
  return sum;
}

double memory_of(const BlockMap& map) {
  constexpr double kCell_bytes = 2 + 2 + 1 + 1 + 1 + 1 + 2 * 4.0 / 3 + 4, kRgba_bytes = 4;
  const double cells = static_cast<double>(map.side) * map.side;
  const auto [width, height] = wall_atlas_size(column_total(first_columns(wall_bits(map))), map.rows);
  const double pictures = cells + cells / 4 + cells / 4 + static_cast<double>(width) * height;
  return cells * kCell_bytes + pictures * kRgba_bytes;
}

double memory_of(const PaperBlockMap& map) { return static_cast<double>(map.texels.size()); }

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

}  // namespace vicus::measure
