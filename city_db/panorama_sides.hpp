#pragma once
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "city_db/city.hpp"

namespace vicus {

/// A panorama's edges stay on the lattice, wherever in the plan its eye is.
inline constexpr double kMostPanoramaRadius_m = 1e6;

/// One upright side of a panorama, seen from its eye: left and right edge in plan, and where it stands in the image.
struct PanoramaSide {
  int number = 0;
  PlanPoint left, right;
  double u_left = 0, u_right = 1;
};

/// The edge between side k - 1 and side k.
inline PlanPoint panorama_edge(PlanPoint eye, double radius_m, int k) {
  const double turn = 2 * std::numbers::pi * k / kPanoramaSides;
  return {eye.x + lattice_mm(radius_m * std::sin(turn)), eye.y + lattice_mm(radius_m * std::cos(turn))};
}

/// Those of its image, from the left.
inline std::vector<PanoramaSide> sides_of(const Panorama& p) {
  std::vector<PanoramaSide> sides;
  const double count = std::popcount(p.sides);
  for (int k = 0; k < kPanoramaSides; ++k)
    if (p.sides >> k & 1) {
      const auto i = static_cast<double>(sides.size());
      sides.push_back({k, panorama_edge(p.eye, p.radius_m, k), panorama_edge(p.eye, p.radius_m, k + 1), i / count,
                       (i + 1) / count});
    }
  return sides;
}

}  // namespace vicus
