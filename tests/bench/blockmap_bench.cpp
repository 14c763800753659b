#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>

#include "city_db/store.hpp"
#include "city_db/tile_tree.hpp"
#include "sectorgen/bake/bake_blockmap.hpp"
#include "tests/support/flight.hpp"

/// Figures and pictures of docs/blockmaps.md:
///   blockmap_bench CITY.gpkg speed                        tiles and rays a second, bytes
///   blockmap_bench CITY.gpkg picture OUT E,N,UP DIST EL AZ SIDE CELLS   truth and BlockMap+ side by side
namespace {

using namespace vicus;
using namespace vicus::test;

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Loaded {
  City city;
  std::unique_ptr<BakeScene> scene;
};

Loaded load(const char* path) {
  Loaded out;
  out.city = read_city(path);
  const CityReader reader(path);
  out.scene = std::make_unique<BakeScene>(
      out.city,
      [&](const std::string& id) {
        const auto artefact = reader.artefact("textures/" + id + ".png", {"identity"});
        return artefact ? artefact->body : std::string();
      },
      1);
  return out;
}

/// The corners of the tiles of a side that hold the most houses.
std::vector<PlanPoint> full_tiles(const BakeScene& scene, std::uint32_t side_mm, std::size_t most) {
  std::vector<std::pair<std::size_t, PlanPoint>> found;
  const auto side = static_cast<std::int32_t>(side_mm);
  const auto begin = [&](std::int32_t v) { return (v / side - (v < 0 ? 1 : 0)) * side; };
  const PlanBox& box = scene.box();
  for (std::int32_t y = begin(box.min.y); y < box.max.y; y += side)
    for (std::int32_t x = begin(box.min.x); x < box.max.x; x += side)
      if (const auto n = scene.houses_in({{x, y}, {x + side, y + side}}).size(); n > 0) found.push_back({n, {x, y}});
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<PlanPoint> out;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i) out.push_back(found[i].second);
  return out;
}

void speed(const Loaded& city) {
  const BakeScene& scene = *city.scene;
  std::printf("side_m cells tiles houses bake_ms bake_coded_ms planes_B images_B error_m colour_error Mrays\n");
  for (const std::uint32_t tile_mm : {128'000u, 512'000u})
    for (const std::uint32_t cells : {32u, 64u, 128u, 256u}) {
      const auto corners = full_tiles(scene, tile_mm, 16);
      BlockMapOptions options;
      options.side = cells;
      double bake_s = 1e9, coded_s = 0, error = 0, colour = 0;
      std::size_t houses = 0, images = 0, planes = 0;
      for (int round = 0; round < 3; ++round) {
        const double start = cpu_now();
        for (const PlanPoint c : corners) bake_unpacked(scene, c, tile_mm, options);
        bake_s = std::min(bake_s, cpu_now() - start);
      }
      std::vector<BlockMap> maps;
      const double start = cpu_now();
      for (const PlanPoint c : corners) maps.push_back(bake_blockmap(scene, c, tile_mm, options));
      coded_s = cpu_now() - start;
      double per_ray = 0;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const BlockMap& m = maps[i];
        const auto side = static_cast<std::int32_t>(tile_mm);
        houses += scene.houses_in({corners[i], {corners[i].x + side, corners[i].y + side}}).size();
        images += m.roof_image.size() + m.ground_image.size() + m.ambient_image.size() + m.wall_image.size();
        planes += encode_blockmap(m).size();
        error = std::max(error, m.error_mm / 1000.0);
        colour += m.colour_error_milli / 1000.0;
      }
      const BlockMapCaster caster(maps[0]);
      const double mx = metres(corners[0].x) + metres(tile_mm) / 2, my = metres(corners[0].y) + metres(tile_mm) / 2;
      for (const double elevation : {3.0, 10.0, 30.0, 70.0}) {
        const Camera camera = camera_around(mx, my, 8, metres(tile_mm) * 1.2, elevation, 30, 640, 480);
        std::vector<PlanRay> rays;
        for (int y = 0; y < 480; ++y)
          for (int x = 0; x < 640; ++x) rays.push_back(camera.ray(x + 0.5, y + 0.5));
        double best = 1e9, sum = 0;
        for (int round = 0; round < 3; ++round) {
          const double begin = cpu_now();
          for (const PlanRay& r : rays) sum += caster.cast(r).cell;
          best = std::min(best, cpu_now() - begin);
        }
        if (sum < 0) std::printf("?");
        per_ray += best / double(rays.size()) / 4;
      }
      const double n = double(corners.size());
      std::printf("%6.0f %5u %5zu %6.0f %7.2f %13.2f %8.0f %8.0f %7.2f %12.2f %5.1f\n", metres(tile_mm), cells,
                  corners.size(), double(houses) / n, bake_s / n * 1e3, coded_s / n * 1e3, double(planes) / n,
                  double(images) / n, error, colour / n, 1e-6 / per_ray);
    }
}

std::vector<std::unique_ptr<DrawnTile>> tiles_of(const BakeScene& scene, const PlanBox& box, std::uint32_t side_mm,
                                                 std::uint32_t cells) {
  std::vector<std::unique_ptr<DrawnTile>> out;
  const auto side = static_cast<std::int32_t>(side_mm);
  const auto begin = [&](std::int32_t v) { return (v / side - (v < 0 ? 1 : 0)) * side; };
  BlockMapOptions options;
  options.side = cells;
  for (std::int32_t y = begin(box.min.y); y < box.max.y; y += side)
    for (std::int32_t x = begin(box.min.x); x < box.max.x; x += side)
      out.push_back(std::make_unique<DrawnTile>(bake_blockmap(scene, {x, y}, side_mm, options)));
  return out;
}

void picture(const Loaded& city, char** argv) {
  double x = 0, y = 0, up = 0;
  std::sscanf(argv[1], "%lf,%lf,%lf", &x, &y, &up);
  const double distance = std::atof(argv[2]), elevation = std::atof(argv[3]), azimuth = std::atof(argv[4]);
  const auto side_mm = static_cast<std::uint32_t>(std::atof(argv[5]) * 1000);
  const auto cells = static_cast<std::uint32_t>(std::atoi(argv[6]));
  const Camera camera = camera_around(x, y, up, distance, elevation, azimuth, 800, 600);
  const double reach = std::max(400.0, distance);
  const PlanBox box{{lattice_mm(x - reach), lattice_mm(y - reach)}, {lattice_mm(x + reach), lattice_mm(y + reach)}};
  const auto tiles = tiles_of(*city.scene, box, side_mm, cells);
  const View seen = view_of(tiles, camera);
  write_png(std::string(argv[0]) + "_blockmap.png", picture_of(seen, false));
  write_png(std::string(argv[0]) + "_ambient.png", picture_of(seen, true));
  write_png(std::string(argv[0]) + "_truth.png", picture_of(TrueCity(*city.scene, box).view(camera), false));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc >= 3) {
    const Loaded city = load(argv[1]);
    if (std::strcmp(argv[2], "speed") == 0) return speed(city), 0;
    if (std::strcmp(argv[2], "picture") == 0 && argc == 10) return picture(city, argv + 3), 0;
  }
  std::fprintf(stderr, "usage: blockmap_bench CITY.gpkg speed | picture OUT E,N,UP DIST EL AZ SIDE CELLS\n");
  return 2;
}
