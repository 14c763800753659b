#include "sectorgen/models/canvas.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace vicus {

int texture_side(double pixels) {
  constexpr int kLeast = 32, kMost = 512;
  const int side = 1 << static_cast<int>(std::lround(std::log2(std::clamp(pixels, 1.0, 2.0 * kMost))));
  return std::clamp(side, kLeast, kMost);
}

Paint paint_of(Colour c) { return {c.r / 255.0, c.g / 255.0, c.b / 255.0}; }

Paint mix(Paint a, Paint b, double t) { return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t}; }

Canvas::Canvas(int width, int height, double width_m, double height_m)
    : width_(width), height_(height), width_m_(width_m), height_m_(height_m) {
  assert(width > 0 && height > 0 && width_m > 0 && height_m > 0);
  pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

Paint& Canvas::pixel(int column, int row) {
  return pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
}

Paint Canvas::at(int column, int row) const {
  return pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
}

void Canvas::rectangle(double x0, double y0, double x1, double y1, Paint paint, double opacity) {
  const double sx = width_ / width_m_, sy = height_ / height_m_;
  const double left = std::max(0.0, x0 * sx), right = std::min<double>(width_, x1 * sx);
  const double top = std::max(0.0, height_ - y1 * sy), bottom = std::min<double>(height_, height_ - y0 * sy);
  for (int row = static_cast<int>(top); row < bottom; ++row) {
    const double rows = std::min(bottom, row + 1.0) - std::max(top, static_cast<double>(row));
    for (int column = static_cast<int>(left); column < right; ++column) {
      const double columns = std::min(right, column + 1.0) - std::max(left, static_cast<double>(column));
      if (rows <= 0 || columns <= 0) continue;
      Paint& p = pixel(column, row);
      p = mix(p, paint, opacity * rows * columns);
    }
  }
}

void Canvas::gradient(double x0, double y0, double x1, double y1, Paint bottom, Paint top, int steps) {
  for (int i = 0; i < steps; ++i)
    rectangle(x0, y0 + (y1 - y0) * i / steps, x1, y0 + (y1 - y0) * (i + 1) / steps,
              mix(bottom, top, (i + 0.5) / steps));
}

void Canvas::draw(const Canvas& tile, double inset, double x0, double y0, double x1, double y1) {
  const double left = x0 * width_ / width_m_, right = x1 * width_ / width_m_;
  const double top = height_ - y1 * height_ / height_m_, bottom = height_ - y0 * height_ / height_m_;
  const double across = (tile.width() - 2 * inset) / (right - left),
               down = (tile.height() - 2 * inset) / (bottom - top);
  const auto overlap = [](double from, double to, int cell) {
    return std::max(0.0, std::min(to, cell + 1.0) - std::max(from, static_cast<double>(cell)));
  };
  for (int row = std::max(0, static_cast<int>(top)); row < std::min<double>(bottom, height_); ++row)
    for (int column = std::max(0, static_cast<int>(left)); column < std::min<double>(right, width_); ++column) {
      const double covered = overlap(top, bottom, row) * overlap(left, right, column);
      if (covered <= 0) continue;
      const double u0 = inset + (std::max<double>(column, left) - left) * across,
                   u1 = inset + (std::min<double>(column + 1, right) - left) * across,
                   v0 = inset + (std::max<double>(row, top) - top) * down,
                   v1 = inset + (std::min<double>(row + 1, bottom) - top) * down;
      Paint sum;
      double all = 0;
      for (int v = static_cast<int>(v0); v < v1 && v < tile.height(); ++v)
        for (int u = static_cast<int>(u0); u < u1 && u < tile.width(); ++u) {
          const double share = overlap(v0, v1, v) * overlap(u0, u1, u);
          const Paint p = tile.at(u, v);
          sum = {sum.r + share * p.r, sum.g + share * p.g, sum.b + share * p.b};
          all += share;
        }
      if (all > 0) pixel(column, row) = mix(pixel(column, row), sum * (1 / all), covered);
    }
}

void Canvas::paste(const Canvas& tile, int column, int row) {
  for (int y = 0; y < tile.height(); ++y)
    for (int x = 0; x < tile.width(); ++x) pixel(column + x, row + y) = tile.at(x, y);
}

std::vector<unsigned char> Canvas::rgba() const {
  std::vector<unsigned char> bytes(4 * pixels_.size());
  const auto byte = [](double v) { return static_cast<unsigned char>(std::clamp(v * 255 + 0.5, 0.0, 255.0)); };
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Paint& p = pixels_[i];
    bytes[4 * i] = byte(p.r), bytes[4 * i + 1] = byte(p.g), bytes[4 * i + 2] = byte(p.b), bytes[4 * i + 3] = 255;
  }
  return bytes;
}

double steady_random(int x, int y, unsigned seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x85ebca6bu ^ static_cast<std::uint32_t>(y) * 0xc2b2ae35u ^
                    (seed + 1) * 0x27d4eb2fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  h ^= h >> 15;
  return (h & 0xffffffu) / 16777216.0;
}

NoiseLine::NoiseLine(double y, double most_x, unsigned seed) {
  const int row = static_cast<int>(std::floor(y)), cells = static_cast<int>(most_x) + 2;
  const double t = y - row, share = t * t * (3 - 2 * t);
  for (int column = 0; column < cells; ++column)
    at_.push_back(std::lerp(steady_random(column, row, seed), steady_random(column, row + 1, seed), share));
}

}  // namespace vicus
