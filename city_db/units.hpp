#pragma once
#include <cmath>
#include <compare>
#include <cstdint>

/// One plain type per frame (DESIGN §2); the compiler refuses mixtures.
namespace vicus {

/// WGS84, degrees.
struct LatLon {
  double lat_deg = 0, lon_deg = 0;
};

/// Plan frame on the lattice: x = east, y = north, **millimetres** from the city's origin.
/// Needs |x|, |y| < 2^30, so that orient2d is exact in 64-bit integers.
struct PlanPoint {
  std::int32_t x = 0, y = 0;
  friend auto operator<=>(const PlanPoint&, const PlanPoint&) = default;
};
inline constexpr std::int32_t kPlanLimit = 1 << 30;
inline constexpr double kMmPerMetre = 1000.0;

/// Plan frame with height: metres from the city's origin, up above the terrain (or above 0 where there is none).
struct Enu {
  double east = 0, north = 0, up = 0;
};

/// X3D axes, metres, in some sector's frame: x = east, y = up, z = -north. Conversions: x3d_export/frames.hpp only.
inline double metres(std::int64_t mm) { return static_cast<double>(mm) / kMmPerMetre; }
/// Inverse of metres() for every lattice value: the nearest millimetre.
inline std::int32_t lattice_mm(double m) { return static_cast<std::int32_t>(std::llround(m * kMmPerMetre)); }

/// Axis-parallel box of plan points, closed; empty when min > max.
struct PlanBox {
  PlanPoint min{kPlanLimit, kPlanLimit}, max{-kPlanLimit, -kPlanLimit};
  void add(PlanPoint p) {
    if (p.x < min.x) min.x = p.x;
    if (p.y < min.y) min.y = p.y;
    if (p.x > max.x) max.x = p.x;
    if (p.y > max.y) max.y = p.y;
  }
  bool is_empty() const { return min.x > max.x; }
  bool contains(PlanPoint p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
};

}  // namespace vicus
