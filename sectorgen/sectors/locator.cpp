#include "sectorgen/sectors/locator.hpp"

#include "sectorgen/geom/predicates.hpp"

namespace vicus {

Locator::Locator(const Mesh& mesh) : mesh_(mesh) {
  PlanBox box;
  for (PlanPoint p : mesh.points) box.add(p);
  if (box.is_empty()) return;
  raster_ = Raster::over(box, 32, 0);
  near_.assign(raster_.size(), kNone);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) near_[raster_.cell_at(mesh.points[mesh.corner(t, 0)])] = t;
  std::uint32_t last = 0;  // empty cells: walk from the last one filled
  for (auto& t : near_) t = t == kNone ? last : (last = t);
}

std::uint32_t Locator::locate(PlanPoint p, std::uint32_t hint) const {
  if (mesh_.triangles.empty()) return kNone;
  std::uint32_t t = hint != kNone ? hint : near_[raster_.cell_at(p)];
  // Visibility walk; the first edge tested changes from step to step, so that no cycle lasts.
  const std::size_t limit = 4 * mesh_.triangles.size() + 64;
  for (std::size_t step = 0; step < limit; ++step) {
    bool moved = false;
    for (int j = 0; j < 3 && !moved; ++j) {
      const int k = static_cast<int>((static_cast<std::size_t>(j) + step * 2654435761u / 7) % 3);
      if (orient(mesh_.points[mesh_.corner(t, k + 1)], mesh_.points[mesh_.corner(t, k + 2)], p) >= 0) continue;
      const std::uint32_t n = mesh_.triangles[t].neighbour[static_cast<std::size_t>(k)];
      if (n == kNone) return kNone;
      t = n;
      moved = true;
    }
    if (!moved) return t;
  }
  return kNone;
}

}  // namespace vicus
