#include "sectorgen/bake/render/render.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "city_db/run_parallel.hpp"

namespace vicus {
namespace {

constexpr int kMostLayers = 8;  // cut-outs one behind the other

class Renderer {
 public:
  Renderer(const Tracer& tracer, const Camera& camera, const RenderOptions& options)
      : tracer_(tracer),
        camera_(camera),
        options_(options),
        side_(static_cast<int>(std::ceil(std::sqrt(options.samples) - 1e-9))) {
    across_ = camera.right * ((camera.right_side - camera.left_side) / options.width / side_);
    down_ = camera.above * ((camera.bottom_side - camera.top_side) / options.height / side_);
    view_.colour = Picture(options.width, options.height);
    view_.coverage = Coverage(options.width, options.height);
    view_.depth = DepthMap(options.width, options.height);
    view_.cut_out = PixelGrid<Rgba>(options.width, options.height);
  }

  View run() {
    run_parallel(static_cast<std::size_t>(options_.height), thread_count(options_.threads),
                 [this](std::size_t row, unsigned) {
                   for (int column = 0; column < options_.width; ++column) draw(column, static_cast<int>(row));
                 });
    return std::move(view_);
  }

 private:
  /// `x`, `y` in samples from the top left corner.
  Vec3 way(double x, double y) const {
    return camera_.ahead + camera_.right * camera_.left_side + camera_.above * camera_.top_side + across_ * x +
           down_ * y;
  }

  /// `first`: t of the first thing met.
  Rgba sample(const Vec3& way, std::optional<double>& first) const {
    Rgba sum{};
    double near = options_.near_m;
    for (int layer = 0; layer < kMostLayers && sum[3] < 0.999f; ++layer) {
      const auto met = tracer_.meet(camera_.eye, {way, across_, down_}, near);
      if (!met) break;
      if (layer == 0) first = met->t;
      const float rest = 1 - sum[3];
      for (std::size_t k = 0; k < 4; ++k) sum[k] += rest * met->shown[k];
      near = met->t * (1 + 1e-6) + 1e-6;
    }
    return sum;
  }

  void draw(int column, int row) {
    std::array<double, 4> sum{};
    std::array<double, 3> sky{};
    std::optional<double> middle;  // t at the pixel's middle
    for (int j = 0; j < side_; ++j)
      for (int i = 0; i < side_; ++i) {
        const Vec3 ray = way(column * side_ + i + 0.5, row * side_ + j + 0.5);
        std::optional<double> first;
        const Rgba seen = sample(ray, first);
        if (2 * i + 1 == side_ && 2 * j + 1 == side_) middle = first;
        for (std::size_t k = 0; k < 4; ++k) sum[k] += seen[k];
        if (seen[3] >= 0.999f) continue;
        const Rgb behind = sky_colour(ray);
        for (std::size_t k = 0; k < 3; ++k) sky[k] += (1 - seen[3]) * behind[k];
      }
    const double count = side_ * side_, opacity = sum[3] / count;
    for (std::size_t k = 0; k < 3; ++k) {
      view_.colour.at(column, row)[k] = static_cast<float>((sum[k] + sky[k]) / count);
      view_.cut_out.at(column, row)[k] = sum[3] > 0 ? static_cast<float>(sum[k] / sum[3]) : 0;
    }
    view_.cut_out.at(column, row)[3] = view_.coverage.at(column, row) = static_cast<float>(opacity);
    if (side_ % 2 == 0)  // else a sample was there
      middle = tracer_.distance(camera_.eye, way((column + 0.5) * side_, (row + 0.5) * side_), options_.near_m);
    view_.depth.at(column, row) = middle ? static_cast<float>(*middle) : std::numeric_limits<float>::infinity();
  }

  const Tracer& tracer_;
  const Camera& camera_;
  RenderOptions options_;
  int side_;
  Vec3 across_{}, down_{};
  View view_;
};

}  // namespace

std::optional<Tracer::Met> SceneTracer::meet(const Vec3& from, const RaySample& sample, double least) const {
  const auto hit = scene_->first_hit(from, sample.way, least);
  if (!hit) return std::nullopt;
  return Met{hit->t, shown(*scene_, *hit, sample)};
}

std::optional<double> SceneTracer::distance(const Vec3& from, const Vec3& way, double least) const {
  const auto hit = scene_->first_hit(from, way, least);
  return hit ? std::optional(hit->t) : std::nullopt;
}

View render(const Tracer& tracer, const Camera& camera, const RenderOptions& options) {
  assert(options.width > 0 && options.height > 0 && options.samples > 0);
  return Renderer(tracer, camera, options).run();
}

View render(const RayScene& scene, const Camera& camera, const RenderOptions& options) {
  return render(SceneTracer(scene), camera, options);
}

}  // namespace vicus
