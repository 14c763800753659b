#pragma once
#include "sectorgen/bake/picture/picture.hpp"
#include "sectorgen/bake/render/ray_scene.hpp"

/// Colours as an X3D browser gives them in our root world: city_db/surroundings.hpp has light and sky.
namespace vicus {

/// The Background in the direction `way` (any length).
Rgb sky_colour(const Vec3& way);

/// Sum of all lights on a face with this normal (any length), as one factor of its colour; never above 1 together with
/// a colour channel.
double light_on(const Vec3& normal);

/// One sample's area: `across` and `down` are how `way` changes from it to the next ones.
struct RaySample {
  Vec3 way{}, across{}, down{};
};

/// What a face shows to the ray that met it: colour times opacity, opacity.
Rgba shown(const RayScene& scene, const RayScene::Hit& hit, const RaySample& sample);

}  // namespace vicus
