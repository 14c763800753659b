#include "city_db/wall_stretches.hpp"

#include <algorithm>

#include "city_db/segment.hpp"

namespace vicus {

std::vector<WallStretch> wall_stretches(PlanPoint a, PlanPoint b, const std::vector<const Door*>& doors) {
  const auto along = [&](PlanPoint p) {
    return (double(p.x) - a.x) * (double(b.x) - a.x) + (double(p.y) - a.y) * (double(b.y) - a.y);
  };
  std::vector<const Door*> own;
  for (const Door* d : doors)
    if (distance_to_segment_mm(d->a, a, b) <= kWallReach_mm && distance_to_segment_mm(d->b, a, b) <= kWallReach_mm &&
        along(d->a) < along(d->b))
      own.push_back(d);
  std::sort(own.begin(), own.end(), [&](const Door* x, const Door* y) { return along(x->a) < along(y->a); });
  std::vector<WallStretch> pieces;
  PlanPoint from = a;
  for (const Door* d : own) {
    if (from != d->a) pieces.push_back({from, d->a, nullptr});
    pieces.push_back({d->a, d->b, d});
    from = d->b;
  }
  if (from != b) pieces.push_back({from, b, nullptr});
  return pieces;
}

}  // namespace vicus
