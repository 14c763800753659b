#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "city_db/colour.hpp"

/// Means of a facade's picture over any rectangle, in constant time.
namespace vicus {

/// sRGB values 0 ... 255, not rounded.
struct ColourMean {
  double r = 0, g = 0, b = 0;
  friend ColourMean operator+(ColourMean p, ColourMean q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
  friend ColourMean operator*(ColourMean p, double k) { return {p.r * k, p.g * k, p.b * k}; }
};
inline ColourMean mean_of(Colour c) { return {double(c.r), double(c.g), double(c.b)}; }
inline Colour rounded(ColourMean c) {
  const auto channel = [](double v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5, 0.0, 255.0)); };
  return {channel(c.r), channel(c.g), channel(c.b)};
}

/// A summed-area table (Crow, SIGGRAPH 1984) of a picture reduced by 4 x 4 pixels: about 0.3 m of a facade, finer than
/// any cell that it is sampled for.
class FacadeSums {
 public:
  /// nullopt: the bytes are no PNG.
  static std::optional<FacadeSums> of_png(const std::string& png);

  /// Mean over [u0, u1] x [v0, v1]; the picture repeats in u, v goes from 0 at its foot to 1.
  /// Needs   u0 < u1, 0 <= v0 < v1 <= 1.
  ColourMean mean(double u0, double u1, double v0, double v1) const;
  /// Integral of the mean over [u0, u1] from the picture's foot up to v: of two rows that meet, each side once.
  /// Needs   u0 < u1, 0 <= v <= 1.
  ColourMean strip(double u0, double u1, double v) const;
  ColourMean at(double u, double v) const;

 private:
  /// Integral from the picture's foot on the left, in pixels.
  ColourMean integral(double u, double v) const;
  ColourMean sum(std::size_t x, std::size_t y) const;
  std::size_t width_ = 0, height_ = 0;
  std::vector<std::uint32_t> sums_;  ///< 3 a corner, (width + 1) * (height + 1) corners from the foot up
};

}  // namespace vicus
