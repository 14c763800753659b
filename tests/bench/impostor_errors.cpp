/// What pictures in gates are worth: impostor_errors CITY.gpkg [GATES] > impostors.csv
///
/// For gates spread over the city, from eyes in the gate's sector (middles of its ground's triangles that see the
/// gate's middle, at most five, and the capture point): the whole city as truth, the sector alone, and the sector with
/// one picture in one of several ways. Errors count in the pixels of the gate: where the sector alone is sky and the
/// truth is not. Columns: variant, gates, views, px (longer side), colours, kB (mean of a picture), ms (of baking, one
/// core), flip (mean in the gate's pixels), flip_all (of whole views), uncovered (share of the gate's pixels where the
/// sky still shows).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "city_db/store.hpp"
#include "city_db/terrain.hpp"
#include "cli/city_mesh.hpp"
#include "sectorgen/bake/impostors/bake_impostor.hpp"
#include "sectorgen/bake/impostors/capture_point.hpp"
#include "sectorgen/bake/impostors/impostor_mesh.hpp"
#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/render/render.hpp"

namespace {

using namespace vicus;

constexpr int kWidth = 400, kHeight = 250, kSamples = 4;
constexpr std::size_t kMostEyes = 5;
constexpr double kEye_m = 1.7, kView = 0.95;

struct Variant {
  const char* name;
  ImpostorOptions options;
  std::size_t pictures = 0, views = 0;
  double bytes = 0, seconds = 0, flip = 0, pixels = 0, flip_all = 0, uncovered = 0;
};

std::vector<Variant> variants() {
  const auto make = [](const char* name, ImpostorPlane plane, double share, int px, int colours) {
    Variant v{name, {}};
    v.options.plane = plane;
    v.options.share = share;
    v.options.most_px = px;
    v.options.colours = colours;
    v.options.threads = 1;
    return v;
  };
  using enum ImpostorPlane;
  return {make("none", gate, 1, 32, 2),
          make("gate, farthest", gate, 1, 128, 32),
          make("gate, middle", gate, 0.5, 128, 32),
          make("best, farthest", best, 1, 128, 32),
          make("best, middle", best, 0.5, 128, 32),
          make("gate, farthest", gate, 1, 64, 32),
          make("gate, farthest", gate, 1, 256, 32),
          make("gate, farthest", gate, 1, 128, 16),
          make("gate, farthest", gate, 1, 128, 64)};
}

std::vector<Camera> eyes_of(const City& city, const Sector& sector, const Gate& gate) {
  const GateWindow window = window_of(gate);
  const Vec3 left{metres(window.left.x), metres(window.left.y), 0},
      right{metres(window.right.x), metres(window.right.y), 0};
  const Vec3 middle = (left + right) * 0.5;
  std::vector<PlanPoint> points = sector.ground.outer, places{capture_point(sector, gate)};
  for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
  std::vector<PlanPoint> middles;
  const auto& t = sector.ground_triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const auto mean = [&](auto axis) {
      return static_cast<std::int32_t>(
          (std::int64_t{axis(points[t[i]])} + axis(points[t[i + 1]]) + axis(points[t[i + 2]])) / 3);
    };
    middles.push_back({mean([](PlanPoint p) { return p.x; }), mean([](PlanPoint p) { return p.y; })});
  }
  for (std::size_t i = 0; i < std::min(kMostEyes, middles.size()); ++i)
    places.push_back(middles[i * middles.size() / std::min(kMostEyes, middles.size())]);
  std::vector<Camera> out;
  for (const PlanPoint p : places) {
    const Enu eye{metres(p.x), metres(p.y), height_m(city.terrain, p) + kEye_m};
    const Vec3 way = middle - Vec3{eye.east, eye.north, 0};
    if (dot(cross({0, 0, 1}, right - left), way) < 1) continue;  // beside or behind the gate
    out.push_back(camera_at(eye, {middle[0], middle[1], eye.up}, kView, kWidth, kHeight));
  }
  return out;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Does the ray through the pixel's middle pass the gate, at whatever height?
bool passes(const Camera& camera, const Gate& gate, std::size_t pixel) {
  const double x = (static_cast<double>(pixel % kWidth) + 0.5) / kWidth,
               y = (static_cast<double>(pixel / kWidth) + 0.5) / kHeight;
  const Vec3 way = camera.ahead + camera.right * (camera.left_side + x * (camera.right_side - camera.left_side)) +
                   camera.above * (camera.top_side + y * (camera.bottom_side - camera.top_side));
  const GateWindow window = window_of(gate);
  const Vec3 left{metres(window.left.x), metres(window.left.y), 0},
      right{metres(window.right.x), metres(window.right.y), 0};
  const Vec3 along = right - left, normal = cross({0, 0, 1}, along),
             from = left - Vec3{camera.eye[0], camera.eye[1], 0};
  const double t = dot(from, normal) / dot(way, normal);
  const double share = dot(way * t - from, along) / dot(along, along);
  return t > 0 && share >= 0 && share <= 1;
}

void measure(Variant& v, const View& truth, const View& alone, const View& shown, const Camera& camera,
             const Gate& gate) {
  const auto map = flip_map(truth.colour, shown.colour);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    v.flip_all += map.pixels[i] / static_cast<double>(map.pixels.size());
    if (alone.coverage.pixels[i] > 0.5f || truth.coverage.pixels[i] < 0.5f || !passes(camera, gate, i)) continue;
    v.flip += map.pixels[i];
    v.pixels += 1;
    v.uncovered += 1 - shown.coverage.pixels[i];
  }
  ++v.views;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: impostor_errors CITY.gpkg [GATES]\n"), 2;
  const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20;
  const City city = read_city(argv[1]);
  const CityReader reader(argv[1]);
  const CityIndex index(city);
  const CityGround ground(city);
  const ImageSource image = [&](const std::string& id) {
    return reader.artefact("textures/" + id + ".png", {"identity"})->body;
  };
  CityMeshOptions mesh;
  mesh.level = 3;
  const RayScene whole(city_mesh(index, image, mesh));
  std::vector<const Gate*> gates;
  for (const Gate& g : city.gates)
    if (!g.to_sector_id.empty()) gates.push_back(&g);
  auto all = variants();
  std::size_t used = 0;
  for (std::size_t n = 0; n < std::min(count, gates.size()); ++n) {
    const Gate& gate = *gates[n * gates.size() / std::min(count, gates.size())];
    const Sector& sector = *index.sector(gate.sector_id);
    CityMeshOptions own = mesh;
    own.sectors = {sector.id};
    const RenderMesh alone_mesh = city_mesh(index, image, own);
    const RayScene alone(alone_mesh);
    std::vector<RayScene> scenes;
    bool is_pictured = true;
    for (Variant& v : all) {
      const double begin = seconds_now();
      const auto impostor = bake_impostor(ground, whole, gate, v.options);
      v.seconds += seconds_now() - begin;
      if (!(is_pictured = is_pictured && impostor)) break;
      v.bytes += static_cast<double>(impostor->png.size());
      ++v.pictures;
      RenderMesh with = alone_mesh;
      if (&v != &all.front()) add_impostor(with, *impostor);
      scenes.emplace_back(std::move(with));
    }
    if (!is_pictured) continue;
    ++used;
    for (const Camera& camera : eyes_of(city, sector, gate)) {
      const RenderOptions size{kWidth, kHeight, kSamples, 0.05, 0};
      const View truth = render(whole, camera, size), bare = render(alone, camera, size);
      for (std::size_t i = 0; i < all.size(); ++i)
        measure(all[i], truth, bare, render(scenes[i], camera, size), camera, gate);
    }
    std::fprintf(stderr, ".");
  }
  std::printf("variant,gates,views,px,colours,kB,ms,flip,flip_all,uncovered\n");
  for (const Variant& v : all) {
    const double pictures = static_cast<double>(std::max<std::size_t>(1, v.pictures)), pixels = std::max(1.0, v.pixels);
    const bool is_none = &v == &all.front();
    std::printf("\"%s\",%zu,%zu,%d,%d,%.2f,%.1f,%.4f,%.4f,%.4f\n", v.name, used, v.views,
                is_none ? 0 : v.options.most_px, is_none ? 0 : v.options.colours,
                is_none ? 0 : v.bytes / pictures / 1000, is_none ? 0 : v.seconds / pictures * 1000, v.flip / pixels,
                v.flip_all / static_cast<double>(std::max<std::size_t>(1, v.views)), v.uncovered / pixels);
  }
}
