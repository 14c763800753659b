#include "sectorgen/models/paint_grain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "city_db/ground_grain.hpp"
#include "city_db/steady_hash.hpp"
#include "sectorgen/models/palette_png.hpp"

namespace vicus {
namespace {

constexpr int kSide = 128;
constexpr double kStep = 6;  // of brightness, of 255: finer ones cost bytes that nobody sees

/// Noise of `cells` cells a side, -0.5 ... 0.5, smooth between them.
class Noise {
 public:
  explicit Noise(int cells) : cells_(cells) {
    for (int i = 0; i < cells * cells; ++i)
      value_.push_back(
          static_cast<double>(steady_hash("grain " + std::to_string(cells) + " " + std::to_string(i)) % 1000) / 999 -
          0.5);
  }
  double at(int column, int row) const {
    const double x = double(column) * cells_ / kSide, y = double(row) * cells_ / kSide;
    const int i = static_cast<int>(x), k = static_cast<int>(y);
    const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
    const double u = smooth(x - i), v = smooth(y - k);
    return (value(i, k) * (1 - u) + value(i + 1, k) * u) * (1 - v) +
           (value(i, k + 1) * (1 - u) + value(i + 1, k + 1) * u) * v;
  }

 private:
  double value(int i, int k) const { return value_[static_cast<std::size_t>((k % cells_) * cells_ + i % cells_)]; }
  int cells_;
  std::vector<double> value_;
};

struct Octave {
  int cells;
  double share;
};
constexpr Octave kOctaves[] = {{128, 0.10}, {64, 0.10}, {32, 0.06}, {8, 0.05}, {4, 0.04}};

}  // namespace

Texture paint_grain() {
  std::vector<double> light(std::size_t{kSide} * kSide, 0);
  for (const Octave& octave : kOctaves) {
    const Noise noise(octave.cells);
    for (int row = 0; row < kSide; ++row)
      for (int column = 0; column < kSide; ++column)
        light[static_cast<std::size_t>(row * kSide + column)] += octave.share * noise.at(column, row);
  }
  double mean = 0;
  for (const double v : light) mean += v / double(light.size());
  std::vector<unsigned char> grey;
  for (const double v : light)
    grey.push_back(
        static_cast<unsigned char>(std::clamp(std::round((kGrainMean + v - mean) * 255 / kStep) * kStep, 0.0, 255.0)));
  return grey_texture(grey, kSide, kSide);
}

}  // namespace vicus
