#include "sectorgen/bake/picture/flip.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "city_db/colour.hpp"
#include "sectorgen/bake/picture/filter.hpp"

namespace vicus {
namespace {

using Triple = std::array<double, 3>;
using Plane = PixelGrid<double>;
using Planes = std::array<Plane, 3>;

constexpr double kColourPower = 0.7, kKnee = 0.4, kKneeValue = 0.95, kFeaturePower = 0.5, kEdgeWidth_deg = 0.082;

/// Linear sRGB to CIE XYZ, white D65.
constexpr std::array<Triple, 3> kXyzFromRgb = {{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                                {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                                {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

Triple times(const std::array<Triple, 3>& m, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

std::array<Triple, 3> inverse(const std::array<Triple, 3>& m) {
  std::array<Triple, 3> out{};
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
    determinant += m[0][i] * (m[1][a] * m[2][b] - m[1][b] * m[2][a]);
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      out[i][k] = (m[a][c] * m[b][d] - m[a][d] * m[b][c]) / determinant;
    }
  return out;
}

const Triple& white() {
  static const Triple kWhite = times(kXyzFromRgb, {1, 1, 1});
  return kWhite;
}

/// Y, Cx, Cz: the opponent colours in which an eye's sharpness is given.
Triple opponent_from_rgb(const Triple& rgb) {
  Triple xyz = times(kXyzFromRgb, rgb);
  for (std::size_t i = 0; i < 3; ++i) xyz[i] /= white()[i];
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Triple rgb_from_opponent(const Triple& v) {
  static const std::array<Triple, 3> kRgbFromXyz = inverse(kXyzFromRgb);
  const double y = (v[0] + 16) / 116;
  return times(kRgbFromXyz, {(y + v[1] / 500) * white()[0], y * white()[1], (y - v[2] / 200) * white()[2]});
}

/// CIELAB with chroma scaled by lightness (Hunt effect).
Triple hunt_lab(const Triple& rgb) {
  constexpr double kDelta = 6.0 / 29;
  const auto f = [](double t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const Triple xyz = times(kXyzFromRgb, rgb);
  const double x = f(xyz[0] / white()[0]), y = f(xyz[1] / white()[1]), z = f(xyz[2] / white()[2]);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const Triple& a, const Triple& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

/// A difference of colours, 0 ... 1: large ones are squeezed into the last twentieth.
double colour_error(const Triple& a, const Triple& b) {
  static const double kMost = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kColourPower);
  const double error = std::pow(hyab(a, b), kColourPower), knee = kKnee * kMost;
  if (error < knee) return kKneeValue / knee * error;
  return kKneeValue + (error - knee) / (kMost - knee) * (1 - kKneeValue);
}

template <class Value>
Kernel kernel_of(int radius, Value value) {
  Kernel kernel;
  for (int k = -radius; k <= radius; ++k) kernel.push_back(value(k));
  return kernel;
}

/// What the eye's sharpness leaves of a channel: a sum of one or two Gaussians in degrees, of sum 1.
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity kSensitivities[] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};

Plane seen(const Plane& channel, const Sensitivity& s, double pixels_per_degree) {
  constexpr double kPi = std::numbers::pi;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * pixels_per_degree));
  const auto gaussian = [&](double b) {
    return kernel_of(radius, [&](int k) {
      const double x = k / pixels_per_degree;
      return std::exp(-kPi * kPi * x * x / b);
    });
  };
  const auto sum = [](const Kernel& kernel) {
    double total = 0;
    for (const double v : kernel) total += v;
    return total * total;
  };
  const Kernel first = gaussian(s.b1), second = gaussian(s.b2);
  const double w1 = s.a1 * std::sqrt(kPi / s.b1), w2 = s.a2 * std::sqrt(kPi / s.b2);
  const double all = w1 * sum(first) + w2 * sum(second);
  Plane out = filtered(channel, first, first);
  for (double& v : out.pixels) v *= w1 / all;
  if (w2 == 0) return out;
  const Plane more = filtered(channel, second, second);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] += w2 / all * more.pixels[i];
  return out;
}

struct Sight {
  PixelGrid<Triple> lab;  // after the eye
  Plane edges, points;    // strength of features
};

/// A derivative's kernel whose negative and positive values sum up to -1 and 1 in two dimensions.
Kernel balanced(Kernel derivative, const Kernel& gaussian) {
  double positive = 0, negative = 0, weight = 0;
  for (const double v : gaussian) weight += v;
  for (const double v : derivative) (v > 0 ? positive : negative) += v;
  for (double& v : derivative) v /= (v > 0 ? positive : -negative) * weight;
  return derivative;
}

Sight look_at(const Picture& picture, double pixels_per_degree) {
  Planes channels;
  for (Plane& plane : channels) plane = Plane(picture.width, picture.height);
  Plane grey(picture.width, picture.height);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Rgb& p = picture.pixels[i];
    const Triple v = opponent_from_rgb({linear_of_srgb(p[0]), linear_of_srgb(p[1]), linear_of_srgb(p[2])});
    for (std::size_t k = 0; k < 3; ++k) channels[k].pixels[i] = v[k];
    grey.pixels[i] = (v[0] + 16) / 116;
  }
  for (std::size_t k = 0; k < 3; ++k) channels[k] = seen(channels[k], kSensitivities[k], pixels_per_degree);
  Sight out;
  out.lab = PixelGrid<Triple>(picture.width, picture.height);
  for (std::size_t i = 0; i < out.lab.pixels.size(); ++i) {
    Triple rgb = rgb_from_opponent({channels[0].pixels[i], channels[1].pixels[i], channels[2].pixels[i]});
    for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
    out.lab.pixels[i] = hunt_lab(rgb);
  }
  const double sd = 0.5 * kEdgeWidth_deg * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sd));
  const auto bell = [&](int k) { return std::exp(-k * k / (2 * sd * sd)); };
  const Kernel gaussian = kernel_of(radius, bell);
  const Kernel edge = balanced(kernel_of(radius, [&](int k) { return -k * bell(k); }), gaussian);
  const Kernel point = balanced(kernel_of(radius, [&](int k) { return (k * k / (sd * sd) - 1) * bell(k); }), gaussian);
  const auto strength = [&](const Kernel& derivative) {
    Plane x = filtered(grey, derivative, gaussian);
    const Plane y = filtered(grey, gaussian, derivative);
    for (std::size_t i = 0; i < x.pixels.size(); ++i) x.pixels[i] = std::hypot(x.pixels[i], y.pixels[i]);
    return x;
  };
  out.edges = strength(edge);
  out.points = strength(point);
  return out;
}

}  // namespace

