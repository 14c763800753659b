#pragma once
#include "sectorgen/bake/picture/picture.hpp"
#include "sectorgen/bake/render/ray_scene.hpp"
#include "sectorgen/bake/render/shading.hpp"

namespace vicus {

struct RenderOptions {
  int width = 640, height = 480;
  int samples = 16;      ///< a pixel: the next square number
  double near_m = 0.05;  ///< what is nearer ahead of the eye is not there
  unsigned threads = 1;  ///< 0: all cores
};

struct View {
  Picture colour;     ///< with the sky
  Coverage coverage;  ///< share of samples that met something, less what shines through it
  DepthMap depth;
  PixelGrid<Rgba> cut_out;  ///< colours without the sky, and coverage as opacity
};

/// Anything that rays meet: triangles, tiles of a height field, both.
class Tracer {
 public:
  virtual ~Tracer() = default;
  struct Met {
    double t = 0;  ///< place = from + sample.way * t
    Rgba shown{};  ///< colour times opacity, opacity
  };
  /// The first thing at t > `least`. Thread-safe.
  virtual std::optional<Met> meet(const Vec3& from, const RaySample& sample, double least) const = 0;
  /// Its t alone.
  virtual std::optional<double> distance(const Vec3& from, const Vec3& way, double least) const = 0;
};

/// Triangles as a Tracer.   Needs   `scene` outlives it.
class SceneTracer : public Tracer {
 public:
  explicit SceneTracer(const RayScene& scene) : scene_(&scene) {}
  std::optional<Met> meet(const Vec3& from, const RaySample& sample, double least) const override;
  std::optional<double> distance(const Vec3& from, const Vec3& way, double least) const override;

 private:
  const RayScene* scene_;
};

/// What the camera sees: a regular grid of samples in each pixel, images as means over each sample's area.
/// Exact   equal bytes for any number of threads.   Cost  about 1 us a sample and core.
/// Needs   width, height, samples > 0 (assert).
View render(const Tracer& tracer, const Camera& camera, const RenderOptions& options);
View render(const RayScene& scene, const Camera& camera, const RenderOptions& options);

}  // namespace vicus
