#include "sectorgen/bake/picture/similarity.hpp"

#include <cassert>
#include <cmath>
#include <limits>

namespace vicus {
namespace {

constexpr int kWindow = 11;
constexpr double kSigma = 1.5, kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

double luma(const Rgb& p) { return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]; }

std::array<double, kWindow> bell() {
  std::array<double, kWindow> out{};
  double sum = 0;
  for (int k = 0; k < kWindow; ++k) {
    const double x = k - kWindow / 2;
    sum += out[static_cast<std::size_t>(k)] = std::exp(-x * x / (2 * kSigma * kSigma));
  }
  for (double& v : out) v /= sum;
  return out;
}

}  // namespace

double psnr_db(const Picture& a, const Picture& b) {
  assert(a.width == b.width && a.height == b.height);
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = double{a.pixels[i][k]} - b.pixels[i][k];
      sum += d * d;
    }
  if (sum == 0) return std::numeric_limits<double>::infinity();
  return -10 * std::log10(sum / (3 * static_cast<double>(a.pixels.size())));
}

double ssim(const Picture& a, const Picture& b) {
  assert(a.width == b.width && a.height == b.height && a.width >= kWindow && a.height >= kWindow);
  const auto weights = bell();
  double sum = 0;
  for (int y = 0; y + kWindow <= a.height; ++y)
    for (int x = 0; x + kWindow <= a.width; ++x) {
      double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
      for (int j = 0; j < kWindow; ++j)
        for (int i = 0; i < kWindow; ++i) {
          const double w = weights[static_cast<std::size_t>(i)] * weights[static_cast<std::size_t>(j)];
          const double p = luma(a.at(x + i, y + j)), q = luma(b.at(x + i, y + j));
          ma += w * p;
          mb += w * q;
          aa += w * p * p;
          bb += w * q * q;
          ab += w * p * q;
        }
      sum += (2 * ma * mb + kC1) * (2 * (ab - ma * mb) + kC2) /
             ((ma * ma + mb * mb + kC1) * (aa - ma * ma + bb - mb * mb + kC2));
    }
  return sum / ((a.width - kWindow + 1.0) * (a.height - kWindow + 1.0));
}

}  // namespace vicus
