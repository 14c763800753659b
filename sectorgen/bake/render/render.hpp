#pragma once
#include "sectorgen/bake/picture/picture.hpp"
#include "sectorgen/bake/render/ray_scene.hpp"

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

/// What the camera sees: a regular grid of samples in each pixel, images as means over each sample's area.
/// Exact   equal bytes for any number of threads.   Cost  about 1 us a sample and core.
/// Needs   width, height, samples > 0 (assert).
View render(const RayScene& scene, const Camera& camera, const RenderOptions& options);

}  // namespace vicus
