#include "sectorgen/bake/facade_sums.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>

namespace vicus {
namespace {

constexpr std::size_t kReduced = 4;
constexpr png_uint_32 kMostPixels = 4096;  // a side; ours have 512

}  // namespace

std::optional<FacadeSums> FacadeSums::of_png(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) return std::nullopt;
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> pixels;
  if (image.width <= kMostPixels && image.height <= kMostPixels) pixels.resize(PNG_IMAGE_SIZE(image));
  if (pixels.empty() || png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0) {
    png_image_free(&image);
    return std::nullopt;
  }
  FacadeSums out;
  out.width_ = (image.width + kReduced - 1) / kReduced;
  out.height_ = (image.height + kReduced - 1) / kReduced;
  const std::size_t stride = 3 * (out.width_ + 1);
  out.sums_.assign(stride * (out.height_ + 1), 0);
  for (std::size_t y = 0; y < out.height_; ++y)
    for (std::size_t x = 0; x < out.width_; ++x)
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t total = 0, count = 0;
        for (std::size_t py = y * kReduced; py < std::min<std::size_t>((y + 1) * kReduced, image.height); ++py)
          for (std::size_t px = x * kReduced; px < std::min<std::size_t>((x + 1) * kReduced, image.width); ++px) {
            total += pixels[3 * ((image.height - 1 - py) * image.width + px) + k];
            ++count;
          }
        auto* at = &out.sums_[(y + 1) * stride + 3 * (x + 1) + k];
        *at = (16 * total + count / 2) / count + *(at - 3) + *(at - stride) - *(at - stride - 3);  // 1/16 of a value
      }
  return out;
}

ColourMean FacadeSums::sum(std::size_t x, std::size_t y) const {
  const auto* at = &sums_[3 * (y * (width_ + 1) + x)];
  return {at[0] / 16.0, at[1] / 16.0, at[2] / 16.0};
}

ColourMean FacadeSums::integral(double u, double v) const {
  const double turns = std::floor(u), x = (u - turns) * double(width_), y = v * double(height_);
  const auto ix = std::min(static_cast<std::size_t>(x), width_ - 1);
  const auto iy = std::min(static_cast<std::size_t>(y), height_ - 1);
  const double fx = x - double(ix), fy = y - double(iy);
  const auto between = [](ColourMean p, ColourMean q, double t) { return p * (1 - t) + q * t; };
  const auto row = [&](std::size_t j) { return between(sum(ix, j), sum(ix + 1, j), fx) + sum(width_, j) * turns; };
  return between(row(iy), row(iy + 1), fy);
}

ColourMean FacadeSums::mean(double u0, double u1, double v0, double v1) const {
  return (strip(u0, u1, v1) + strip(u0, u1, v0) * -1) * (1 / (v1 - v0));
}

ColourMean FacadeSums::strip(double u0, double u1, double v) const {
  return (integral(u1, v) + integral(u0, v) * -1) * (1 / ((u1 - u0) * double(width_) * double(height_)));
}

ColourMean FacadeSums::at(double u, double v) const {
  const auto x = std::min(static_cast<std::size_t>((u - std::floor(u)) * double(width_)), width_ - 1);
  const auto y = std::min(static_cast<std::size_t>(std::clamp(v, 0.0, 1.0) * double(height_)), height_ - 1);
  return sum(x + 1, y + 1) + sum(x, y + 1) * -1 + sum(x + 1, y) * -1 + sum(x, y);
}

}  // namespace vicus
