#include "x3d_export/ground_levels.hpp"

#include <algorithm>
#include <limits>

namespace vicus {

GroundLevels::GroundLevels(const CityIndex& index, const Sector& sector) {
  std::int32_t least = std::numeric_limits<std::int32_t>::max();
  for (const Surface* s : index.surfaces_of(sector.id)) {
    if (s->kind == SurfaceKind::kerb || s->kind == SurfaceKind::water) continue;
    for (const GroundPoint& p : s->points) {
      const auto [at, is_new] = up_mm_.emplace(p.at, p.up_mm);
      if (!is_new) at->second = std::max(at->second, p.up_mm);
      least = std::min(least, p.up_mm);
    }
  }
  if (!up_mm_.empty()) least_mm_ = least;
}

std::int32_t GroundLevels::at(PlanPoint p, std::int32_t otherwise) const {
  const auto at = up_mm_.find(p);
  return at == up_mm_.end() ? otherwise : at->second;
}

}  // namespace vicus
