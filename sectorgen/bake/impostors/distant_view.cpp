#include "sectorgen/bake/impostors/distant_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "city_db/steady_hash.hpp"
#include "city_db/surroundings.hpp"
#include "sectorgen/bake/render/shading.hpp"

namespace vicus {
namespace {

constexpr double kHaze_m = 260;     // after so many metres 63 % of a colour is haze
constexpr double kSkyline_m = 300;  // where the distant houses stand
constexpr double kHouse_m = 14, kLow_m = 6, kHigh_m = 15;
constexpr Colour kHouses{168, 158, 150};

Rgb rgb_of(Colour c) {
  return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255};
}
Rgb mixed(const Rgb& a, const Rgb& b, double share_of_b) {
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = a[k] + static_cast<float>(share_of_b) * (b[k] - a[k]);
  return out;
}
Rgb in_haze(const Rgb& colour, double metres) {
  return mixed(colour, rgb_of(kSkyColour), 1 - std::exp(-metres / kHaze_m));
}

double house_top_m(double azimuth) {
  const auto number = static_cast<std::int64_t>(std::floor(azimuth * kSkyline_m / kHouse_m));
  return kLow_m + (kHigh_m - kLow_m) * static_cast<double>(steady_hash(std::to_string(number)) % 1000) / 1000;
}

Rgb beyond(const Vec3& eye, const Vec3& way, double ground_m, Colour ground) {
  const double flat = std::hypot(way[0], way[1]);
  const double rise = flat > 0 ? way[2] / flat : 1;
  const double eye_m = eye[2] - ground_m;
  if (rise < 0 && eye_m / -rise < kSkyline_m) {
    Rgb lit = rgb_of(ground);
    for (float& v : lit) v = std::min(1.0f, v * static_cast<float>(light_on({0, 0, 1})));
    return in_haze(lit, eye_m / -rise);
  }
  if (eye_m + rise * kSkyline_m < house_top_m(std::atan2(way[0], way[1]))) return in_haze(rgb_of(kHouses), kSkyline_m);
  return sky_colour(way);
}

}  // namespace

Picture with_distance(const View& view, const Camera& camera, double ground_m, Colour ground) {
  Picture out = colours_of(view.cut_out);
  const int side = 3;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const float hole = 1 - view.coverage.at(x, y);
      if (hole <= 0) continue;
      Rgb sum{};
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const double u = (x + (i + 0.5) / side) / out.width, v = (y + (j + 0.5) / side) / out.height;
          const Vec3 way = camera.ahead +
                           camera.right * (camera.left_side + u * (camera.right_side - camera.left_side)) +
                           camera.above * (camera.top_side + v * (camera.bottom_side - camera.top_side));
          const Rgb seen = beyond(camera.eye, way, ground_m, ground);
          for (std::size_t k = 0; k < 3; ++k) sum[k] += seen[k] / (side * side);
        }
      out.at(x, y) = mixed(out.at(x, y), sum, hole);
    }
  return out;
}

}  // namespace vicus
