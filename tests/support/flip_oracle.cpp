#include "tests/support/flip_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vicus::test {
namespace {

struct Colour3 {
  double a = 0, b = 0, c = 0;
};
constexpr double kPi = 3.14159265358979323846;

Colour3 xyz_of(Colour3 rgb) {
  return {0.4123907993 * rgb.a + 0.3575843394 * rgb.b + 0.1804807884 * rgb.c,
          0.2126390059 * rgb.a + 0.7151686788 * rgb.b + 0.0721923154 * rgb.c,
          0.0193308187 * rgb.a + 0.1191947798 * rgb.b + 0.9505321522 * rgb.c};
}
Colour3 rgb_of(Colour3 xyz) {
  return {3.2409699419 * xyz.a - 1.5373831776 * xyz.b - 0.4986107603 * xyz.c,
          -0.9692436363 * xyz.a + 1.8759675015 * xyz.b + 0.0415550574 * xyz.c,
          0.0556300797 * xyz.a - 0.2039769589 * xyz.b + 1.0569715142 * xyz.c};
}
constexpr double kXn = 0.9504559271, kZn = 1.0890577508;

double linear(double v) { return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92; }

Colour3 opponent_at(const Picture& picture, int x, int y) {
  const Rgb& p = picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1));
  const Colour3 xyz = xyz_of({linear(p[0]), linear(p[1]), linear(p[2])});
  return {116 * xyz.b - 16, 500 * (xyz.a / kXn - xyz.b), 200 * (xyz.b - xyz.c / kZn)};
}

Colour3 hunt_lab(Colour3 rgb) {
  const Colour3 xyz = xyz_of(rgb);
  const auto f = [](double t) { return t > 0.008856451679 ? std::cbrt(t) : 7.787037037 * t + 16.0 / 116; };
  const double l = 116 * f(xyz.b) - 16;
  return {l, l / 100 * 500 * (f(xyz.a / kXn) - f(xyz.b)), l / 100 * 200 * (f(xyz.b) - f(xyz.c / kZn))};
}

double hyab_power(Colour3 p, Colour3 q) {
  const double ab = std::sqrt((p.b - q.b) * (p.b - q.b) + (p.c - q.c) * (p.c - q.c));
  return std::pow(std::abs(p.a - q.a) + ab, 0.7);
}

/// What the eye sees of the pixel, as CIELAB after Hunt.
Colour3 seen_at(const Picture& picture, int x, int y, double ppd) {
  const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
  const auto weighted = [&](double a1, double b1, double a2, double b2, const std::function<double(Colour3)>& part) {
    double sum = 0, all = 0;
    for (int j = -r; j <= r; ++j)
      for (int i = -r; i <= r; ++i) {
        const double z = (i * i + j * j) / (ppd * ppd);
        const double w = a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * z / b1) +
                         a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * z / b2);
        all += w;
        sum += w * part(opponent_at(picture, x + i, y + j));
      }
    return sum / all;
  };
  const double y1 = weighted(1, 0.0047, 0, 1e-5, [](Colour3 c) { return c.a; });
  const double cx = weighted(1, 0.0053, 0, 1e-5, [](Colour3 c) { return c.b; });
  const double cz = weighted(34.1, 0.04, 13.5, 0.025, [](Colour3 c) { return c.c; });
  const double yn = (y1 + 16) / 116;
  const Colour3 rgb = rgb_of({(yn + cx / 500) * kXn, yn, (yn - cz / 200) * kZn});
  const auto unit = [](double v) { return std::min(1.0, std::max(0.0, v)); };
  return hunt_lab({unit(rgb.a), unit(rgb.b), unit(rgb.c)});
}

double feature_at(const Picture& picture, int x, int y, double ppd, bool is_point) {
  const double sd = 0.5 * 0.082 * ppd;
  const int r = static_cast<int>(std::ceil(3 * sd));
  const auto derivative = [&](int along, int across) {
    const double g = std::exp(-(along * along + across * across) / (2 * sd * sd));
    return is_point ? (along * along / (sd * sd) - 1) * g : -along * g;
  };
  double positive = 0, negative = 0;
  for (int j = -r; j <= r; ++j)
    for (int i = -r; i <= r; ++i) {
      const double w = derivative(i, j);
      (w > 0 ? positive : negative) += std::abs(w);
    }
  double sx = 0, sy = 0;
  for (int j = -r; j <= r; ++j)
    for (int i = -r; i <= r; ++i) {
      const double grey = (opponent_at(picture, x + i, y + j).a + 16) / 116;
      const auto balanced = [&](double w) { return w > 0 ? w / positive : w / negative; };
      sx += balanced(derivative(i, j)) * grey;
      sy += balanced(derivative(j, i)) * grey;
    }
  return std::sqrt(sx * sx + sy * sy);
}

}  // namespace

double slow_flip(const Picture& reference, const Picture& test, int x, int y, double ppd) {
  const double most = hyab_power(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
  const double power = hyab_power(seen_at(reference, x, y, ppd), seen_at(test, x, y, ppd));
  const double colour =
      power < 0.4 * most ? 0.95 * power / (0.4 * most) : 0.95 + 0.05 * (power - 0.4 * most) / (most - 0.4 * most);
  const double edge = std::abs(feature_at(reference, x, y, ppd, false) - feature_at(test, x, y, ppd, false));
  const double point = std::abs(feature_at(reference, x, y, ppd, true) - feature_at(test, x, y, ppd, true));
  return std::pow(colour, 1 - std::sqrt(std::max(edge, point) / std::sqrt(2.0)));
}

}  // namespace vicus::test
