#pragma once
#include <cmath>

#include "city_db/units.hpp"
#include "x3d_export/frames.hpp"

namespace vicus {

/// Places on and before an upright wall.
/// Frame   metres: x from the wall's left end seen from outside, z above `ground_m`, out towards the viewer.
///         Right-handed: x, z, out.
class WallFrame {
 public:
  /// The wall over a -> b with its outside on the left, seen from there: b is the left end.
  /// Needs   a != b.
  WallFrame(PlanPoint a, PlanPoint b, PlanPoint origin, double ground_m = 0)
      : left_(b), origin_(origin), ground_mm_(height_mm(ground_m)) {
    const double dx = a.x - b.x, dy = a.y - b.y, length = std::hypot(dx, dy);
    ux_ = dx / length;
    uy_ = dy / length;
    length_m_ = length / kMmPerMetre;
  }
  double length_m() const { return length_m_; }
  PlanPoint plan(double x, double out) const {
    return {left_.x + lattice_mm(ux_ * x + uy_ * out), left_.y + lattice_mm(uy_ * x - ux_ * out)};
  }
  X3dPoint at(double x, double z, double out) const {
    return x3d_from_plan(plan(x, out), ground_mm_ + height_mm(z), origin_);
  }

 private:
  PlanPoint left_, origin_;
  std::int32_t ground_mm_ = 0;
  double ux_ = 1, uy_ = 0, length_m_ = 0;
};

}  // namespace vicus
