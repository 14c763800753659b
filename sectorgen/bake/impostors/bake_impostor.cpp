#include "sectorgen/bake/impostors/bake_impostor.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "city_db/run_parallel.hpp"
#include "city_db/surface_colour.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/bake/impostors/capture_point.hpp"
#include "sectorgen/bake/impostors/cut_out_png.hpp"
#include "sectorgen/bake/impostors/distant_view.hpp"
#include "sectorgen/bake/render/render.hpp"

namespace vicus {
namespace {

constexpr double kEye_m = 1.7;
constexpr double kNarrowest_m = 0.5;
constexpr double kBelow_m = 0.15;  // kerbs and gutters at the gate
constexpr double kTallest_m = 40;  // of a picture
constexpr double kLowest_m = 3;
constexpr double kPast_m = 0.02;  // what begins in the gate's plane is the sector's own
constexpr int kLeast_px = 32;
constexpr double kMargin = 1.05;  // of the top over what is seen

Vec3 place(PlanPoint p) { return {metres(p.x), metres(p.y), 0}; }
PlanPoint lattice(const Vec3& p) { return {lattice_mm(p[0]), lattice_mm(p[1])}; }

int power_of_two(double px, int most) {
  int side = kLeast_px;
  while (side < px && side < most) side *= 2;
  return side;
}

/// Below the ground at the gate there is nothing to see; where the ground lies lower than the terrain says, by a kerb,
/// the picture goes on downwards.
CutOut with_foot(CutOut picture) {
  const int lowest = picture.height - 1 - picture.height / 8;
  for (int x = 0; x < picture.width; ++x) {
    int last = picture.height - 1;
    while (last >= lowest && picture.at(x, last)[3] < 0.999f) --last;
    for (int y = last + 1; last >= lowest && y < picture.height; ++y) picture.at(x, y) = picture.at(x, last);
  }
  return picture;
}

class ImpostorBaker {
 public:
  ImpostorBaker(const CityGround& ground, const RayScene& scene, const Gate& gate, const ImpostorOptions& options)
      : ground_(ground), scene_(scene), gate_(gate), options_(options) {}

  std::optional<GateImpostor> run() {
    const Sector* sector = ground_.sector(gate_.sector_id);
    const GateWindow window = window_of(gate_);
    const Vec3 left = place(window.left), right = place(window.right);
    if (sector == nullptr || length(right - left) < kNarrowest_m) return std::nullopt;
    const PlanPoint eye = capture_point(*sector, gate_, options_.share);
    const auto ground = [&](PlanPoint p) { return height_m(ground_.terrain(), p); };
    out_.gate_id = gate_.id;
    out_.sector_id = gate_.sector_id;
    out_.eye = eye;
    out_.eye_up_m = ground(eye) + kEye_m;
    out_.is_solid = gate_.to_sector_id.empty();
    out_.bottom_m = std::min(ground(window.left), ground(window.right)) - kBelow_m;
    const Enu at{metres(eye.x), metres(eye.y), out_.eye_up_m};
    const auto camera_to = [&](double top_m) { return camera_through(at, left, right, out_.bottom_m, top_m); };
    const double tallest = out_.bottom_m + kTallest_m;
    out_.top_m = top_of_view(camera_to(tallest), tallest);
    if (out_.top_m <= out_.bottom_m && !out_.is_solid) return std::nullopt;
    out_.top_m = std::max(out_.top_m, std::max(ground(window.left), ground(window.right)) + kLowest_m);
    if (out_.is_solid)
      out_.top_m = std::max(out_.top_m, std::max(ground(window.left), ground(window.right)) + kCityEnd_m);
    const Camera camera = camera_to(out_.top_m);
    const View view = take(camera);
    find_depths(view);
    stand(camera, left, right);
    const Surface* surface = surface_at(window);
    const Colour colour = surface != nullptr ? surface_colour(surface->kind) : ground_colour(sector->kind);
    pack(out_.is_solid ? opaque(with_distance(view, camera, ground(window.left), colour)) : with_foot(view.cut_out));
    return std::move(out_);
  }

 private:
  static constexpr double kCityEnd_m = 15;  // as the faces there are without a picture

  double gate_distance(const Camera& camera) const {
    return dot(place(window_of(gate_).left) - Vec3{camera.eye[0], camera.eye[1], 0}, camera.ahead);
  }

  RenderOptions size_of(const Camera& camera) const {
    // As many pixels as from the capture point, and as many again for who comes nearer.
    const double unit = 2 * kViewUnit_px;
    RenderOptions size;
    size.width = power_of_two(unit * (camera.right_side - camera.left_side), options_.most_px);
    size.height = power_of_two(unit * (camera.top_side - camera.bottom_side), options_.most_px);
    size.samples = options_.samples;
    size.near_m = gate_distance(camera) + kPast_m;
    return size;
  }

