/// What pictures around open sectors are worth: panorama_errors CITY.gpkg [SECTORS] > panoramas.csv
///
/// For open sectors spread over the city, from eyes at corners of their ground's triangles (moved inwards; six,
/// spread), in four directions: all far files of the city as truth, those that L_vis names alone, and these with a
/// panorama in one of several ways. Columns: variant, sectors (with a picture), views, kB (mean of a picture), ms (of
/// baking one, one core), flip_all (of whole views), flip (mean where L_vis alone shows sky and the truth does not),
/// uncovered (share of these pixels where the sky still shows), phantom (share of whole views' pixels where the picture
/// shows something and the truth sky).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <set>
#include <vector>

#include "city_db/store.hpp"
#include "city_db/terrain.hpp"
#include "cli/city_mesh.hpp"
#include "sectorgen/bake/impostors/bake_panorama.hpp"
#include "sectorgen/bake/impostors/impostor_mesh.hpp"
#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/render/render.hpp"

namespace {

using namespace vicus;

constexpr int kWidth = 320, kHeight = 160, kSamples = 4;
constexpr std::size_t kEyes = 4;
constexpr double kEye_m = 1.7, kView = 0.785;

struct Variant {
  const char* name;
  PanoramaOptions options;
  std::size_t pictures = 0, views = 0;
  double bytes = 0, seconds = 0, flip = 0, pixels = 0, flip_all = 0, uncovered = 0, phantom = 0;
};

std::vector<Variant> variants() {
  const auto make = [](const char* name, double nearest_radii, int px, int colours) {
    Variant v{name, {}};
    v.options.nearest_radii = nearest_radii;
    v.options.side_px = px;
    v.options.colours = colours;
    v.options.threads = 1;
    return v;
  };
  Variant near = make("from 1 radius, 60 m", 1, 128, 32), more = make("from 2 radii, twice the directions", 2, 128, 32);
  near.options.nearest_m = 60;
  more.options.directions = 720;
  return {make("none", 4, 16, 2),
          near,
          make("from 1 radius", 1, 128, 32),
          make("from 2 radii", 2, 128, 32),
          make("from 4 radii", 4, 128, 32),
          make("from 2 radii, half the pixels", 2, 64, 32),
          more};
}

std::vector<Enu> eyes_of(const City& city, const Sector& sector) {
  std::vector<PlanPoint> points = sector.ground.outer;
  for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
  std::vector<Enu> eyes;
  const auto& t = sector.ground_triangles;
  const std::size_t count = std::min(kEyes, t.size());
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t corner = n * t.size() / count, first = corner / 3 * 3;
    double x = 0, y = 0;
    for (std::size_t k = first; k < first + 3; ++k) {
      const double share = k == corner ? 0.7 : 0.15;
      x += share * points[t[k]].x;
      y += share * points[t[k]].y;
    }
    const PlanPoint p{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    eyes.push_back({metres(p.x), metres(p.y), height_m(city.terrain, p) + kEye_m});
  }
  return eyes;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void measure(Variant& v, const View& truth, const View& alone, const View& shown) {
  const auto map = flip_map(truth.colour, shown.colour);
  const auto count = static_cast<double>(map.pixels.size());
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    v.flip_all += map.pixels[i] / count;
    const bool is_bare = alone.coverage.pixels[i]<0.5f, is_there = truth.coverage.pixels[i]> 0.5f;
    if (is_bare && !is_there) v.phantom += shown.coverage.pixels[i] / count;
    if (!is_bare || !is_there) continue;
    v.flip += map.pixels[i];
    v.pixels += 1;
    v.uncovered += 1 - shown.coverage.pixels[i];
  }
  ++v.views;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: panorama_errors CITY.gpkg [SECTORS]\n"), 2;
  const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 10;
  City city = read_city(argv[1]);
  const CityReader reader(argv[1]);
  const CityIndex index(city);
  const ReadyImages images =
      cached([&](const std::string& id) { return reader.artefact("textures/" + id + ".png", {"identity"})->body; });
  std::vector<SectorPart> parts;
  for (const Sector& s : city.sectors) parts.push_back({&s, Detail::far, 1, {}});
  std::vector<std::uint32_t> first;
  RenderMesh mesh = parts_mesh(index, images, parts, false, &first);
  const FarCity far{RayScene(std::move(mesh)), first};
  std::vector<const Sector*> open;
  for (const Sector& s : city.sectors)
    if (is_open(s, {})) open.push_back(&s);
  auto all = variants();
  std::size_t used = 0;
  for (std::size_t n = 0; n < std::min(count, open.size()); ++n) {
    const Sector& sector = *open[n * open.size() / std::min(count, open.size())];
    City asked;  // one sector to bake, all others to stand behind
    asked.sectors = city.sectors;
    asked.terrain = city.terrain;
    for (Sector& s : asked.sectors)
      if (s.id != sector.id) s.kind = SectorKind::street;
    std::set<std::string> named{sector.id};
    for (const Visible* v : index.visible_from(sector.id))
      asked.visible.push_back(*v), named.insert(v->visible_sector_id);
    for (const Gate* g : index.gates_of(sector.id)) asked.gates.push_back(*g), named.insert(g->to_sector_id);
    std::vector<SectorPart> listed;
    for (const Sector& s : city.sectors)
      if (named.contains(s.id)) listed.push_back({&s, Detail::far, 1, {}});
    const RenderMesh alone_mesh = parts_mesh(index, images, listed, false);
    const RayScene alone(alone_mesh);
    std::vector<RayScene> scenes;
    for (Variant& v : all) {
      const double begin = seconds_now();
      const auto panoramas = bake_panoramas(asked, far, v.options);
      v.seconds += seconds_now() - begin;
      RenderMesh with = alone_mesh;
      if (!panoramas.empty()) {
        v.bytes += static_cast<double>(panoramas.front().png.size());
        ++v.pictures;
        if (&v != &all.front()) add_panorama(with, panoramas.front());
      }
      scenes.emplace_back(std::move(with));
    }
    ++used;
    for (const Enu& eye : eyes_of(city, sector))
      for (int k = 0; k < 4; ++k) {
        const double turn = k * std::numbers::pi / 2;
        const Camera camera = camera_at(eye, {eye.east + std::sin(turn), eye.north + std::cos(turn), eye.up + 0.15},
                                        kView, kWidth, kHeight);
        const RenderOptions size{kWidth, kHeight, kSamples, 0.05, 0};
        const View truth = render(far.scene, camera, size), bare = render(alone, camera, size);
        for (std::size_t i = 0; i < all.size(); ++i) measure(all[i], truth, bare, render(scenes[i], camera, size));
      }
    std::fprintf(stderr, ".");
  }
  std::printf("variant,sectors,pictures,views,kB,ms,flip_all,flip,uncovered,phantom\n");
  for (const Variant& v : all) {
    const double pictures = static_cast<double>(std::max<std::size_t>(1, v.pictures)), pixels = std::max(1.0, v.pixels),
                 views = static_cast<double>(std::max<std::size_t>(1, v.views));
    const bool is_none = &v == &all.front();
    std::printf("\"%s\",%zu,%zu,%zu,%.2f,%.0f,%.4f,%.4f,%.4f,%.5f\n", v.name, used, v.pictures, v.views,
                is_none ? 0 : v.bytes / pictures / 1000, is_none ? 0 : 1000 * v.seconds / static_cast<double>(used),
                v.flip_all / views, v.flip / pixels, v.uncovered / pixels, v.phantom / views);
  }
}
