#include "sectorgen/bake/render/camera.hpp"

#include <cassert>
#include <cmath>

namespace vicus {

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

Camera camera_at(Enu eye, Enu look, double field_of_view, int width, int height) {
  assert(width > 0 && height > 0);
  Camera camera;
  camera.eye = {eye.east, eye.north, eye.up};
  const Vec3 way = Vec3{look.east, look.north, look.up} - camera.eye;
  assert(length(way) > 0);
  camera.ahead = way * (1 / length(way));
  const Vec3 right = cross(camera.ahead, {0, 0, 1});
  constexpr double kStraight = 1e-9;  // looking straight up or down
  camera.right = length(right) > kStraight ? right * (1 / length(right)) : Vec3{1, 0, 0};
  camera.above = cross(camera.right, camera.ahead);
  const double half = std::tan(field_of_view / 2), smaller = width < height ? width : height;
  camera.right_side = half * width / smaller;
  camera.top_side = half * height / smaller;
  camera.left_side = -camera.right_side;
  camera.bottom_side = -camera.top_side;
  return camera;
}

Camera camera_through(Enu eye, Vec3 left, Vec3 right, double bottom_m, double top_m) {
  assert(bottom_m < top_m);
  Camera camera;
  camera.eye = {eye.east, eye.north, eye.up};
  left[2] = right[2] = 0;
  const double width = length(right - left);
  assert(width > 0);
  camera.right = (right - left) * (1 / width);
  camera.above = {0, 0, 1};
  camera.ahead = cross(camera.above, camera.right);
  const Vec3 from = left - Vec3{eye.east, eye.north, 0};
  const double distance = dot(from, camera.ahead);
  assert(distance > 0);
  camera.left_side = dot(from, camera.right) / distance;
  camera.right_side = camera.left_side + width / distance;
  camera.bottom_side = (bottom_m - eye.up) / distance;
  camera.top_side = (top_m - eye.up) / distance;
  return camera;
}

Vec3 seen_at(const Camera& c, const Vec3& place) {
  const Vec3 way = place - c.eye;
  const double z = dot(way, c.ahead);
  return {(dot(way, c.right) / z - c.left_side) / (c.right_side - c.left_side),
          (c.top_side - dot(way, c.above) / z) / (c.top_side - c.bottom_side), z};
}

}  // namespace vicus
