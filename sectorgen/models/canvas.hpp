#pragma once
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
  /// Each pixel of the whole picture times a factor of its middle's place.
  template <class Factor>
  void shade(Factor factor) {
    for (int row = 0; row < height_; ++row)
      for (int column = 0; column < width_; ++column) {
        Paint& p = pixel(column, row);
        p = p * factor((column + 0.5) * width_m_ / width_, (height_ - row - 0.5) * height_m_ / height_);
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

/// Smooth noise of value 0 ... 1, steady for a seed.
double value_noise(double x, double y, unsigned seed);
/// 0 ... 1, steady.
double steady_random(int x, int y, unsigned seed);

}  // namespace vicus
