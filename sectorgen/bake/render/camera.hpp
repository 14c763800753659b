#pragma once
#include <array>

#include "city_db/units.hpp"

namespace vicus {

using Vec3 = std::array<double, 3>;  ///< plan frame: east, north, up; metres where it is a place

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 operator*(const Vec3& a, double k) { return {a[0] * k, a[1] * k, a[2] * k}; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vec3& v);

/// An eye before a window: the picture is what it sees through that, wherever the window lies before it.
/// Frame   ahead, right and above have length 1 and stand upright on each other; the window is at distance 1 ahead:
///         its sides in metres to the right and above of where `ahead` meets it.
struct Camera {
  Vec3 eye{};
  Vec3 ahead{0, 1, 0}, right{1, 0, 0}, above{0, 0, 1};
  double left_side = -1, right_side = 1, bottom_side = -1, top_side = 1;
};

/// Looks from `eye` at `look`, upright; `field_of_view` (rad) is that of the picture's smaller side, as X3D's Viewpoint
/// has it.   Needs   eye != look (assert); width, height > 0 (assert). Looking straight up or down, north is above.
Camera camera_at(Enu eye, Enu look, double field_of_view, int width, int height);

/// Looks at the upright rectangle over `left` -> `right` (as seen from the eye), which fills the picture to the
/// millimetre: the view through a gate.
/// Needs   left != right, bottom < top, the eye before the rectangle's plane (assert).
Camera camera_through(Enu eye, Vec3 left, Vec3 right, double bottom_m, double top_m);

/// Where a place is seen: x 0 ... 1 from the left, y 0 ... 1 from the top of the window; z metres ahead.
/// Needs   z > 0 for x and y to mean anything.
Vec3 seen_at(const Camera& camera, const Vec3& place);

}  // namespace vicus