  View take(const Camera& camera) const { return render(scene_, camera, size_of(camera)); }

  /// Height in the gate's plane of the highest thing seen in it; the bottom: nothing.
  double top_of_view(const Camera& camera, double tallest) const {
    RenderOptions coarse{24, 96, 1, gate_distance(camera) + kPast_m, 1};
    const View view = render(scene_, camera, coarse);
    int first = coarse.height;
    for (int row = coarse.height - 1; row >= 0; --row)
      for (int column = 0; column < coarse.width; ++column)
        if (std::isfinite(view.depth.at(column, row))) first = row;
    if (first == coarse.height) return out_.bottom_m;
    const double share = 1 - static_cast<double>(std::max(0, first - 1)) / coarse.height;
    return std::min(tallest, out_.bottom_m + share * kMargin * (tallest - out_.bottom_m));
  }

  void find_depths(const View& view) {
    float near = INFINITY, far = 0;
    for (const float d : view.depth.pixels) {
      if (!std::isfinite(d)) continue;
      near = std::min(near, d);
      far = std::max(far, d);
    }
    if (far == 0) return;
    out_.near_m = near;
    out_.far_m = far;
  }

  /// The rectangle in the gate, or moved away from the eye to the best plane.
  void stand(const Camera& camera, const Vec3& left, const Vec3& right) {
    const double gate_m = gate_distance(camera);
    const double inverse = out_.far_m > 0 ? (1 / out_.near_m + 1 / out_.far_m) / 2 : 1 / gate_m;
    out_.plane_m = options_.plane == ImpostorPlane::gate ? gate_m : std::max(gate_m, 1 / inverse);
    const double k = out_.plane_m / gate_m;
    const Vec3 foot{camera.eye[0], camera.eye[1], 0};
    out_.left = lattice(foot + (left - foot) * k);
    out_.right = lattice(foot + (right - foot) * k);
    out_.bottom_m = out_.eye_up_m + (out_.bottom_m - out_.eye_up_m) * k;
    out_.top_m = out_.eye_up_m + (out_.top_m - out_.eye_up_m) * k;
    double worst = 0;
    for (const double thing : {out_.near_m, out_.far_m})
      if (thing > 0) worst = std::max(worst, displacement_px(kViewUnit_px, 1, out_.plane_m, thing));
    constexpr double kAnywhere_m = 1000;
    out_.radius_m = worst > 0 ? std::min(kAnywhere_m, kValid_px / worst) : kAnywhere_m;
  }

  /// What the ground at the gate's middle is made of.
  const Surface* surface_at(const GateWindow& window) const {
    const Surface* best = nullptr;
    double least = INFINITY;
    for (const Surface* s : ground_.surfaces_of(gate_.sector_id)) {
      if (s->kind == SurfaceKind::kerb || s->kind == SurfaceKind::rail) continue;
      for (const GroundPoint& p : s->points) {
        const double d = std::hypot(p.at.x - (double(window.left.x) + window.right.x) / 2,
                                    p.at.y - (double(window.left.y) + window.right.y) / 2);
        if (d < least) {
          least = d;
          best = s;
        }
      }
    }
    return best;
  }

  void pack(const CutOut& picture) {
    out_.width_px = static_cast<std::uint32_t>(picture.width);
    out_.height_px = static_cast<std::uint32_t>(picture.height);
    out_.png = cut_out_png(std::span(&picture, 1), options_.colours);
  }

  const CityGround& ground_;
  const RayScene& scene_;
  const Gate& gate_;
  const ImpostorOptions& options_;
  GateImpostor out_;
};

}  // namespace

double displacement_px(double unit_px, double away_m, double plane_m, double thing_m) {
  return unit_px * away_m * std::abs(1 / plane_m - 1 / thing_m);
}

std::optional<GateImpostor> bake_impostor(const CityGround& ground, const RayScene& scene, const Gate& gate,
                                          const ImpostorOptions& options) {
  return ImpostorBaker(ground, scene, gate, options).run();
}

std::vector<GateImpostor> bake_impostors(const City& city, const RayScene& scene, const ImpostorOptions& options,
                                         const std::function<void(std::size_t)>& on_gate) {
  const CityGround ground(city);
  const auto& gates = city.gates;
  std::vector<std::optional<GateImpostor>> found(gates.size());
  std::atomic<std::size_t> done{0};
  run_parallel(gates.size(), thread_count(options.threads), [&](std::size_t i, unsigned) {
    found[i] = bake_impostor(ground, scene, gates[i], options);
    const std::size_t count = ++done;
    if (on_gate) on_gate(count);
  });
  std::vector<GateImpostor> out;
  for (auto& impostor : found)
    if (impostor) out.push_back(std::move(*impostor));
  return out;
}

}  // namespace vicus