struct FlipReference::Seen {
  Sight sight;
};

FlipReference::FlipReference(const Picture& reference, double pixels_per_degree)
    : seen_(std::make_shared<Seen>(Seen{look_at(reference, pixels_per_degree)})),
      pixels_per_degree_(pixels_per_degree) {}

PixelGrid<float> FlipReference::map(const Picture& test) const {
  const Sight& a = seen_->sight;
  assert(a.lab.width == test.width && a.lab.height == test.height);
  const Sight b = look_at(test, pixels_per_degree_);
  PixelGrid<float> out(test.width, test.height);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const double feature =
        std::max(std::abs(a.edges.pixels[i] - b.edges.pixels[i]), std::abs(a.points.pixels[i] - b.points.pixels[i]));
    const double exponent = 1 - std::pow(feature / std::numbers::sqrt2, kFeaturePower);
    out.pixels[i] = static_cast<float>(std::pow(colour_error(a.lab.pixels[i], b.lab.pixels[i]), exponent));
  }
  return out;
}

PixelGrid<float> flip_map(const Picture& reference, const Picture& test, double pixels_per_degree) {
  assert(reference.width == test.width && reference.height == test.height);
  return FlipReference(reference, pixels_per_degree).map(test);
}

double flip_mean(const Picture& reference, const Picture& test, double pixels_per_degree) {
  return summary_of(flip_map(reference, test, pixels_per_degree).pixels).mean;
}

ErrorSummary summary_of(std::vector<float> errors) {
  ErrorSummary out;
  if (errors.empty()) return out;
  for (const float e : errors) out.mean += e;
  out.mean /= static_cast<double>(errors.size());
  const auto at = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) * 99 / 100);
  std::nth_element(errors.begin(), at, errors.end());
  out.p99 = *at;
  out.max = *std::max_element(errors.begin(), errors.end());
  return out;
}

}  // namespace vicus
