#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "city_db/colour.hpp"
#include "sectorgen/bake/render/camera.hpp"
#include "sectorgen/bake/render/image.hpp"

namespace vicus {

inline constexpr std::uint32_t kNoImage = UINT32_MAX;

struct RenderTriangle {
  std::array<std::uint32_t, 3> corners;  ///< counter-clockwise seen from outside
  Colour colour;                         ///< without image
  bool is_two_sided = false;
  bool is_lit = true;              ///< false: shows its colour or image as it is
  std::uint32_t image = kNoImage;  ///< of RenderMesh::images
  std::uint32_t places = 0;        ///< with image: of RenderMesh::places
};

/// Triangles to trace rays through, of a city or of anything else.
/// Frame   plan frame, metres from `origin`, as 32-bit floats: 1 mm within 8 km.
struct RenderMesh {
  Vec3 origin{};
  std::vector<std::array<float, 3>> points;
  std::vector<RenderTriangle> triangles;
  std::vector<std::array<std::array<float, 2>, 3>> places;  ///< of the corners in the image: u from left, v from bottom
  std::vector<std::shared_ptr<const RepeatedImage>> images;  ///< meshes of one city can have them in common

  std::uint32_t add_point(const Vec3& p) {
    const Vec3 q = p - origin;
    points.push_back({static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2])});
    return static_cast<std::uint32_t>(points.size() - 1);
  }
};

}  // namespace vicus
