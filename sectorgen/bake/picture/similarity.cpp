#include "sectorgen/bake/picture/similarity.hpp"

#include <cassert>
#include <cmath>
#include <limits>

#include "sectorgen/bake/picture/filter.hpp"

namespace vicus {
namespace {

constexpr int kWindow = 11;
constexpr double kSigma = 1.5, kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

double luma(const Rgb& p) { return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]; }

Kernel bell() {
  Kernel out(kWindow);
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
  using Plane = PixelGrid<double>;
  Plane p(a.width, a.height), q = p, pp = p, qq = p, pq = p;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double x = luma(a.pixels[i]), y = luma(b.pixels[i]);
    p.pixels[i] = x, q.pixels[i] = y;
    pp.pixels[i] = x * x, qq.pixels[i] = y * y, pq.pixels[i] = x * y;
  }
  const Kernel weights = bell();
  for (Plane* plane : {&p, &q, &pp, &qq, &pq}) *plane = filtered(*plane, weights, weights);
  constexpr int kRadius = kWindow / 2;
  double sum = 0;
  for (int y = kRadius; y + kRadius < a.height; ++y)
    for (int x = kRadius; x + kRadius < a.width; ++x) {
      const double ma = p.at(x, y), mb = q.at(x, y);
      sum += (2 * ma * mb + kC1) * (2 * (pq.at(x, y) - ma * mb) + kC2) /
             ((ma * ma + mb * mb + kC1) * (pp.at(x, y) - ma * ma + qq.at(x, y) - mb * mb + kC2));
    }
  return sum / ((a.width - kWindow + 1.0) * (a.height - kWindow + 1.0));
}

}  // namespace vicus
