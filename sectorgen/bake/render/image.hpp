#pragma once
#include "sectorgen/bake/picture/picture.hpp"

namespace vicus {

/// An image that repeats over the plane, ready for means over any rectangle of it.
class RepeatedImage {
 public:
  /// Needs   a picture of at least one pixel (assert).
  explicit RepeatedImage(const CutOut& picture);

  /// Mean over a rectangle of the image around (u, v): u 0 ... 1 from the left, v from the bottom, sides in the same
  /// units. Sides below one pixel count as one: what is larger than life is smooth.
  /// Colours come times their opacity, so that what is behind can be added.
  /// Exact   the integral of the pixels as squares.   Cost  four looks.
  Rgba mean(double u, double v, double u_side, double v_side) const;

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  using Sum = std::array<double, 4>;
  Sum integral(double x, double y) const;
  int width_, height_;
  std::vector<Sum> sums_;  ///< over all pixels to the left and above, one row and column of zeros first
};

}  // namespace vicus
