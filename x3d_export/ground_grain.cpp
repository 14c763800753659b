#include "x3d_export/ground_grain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "city_db/ground_grain.hpp"
#include "x3d_export/colours.hpp"

namespace vicus {
namespace {

constexpr double kLeastSide_m = 0.5;

/// Along X3D's axes, metres.
std::array<double, 3> extent_of(std::span<const Face> faces) {
  constexpr auto kFar = std::numeric_limits<std::int32_t>::max();
  std::array<std::int32_t, 3> low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const Face& face : faces)
    for (int k = 0; k < face.count; ++k) {
      const X3dPoint p = face.corners[static_cast<std::size_t>(k)];
      const std::array at{p.x, p.y, p.z};
      for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], at[i]), high[i] = std::max(high[i], at[i]);
    }
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = metres(std::int64_t{high[i]} - low[i]);
  return out;
}

}  // namespace

Node grained_shape(const std::string& def, std::span<const Face> faces, const std::string& url) {
  const auto [wide, tall, deep] = extent_of(faces);
  // The longest and the next side are the image's axes: they must be those of the plan.
  if (std::min(wide, deep) <= tall || std::min(wide, deep) < kLeastSide_m) return shape_of(def, Shading::solid, faces);
  std::vector<Face> lighter(faces.begin(), faces.end());
  for (Face& face : lighter) face.colour = shaded(face.colour, 1 / kGrainMean);
  Node shape = shape_of(def, Shading::solid, lighter);
  // Three decimals: the image is as wide as it should be within 1 mm.
  const double times = std::round(std::max(wide, deep) / kGrainSide_m * 1000) / 1000;
  Node texture("ImageTexture"), transform("TextureTransform");
  texture.set("url", std::vector<std::string>{url});
  transform.set("scale", std::vector<double>{times, times});
  for (NodeField& field : shape.nodes)
    if (field.name == "appearance")
      field.nodes.at(0).add("texture", std::move(texture)).add("textureTransform", std::move(transform));
  return shape;
}

}  // namespace vicus
