#pragma once
#include <map>

#include "x3d_export/city_index.hpp"

namespace vicus {

/// Heights of the ground at the corners of a sector's own surfaces, in mm above the plan frame's 0.
class GroundLevels {
 public:
  GroundLevels(const CityIndex& index, const Sector& sector);
  /// The higher one where the ground has a step there; `otherwise` where it has no corner.
  std::int32_t at(PlanPoint p, std::int32_t otherwise = 0) const;
  std::int32_t least_mm() const { return least_mm_; }

 private:
  std::map<PlanPoint, std::int32_t> up_mm_;
  std::int32_t least_mm_ = 0;
};

}  // namespace vicus
