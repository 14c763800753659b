#pragma once
#include <memory>
#include <optional>

#include "sectorgen/bake/render/render_mesh.hpp"

namespace vicus {

/// A mesh ready for rays.
class RayScene {
 public:
  /// Fails   CityError: out of memory.
  explicit RayScene(RenderMesh mesh);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  struct Hit {
    double t = 0;  ///< place = from + way * t
    std::uint32_t triangle = 0;
    double u = 0, v = 0;  ///< weights of the triangle's second and third corner
  };
  /// The first triangle that shows its outside to the ray (or has two) at t > `least`. `way` may have any length.
  /// Thread-safe.   Error  of 32-bit floats.
  std::optional<Hit> first_hit(const Vec3& from, const Vec3& way, double least) const;

  const RenderMesh& mesh() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vicus
