#include "sectorgen/bake/render/shading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "city_db/surroundings.hpp"

namespace vicus {
namespace {

float channel(std::uint8_t v) { return static_cast<float>(v) / 255; }
Rgb rgb_of(Colour c) { return {channel(c.r), channel(c.g), channel(c.b)}; }

/// Colours at angles from an axis, the first at 0; between them straight in value.
Rgb banded(double angle, std::span<const double> angles, std::span<const Colour> colours) {
  double before = 0;
  for (std::size_t i = 0; i < angles.size(); before = angles[i++]) {
    if (angle > angles[i]) continue;
    const auto share = static_cast<float>((angle - before) / (angles[i] - before));
    const Rgb a = rgb_of(colours[i]), b = rgb_of(colours[i + 1]);
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
  }
  return rgb_of(colours.back());
}

/// How a place in the image changes when a place on the triangle moves by `step`.
std::array<double, 2> moved(const std::array<std::array<float, 2>, 3>& places, const Vec3& e1, const Vec3& e2,
                            const Vec3& normal, const Vec3& step) {
  const double n2 = dot(normal, normal);
  const double a = dot(cross(step, e2), normal) / n2, b = dot(cross(e1, step), normal) / n2;
  std::array<double, 2> out{};
  for (std::size_t k = 0; k < 2; ++k)
    out[k] = a * (double{places[1][k]} - places[0][k]) + b * (double{places[2][k]} - places[0][k]);
  return out;
}

}  // namespace

Rgb sky_colour(const Vec3& way) {
  const double up = std::clamp(way[2] / length(way), -1.0, 1.0), angle = std::acos(up);
  if (up >= 0) return banded(angle, kSkyAngles, kSkyColours);
  return banded(std::numbers::pi - angle, kGroundAngles, kGroundColours);
}

double light_on(const Vec3& normal) { return light_on(normal[0], normal[1], normal[2]); }

Rgba shown(const RayScene& scene, const RayScene::Hit& hit, const RaySample& sample) {
  const RenderMesh& mesh = scene.mesh();
  const RenderTriangle& t = mesh.triangles[hit.triangle];
  const auto corner = [&](std::size_t k) {
    const auto& p = mesh.points[t.corners[k]];
    return Vec3{p[0], p[1], p[2]};
  };
  const Vec3 a = corner(0), e1 = corner(1) - a, e2 = corner(2) - a;
  Vec3 normal = cross(e1, e2);
  const double towards = dot(normal, sample.way);
  if (towards > 0) normal = normal * -1;
  const auto light = static_cast<float>(t.is_lit ? light_on(normal) : 1);
  Rgba colour{};
  if (t.image == kNoImage) {
    const Rgb plain = rgb_of(t.colour);
    colour = {plain[0], plain[1], plain[2], 1};
  } else {
    const auto& places = mesh.places[t.places];
    // A step of the ray beside it on the face's plane: t (step - way * (n . step) / (n . way)).
    const auto on_face = [&](const Vec3& step) {
      return (step - sample.way * (dot(normal, step) / dot(normal, sample.way))) * hit.t;
    };
    const auto x = moved(places, e1, e2, normal, on_face(sample.across)),
               y = moved(places, e1, e2, normal, on_face(sample.down));
    std::array<double, 2> at{};
    for (std::size_t k = 0; k < 2; ++k)
      at[k] = (1 - hit.u - hit.v) * places[0][k] + hit.u * places[1][k] + hit.v * places[2][k];
    colour = mesh.images[t.image]->mean(at[0], at[1], std::abs(x[0]) + std::abs(y[0]), std::abs(x[1]) + std::abs(y[1]));
  }
  for (std::size_t k = 0; k < 3; ++k) colour[k] = std::min(colour[3], colour[k] * light);
  return colour;
}

}  // namespace vicus
