#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "city_db/colour.hpp"
#include "x3d_export/mesh.hpp"

/// What glTF's coders take of a face.
namespace vicus {

/// Flat, length 1; (0, 1, 0) of a face without area.
inline std::array<float, 3> face_normal(const std::array<X3dPoint, 4>& corners, int count) {
  const auto of = [](const X3dPoint& a, const X3dPoint& b, const X3dPoint& c) -> std::array<float, 3> {
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx, length = std::hypot(x, y, z);
    if (length == 0) return {0, 1, 0};
    return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
  };
  // A quad's first three corners may lie on one line; some three do not.
  if (count == 4 && corners[0] == corners[1]) return of(corners[0], corners[2], corners[3]);
  return of(corners[0], corners[1], corners[2]);
}

/// glTF's colours of vertices are linear.
inline std::array<std::uint8_t, 4> linear_rgba(Colour c) {
  const auto linear = [](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(255 * linear_of_srgb(channel / 255.0)));
  };
  return {linear(c.r), linear(c.g), linear(c.b), 255};
}

/// glTF's places run from the top.
inline std::array<std::array<float, 2>, 4> gltf_places(const TexturedFace& face) {
  std::array<std::array<float, 2>, 4> places;
  for (std::size_t k = 0; k < 4; ++k)
    places[k] = {static_cast<float>(face.uv[k][0]), static_cast<float>(1 - face.uv[k][1])};
  return places;
}

}  // namespace vicus
