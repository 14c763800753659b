#pragma once
#include <cassert>
#include <vector>

#include "city_db/colour.hpp"

/// A picture in metres: rectangles are painted with the exact area that they cover of each pixel, so small textures are
/// smooth without supersampling.
namespace vicus {

/// Linear use of sRGB values, 0 ... 1.
struct Paint {
  double r = 0, g = 0, b = 0;
  friend Paint operator*(Paint p, double k) { return {p.r * k, p.g * k, p.b * k}; }
};
Paint paint_of(Colour colour);
Paint mix(Paint a, Paint b, double share_of_b);

/// Side of a texture that shall have about so many pixels: the nearest power of two, 32 ... 512.
int texture_side(double pixels);

/// Frame   metres, origin at the bottom left.
class Canvas {
 public:
  /// Needs   width, height > 0; metres > 0.
  Canvas(int width, int height, double width_m, double height_m);
  int width() const { return width_; }
  int height() const { return height_; }
  double width_m() const { return width_m_; }
  double height_m() const { return height_m_; }

  /// Lays `paint` over [x0, x1] x [y0, y1]; what lies outside is cut off.
  void rectangle(double x0, double y0, double x1, double y1, Paint paint, double opacity = 1);
  /// From `bottom` to `top` in `steps` bands.
  void gradient(double x0, double y0, double x1, double y1, Paint bottom, Paint top, int steps);
  /// Each pixel of the whole picture times a factor of its middle's place: `factor_at(y)` gives the factor by x of a
  /// row.
  template <class FactorAt>
  void shade(FactorAt factor_at) {
    for (int row = 0; row < height_; ++row) {
      const auto factor = factor_at((height_ - row - 0.5) * height_m_ / height_);
      for (int column = 0; column < width_; ++column) {
        Paint& p = pixel(column, row);
        p = p * factor((column + 0.5) * width_m_ / width_);
      }
    }
  }
  /// Lays the tile's pixels but for `inset` of them along each side over [x0, x1] x [y0, y1]; each pixel gets the mean
  /// of what falls on it.
  void draw(const Canvas& tile, double inset, double x0, double y0, double x1, double y1);
  /// Copies another canvas of the same pixels into place, its top left pixel at (column, row).
  void paste(const Canvas& tile, int column, int row);

  /// 4 bytes a pixel, top row first, opaque.
  std::vector<unsigned char> rgba() const;
  Paint at(int column, int row) const;
  void set(int column, int row, Paint paint) { pixel(column, row) = paint; }

 private:
  Paint& pixel(int column, int row);
  int width_, height_;
  double width_m_, height_m_;
  std::vector<Paint> pixels_;
};

/// Smooth noise of value 0 ... 1, steady for a seed, along one line.
class NoiseLine {
 public:
  /// Needs   it is asked for 0 <= x <= most_x.
  NoiseLine(double y, double most_x, unsigned seed);
  double operator()(double x) const {
    const auto cell = static_cast<std::size_t>(x);
    assert(x >= 0 && cell + 1 < at_.size());
    const double t = x - static_cast<double>(cell);
    return at_[cell] + (at_[cell + 1] - at_[cell]) * (t * t * (3 - 2 * t));
  }

 private:
  std::vector<double> at_;  // at whole x
};
/// 0 ... 1, steady.
double steady_random(int x, int y, unsigned seed);

}  // namespace vicus
