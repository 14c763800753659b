#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sectorgen/bake/bake_scene.hpp"
#include "sectorgen/bake/blockmap_caster.hpp"
#include "sectorgen/bake/blockmap_colours.hpp"
#include "tests/support/ray_scene.hpp"

/// Views from the air: cameras, pictures, and the true city by Embree with its facades.
namespace vicus::test {

/// A pinhole camera: `width` x `height` pixels, vertical angle of view 45 degrees.
struct Camera {
  double x = 0, y = 0, z = 0;  ///< metres in the plan frame
  double forward[3], right[3], up[3];
  int width = 640, height = 480;
  PlanRay ray(double column, double row) const;
  double pixels_per_radian() const;
};
Camera camera_at(double x, double y, double z, double to_x, double to_y, double to_z, int width, int height);
/// Looks at (x, y, up) from `distance` away, `elevation` degrees up, from the compass direction `azimuth`.
Camera camera_around(double x, double y, double up, double distance, double elevation_deg, double azimuth_deg,
                     int width, int height);

/// What one pixel shows.
struct Seen {
  double t = std::numeric_limits<double>::infinity();
  HitLook look;
};
/// One picture: what each pixel's middle shows.
struct View {
  int width = 0, height = 0;
  std::vector<Seen> pixels;
};
inline constexpr Colour kSky{196, 213, 228};
/// Lit by the world's lights; `with_ambient`: times the ambient light.
Colour lit(const HitLook& look, bool with_ambient);
RgbImage picture_of(const View& view, bool with_ambient);
void write_png(const std::filesystem::path& path, const RgbImage& image);

/// The true city, houses without their undersides, within a square of the plan; ground is the terrain.
class TrueCity {
 public:
  TrueCity(const BakeScene& scene, const PlanBox& box);
  ~TrueCity();
  TrueCity(const TrueCity&) = delete;
  TrueCity& operator=(const TrueCity&) = delete;
  Seen see(const PlanRay& ray) const;
  View view(const Camera& camera) const;
  /// Distance of a point from the nearest surface, at most `reach`.
  double distance(double x, double y, double z, double reach) const;

 private:
  struct Face;
  std::uint32_t add_point(double x, double y, double z);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face);
  void add_house(std::uint32_t index);
  void add_ground(const PlanBox& box);
  void commit();
  const BakeScene& scene_;
  double middle_x_, middle_y_;
  std::vector<float> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> face_of_;
  std::vector<Face> faces_;
  RTCDevice device_ = nullptr;
  RTCScene scene3_ = nullptr;
};

/// Tiles to look at together.
struct DrawnTile {
  explicit DrawnTile(BlockMap baked);
  std::unique_ptr<BlockMap> map;
  BlockMapCaster caster;
  BlockMapColours colours;
};
View view_of(const std::vector<std::unique_ptr<DrawnTile>>& tiles, const Camera& camera);

}  // namespace vicus::test
