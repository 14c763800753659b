#include "sectorgen/bake/render/image.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vicus {

RepeatedImage::RepeatedImage(const CutOut& picture) : width_(picture.width), height_(picture.height) {
  assert(width_ > 0 && height_ > 0);
  const auto columns = static_cast<std::size_t>(width_) + 1;
  sums_.resize(columns * (static_cast<std::size_t>(height_) + 1));
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const std::size_t at = static_cast<std::size_t>(y + 1) * columns + static_cast<std::size_t>(x + 1);
      for (std::size_t k = 0; k < 4; ++k)
        sums_[at][k] = double{picture.at(x, y)[k]} * (k < 3 ? picture.at(x, y)[3] : 1) + sums_[at - 1][k] +
                       sums_[at - columns][k] - sums_[at - columns - 1][k];
    }
}

/// Over [0, x] x [0, y] in pixels, for any x and y: whole repeats, and what is left of one.
RepeatedImage::Sum RepeatedImage::integral(double x, double y) const {
  const auto columns = static_cast<std::size_t>(width_) + 1;
  const double wide = std::floor(x / width_), high = std::floor(y / height_);
  const double rx = std::clamp(x - wide * width_, 0.0, static_cast<double>(width_));
  const double ry = std::clamp(y - high * height_, 0.0, static_cast<double>(height_));
  const auto ix = std::min(static_cast<std::size_t>(rx), static_cast<std::size_t>(width_ - 1));
  const auto iy = std::min(static_cast<std::size_t>(ry), static_cast<std::size_t>(height_ - 1));
  const double fx = rx - static_cast<double>(ix), fy = ry - static_cast<double>(iy);
  const auto sum = [&](std::size_t column, std::size_t row) -> const Sum& { return sums_[row * columns + column]; };
  const auto last_column = columns - 1, last_row = static_cast<std::size_t>(height_);
  Sum out{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto along = [&](std::size_t row) { return (1 - fx) * sum(ix, row)[k] + fx * sum(ix + 1, row)[k]; };
    const double part = (1 - fy) * along(iy) + fy * along(iy + 1);
    const double side = (1 - fy) * sum(last_column, iy)[k] + fy * sum(last_column, iy + 1)[k];
    out[k] = part + wide * side + high * along(last_row) + wide * high * sum(last_column, last_row)[k];
  }
  return out;
}

Rgba RepeatedImage::mean(double u, double v, double u_side, double v_side) const {
  // A mean over thousands of repeats is the mean over a few.
  constexpr double kMostRepeats = 16;
  const double w = std::clamp(u_side * width_, 1.0, kMostRepeats * width_),
               h = std::clamp(v_side * height_, 1.0, kMostRepeats * height_);
  // Whole repeats are taken off first, so that the sums keep their digits.
  const double x = (u - std::floor(u)) * width_, y = (std::ceil(v) - v) * height_;
  const Sum a = integral(x - w / 2, y - h / 2), b = integral(x + w / 2, y - h / 2), c = integral(x - w / 2, y + h / 2),
            d = integral(x + w / 2, y + h / 2);
  Rgba out{};
  for (std::size_t k = 0; k < 4; ++k)
    out[k] = static_cast<float>(std::clamp((d[k] - b[k] - c[k] + a[k]) / (w * h), 0.0, 1.0));
  return out;
}

}  // namespace vicus
