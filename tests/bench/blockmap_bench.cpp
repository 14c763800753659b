#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>

#include "city_db/store.hpp"
#include "city_db/tile_tree.hpp"
#include "sectorgen/bake/bake_blockmap.hpp"
#include "sectorgen/bake/bake_paper.hpp"
#include "sectorgen/bake/bake_prisms.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "sectorgen/bake/few_colours.hpp"
#include "tests/support/flight.hpp"
#include "x3d_export/coding.hpp"
#ifdef VICUS_PICTURE
#include "sectorgen/bake/picture/flip.hpp"
#endif

/// Figures and pictures of docs/blockmaps.md:
///   blockmap_bench CITY.gpkg speed                        tiles and rays a second, bytes
///   blockmap_bench CITY.gpkg prisms                       bytes a house, level by level
///   blockmap_bench CITY.gpkg compare                      error at equal bytes: 2007, 2009, ours
///   blockmap_bench CITY.gpkg error                        measured against stored error
///   blockmap_bench CITY.gpkg codecs                       pictures as WebP and as palettes: bytes and error
///   blockmap_bench CITY.gpkg rebake                       one house changes: what is baked again, and how long it
///   takes blockmap_bench CITY.gpkg picture OUT E,N,UP DIST EL AZ SIDE CELLS   truth and BlockMap+ side by side
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

void prisms(const Loaded& city) {
  std::printf("side_m tiles houses step_m error_m plain_B sent_B sent_B_a_house\n");
  const int levels = tile_levels(city.scene->box());
  for (int z = levels - 1; z >= 0; --z) {
    std::size_t tiles = 0, houses = 0, plain = 0, sent = 0;
    double error = 0, step = 0;
    for (const TileNode& node : plan_tiles(*city.scene, levels, 1)) {
      if (node.at.z != z || !node.has_prisms) continue;
      const PrismTile tile = bake_prisms(*city.scene, tile_corner(levels, node.at), tile_side_mm(levels, z));
      const std::string bytes = encode_prisms(tile);
      ++tiles;
      houses += tile.houses.size();
      plain += bytes.size();
      sent += brotli(bytes, 11).size();
      error = std::max(error, tile.error_mm / 1000.0);
      step = tile.step_mm / 1000.0;
    }
    if (houses > 0)
      std::printf("%6u %5zu %6zu %6.2f %7.2f %7zu %6zu %6.1f\n", tile_side_mm(levels, z) / 1000, tiles, houses, step,
                  error, plain, sent, double(sent) / double(houses));
  }
}

/// A 3 x 3 block of tiles in some form: how it is seen, and the mean bytes of a tile.
struct Form {
  std::string name;
  double bytes = 0, raw = 0;
  std::function<Seen(const PlanRay&)> see;
};

std::vector<PlanPoint> block_around(PlanPoint middle, std::int32_t side) {
  std::vector<PlanPoint> out;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) out.push_back({middle.x + x * side, middle.y + y * side});
  return out;
}

Form ours(const BakeScene& scene, const std::vector<PlanPoint>& corners, std::uint32_t side_mm, std::uint32_t cells) {
  Form form{"ours " + std::to_string(cells), 0, 0, {}};
  BlockMapOptions options;
  options.side = cells;
  const auto tiles = std::make_shared<std::vector<std::unique_ptr<DrawnTile>>>();
  for (const PlanPoint c : corners) {
    BlockMap map = bake_blockmap(scene, c, side_mm, options);
    const std::string bytes = encode_blockmap(map);
    form.raw += double(bytes.size()) / double(corners.size());
    form.bytes += double(brotli(bytes, 11).size()) / double(corners.size());
    tiles->push_back(std::make_unique<DrawnTile>(std::move(map)));
  }
  form.see = [tiles](const PlanRay& ray) {
    Seen out;
    CastHit best;
    const DrawnTile* from = nullptr;
    for (const auto& tile : *tiles)
      if (const CastHit hit = tile->caster.cast(ray, best.t); hit && hit.t < best.t) best = hit, from = tile.get();
    if (from) out = {best.t, from->colours.look(ray, best)};
    return out;
  };
  return form;
}

Form paper(const BakeScene& scene, const std::vector<PlanPoint>& corners, std::uint32_t side_mm, PaperYear year,
           std::uint32_t n, std::uint32_t w) {
  struct Tile {
    PaperBlockMap map;
    BlockMap surface;
    BlockMapCaster caster;
  };
  Form form{(year == PaperYear::y2007 ? "2007 " : "2009 ") + std::to_string(n) + ":" + std::to_string(w), 0, 0, {}};
  const auto tiles = std::make_shared<std::vector<Tile>>();
  for (const PlanPoint c : corners) {
    PaperBlockMap map = bake_paper(scene, c, side_mm, year, n, w);
    form.raw += double(map.texels.size()) / double(corners.size());
    form.bytes += paper_sent_bytes(map) / double(corners.size());
    BlockMap surface = surface_of(map);
    BlockMapCaster caster(surface);
    tiles->push_back({std::move(map), std::move(surface), std::move(caster)});
  }
  form.see = [tiles](const PlanRay& ray) {
    Seen out;
    CastHit best;
    const Tile* from = nullptr;
    for (const Tile& tile : *tiles)
      if (const CastHit hit = tile.caster.cast(ray, best.t); hit && hit.t < best.t) best = hit, from = &tile;
    if (from) out = {best.t, look_of(from->map, from->surface, ray, best)};
    return out;
  };
  return form;
}

/// Part of a picture, 4 rays a pixel for its colours; depth through the pixel's middle.
struct Shot {
  int width = 0, height = 0;
  std::vector<double> depth;
  std::vector<ColourMean> colour;
};

Shot shoot(const std::function<Seen(const PlanRay&)>& see, const Camera& camera, int x0, int y0, int x1, int y1) {
  Shot shot{x1 - x0, y1 - y0, {}, {}};
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      shot.depth.push_back(see(camera.ray(x + 0.5, y + 0.5)).t);
      ColourMean sum;
      for (const double a : {0.25, 0.75})
        for (const double b : {0.25, 0.75}) {
          const Seen s = see(camera.ray(x + a, y + b));
          sum = sum + mean_of(std::isinf(s.t) ? kSky : lit(s.look, false)) * 0.25;
        }
      shot.colour.push_back(sum);
    }
  return shot;
}

#ifdef VICUS_PICTURE
double flip_of(const Shot& a, const Shot& b) {
  const auto picture = [](const Shot& s) {
    Picture out(s.width, s.height);
    for (std::size_t i = 0; i < s.colour.size(); ++i)
      out.pixels[i] = {float(s.colour[i].r / 255), float(s.colour[i].g / 255), float(s.colour[i].b / 255)};
    return out;
  };
  return flip_mean(picture(a), picture(b));
}
#else
double flip_of(const Shot&, const Shot&) { return NAN; }
#endif

double psnr_of(const Shot& a, const Shot& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i)
    for (const double d : {a.colour[i].r - b.colour[i].r, a.colour[i].g - b.colour[i].g, a.colour[i].b - b.colour[i].b})
      sum += d * d;
  return 10 * std::log10(255 * 255 * 3 * double(a.colour.size()) / std::max(sum, 1e-9));
}

void compare(const Loaded& city) {
  const BakeScene& scene = *city.scene;
  constexpr std::uint32_t kSide_mm = 128'000;
  const PlanPoint middle = full_tiles(scene, kSide_mm, 1).at(0);
  const auto side = static_cast<std::int32_t>(kSide_mm);
  const auto corners = block_around(middle, side);
  const TrueCity truth(scene, {corners.front(), {corners.back().x + side, corners.back().y + side}});
  std::vector<Form> forms;
  forms.push_back(paper(scene, corners, kSide_mm, PaperYear::y2007, 32, 192));
  forms.push_back(paper(scene, corners, kSide_mm, PaperYear::y2007, 64, 256));
  forms.push_back(paper(scene, corners, kSide_mm, PaperYear::y2009, 128, 512));
  for (const std::uint32_t cells : {32u, 64u, 128u}) forms.push_back(ours(scene, corners, kSide_mm, cells));
  std::printf("distance_m form raw_B sent_B FLIP PSNR_dB depth_mean_m depth_median_m\n");
  const double mx = metres(middle.x) + 64, my = metres(middle.y) + 64;
  for (const double distance : {300.0, 600.0, 1200.0}) {
    std::vector<double> flip(forms.size()), psnr(forms.size()), depth(forms.size());
    std::vector<std::vector<double>> depths(forms.size());
    int views = 0;
    for (const double elevation : {6.0, 25.0, 60.0})
      for (const double azimuth : {20.0, 140.0, 260.0}) {
        const Camera camera = camera_around(mx, my, 8, distance, elevation, azimuth, 640, 480);
        const int half = std::min(240, static_cast<int>(64 / distance * camera.pixels_per_radian()));
        const int x0 = 320 - half, x1 = 320 + half, y0 = 240 - std::min(half, 200), y1 = 240 + std::min(half, 200);
        const Shot real = shoot([&](const PlanRay& r) { return truth.see(r); }, camera, x0, y0, x1, y1);
        ++views;
        for (std::size_t f = 0; f < forms.size(); ++f) {
          const Shot shot = shoot(forms[f].see, camera, x0, y0, x1, y1);
          flip[f] += flip_of(real, shot);
          psnr[f] += psnr_of(real, shot);
          for (std::size_t i = 0; i < real.depth.size(); ++i)
            if (!std::isinf(real.depth[i]) && !std::isinf(shot.depth[i]))
              depths[f].push_back(std::abs(real.depth[i] - shot.depth[i]));
        }
      }
    for (std::size_t f = 0; f < forms.size(); ++f) {
      for (const double d : depths[f]) depth[f] += d / double(depths[f].size());
      std::nth_element(depths[f].begin(), depths[f].begin() + std::ptrdiff_t(depths[f].size() / 2), depths[f].end());
      std::printf("%6.0f %-13s %8.0f %7.0f %.4f %5.1f %6.2f %7.3f\n", distance, forms[f].name.c_str(), forms[f].raw,
                  forms[f].bytes, flip[f] / views, psnr[f] / views, depth[f], depths[f][depths[f].size() / 2]);
    }
    std::fflush(stdout);
  }
}

/// Of rays from all around: how far what they meet in a tile lies from the true city, as a share of what the tile says.
void error(const Loaded& city) {
  const BakeScene& scene = *city.scene;
  std::printf("side_m cells stored_m worst_m mean_m rays\n");
  for (const std::uint32_t tile_mm : {128'000u, 512'000u})
    for (const PlanPoint corner : full_tiles(scene, tile_mm, 4)) {
      const auto side = static_cast<std::int32_t>(tile_mm);
      const TrueCity truth(
          scene, {{corner.x - 30'000, corner.y - 30'000}, {corner.x + side + 30'000, corner.y + side + 30'000}});
      for (const std::uint32_t cells : {32u, 64u, 128u}) {
        BlockMapOptions options;
        options.side = cells;
        const BlockMap map = bake_unpacked(scene, corner, tile_mm, options).map;
        const BlockMapCaster caster(map);
        const double size = metres(tile_mm), stored = map.error_mm / 1000.0;
        double worst = 0, sum = 0;
        int count = 0;
        std::srand(1);
        const auto unit = [] { return std::rand() / (RAND_MAX + 1.0); };
        for (int i = 0; i < 100'000; ++i) {
          const double turn = 6.283185307 * unit(), steep = 0.02 + 1.5 * unit() * unit(), back = size * (0.2 + unit());
          const PlanRay ray{metres(corner.x) + size * unit() - std::cos(turn) * back,
                            metres(corner.y) + size * unit() - std::sin(turn) * back,
                            3 + 15 * unit() + back * steep,
                            std::cos(turn),
                            std::sin(turn),
                            -steep};
          const CastHit hit = caster.cast(ray);
          if (!hit || hit.t < 1e-3) continue;  // begins in a house
          const double x = ray.x + hit.t * ray.dx, y = ray.y + hit.t * ray.dy;
          const double rim = std::min(
              {x - metres(corner.x), metres(corner.x) + size - x, y - metres(corner.y), metres(corner.y) + size - y});
          if (rim < 0.02) continue;  // the rim is closed, whatever stands beyond it
          const double d = truth.distance(x, y, ray.z + hit.t * ray.dz, stored * 2 + 5);
          worst = std::max(worst, d);
          sum += d;
          ++count;
        }
        std::printf("%6.0f %5u %8.2f %7.2f %6.3f %6d%s\n", size, cells, stored, worst, sum / count, count,
                    worst > stored + 0.02 ? "  EXCEEDED" : "");
      }
    }
}

void codecs(const Loaded& city) {
  const int levels = tile_levels(city.scene->box());
  std::vector<BakedBlockMap> baked;
  for (const TileNode& node : plan_tiles(*city.scene, levels, 1))
    if (node.has_blockmap && baked.size() < 40)
      baked.push_back(bake_unpacked(*city.scene, tile_corner(levels, node.at), tile_side_mm(levels, node.at.z)));
  const auto squares_of = [](const RgbImage& a, const RgbImage& b, double& n) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += (a.rgb[i] - b.rgb[i]) * (a.rgb[i] - b.rgb[i]);
    n += double(a.rgb.size());
    return sum;
  };
  for (const int q : {-80, -60, 12, 16, 24, 32, 48, 64, 128, 256}) {
    double sum = 0, n = 0, bytes = 0, ms = 0, part[4] = {0, 0, 0, 0}, planes = 0;
    for (const BakedBlockMap& b : baked) {
      BlockMap map = b.map;
      const double start = cpu_now();
      int k = 0;
      const std::string bare = encode_blockmap(map);
      planes += double(brotli(bare, 9).size());
      for (auto [image, to] :
           {std::pair(&b.pictures.roof, &map.roof_image), std::pair(&b.pictures.ground, &map.ground_image),
            std::pair(&b.pictures.ambient, &map.ambient_image), std::pair(&b.pictures.wall, &map.wall_image)}) {
        if (image->rgb.empty()) {
          ++k;
          continue;
        }
        if (q < 0) {
          *to = encode_webp(*image, -q);
          if (k != 2) sum += squares_of(*image, *decode_webp(*to, image->width, image->height), n);
          part[k] += double(to->size());
        } else {
          const auto few = with_few_colours(*image, k == 2 ? 16 : q);
          *to = encode_indexed(few);
          if (k != 2) sum += squares_of(*image, rgb_of(few, image->width, image->height), n);
          part[k] += double(brotli(*to, 9).size());
        }
        ++k;
      }
      ms += cpu_now() - start;
      bytes += double(brotli(encode_blockmap(map), 9).size());
    }
    const double t = double(baked.size());
    std::printf("%4d: %7.0f B a tile (planes %.0f, roof %.0f ground %.0f ambient %.0f wall %.0f), rms %.2f, %.1f ms\n",
                q, bytes / t, planes / t, part[0] / t, part[1] / t, part[2] / t, part[3] / t, std::sqrt(sum / n),
                ms / t * 1e3);
  }
}

void rebake(Loaded& city) {
  const int levels = tile_levels(city.scene->box());
  const auto before = plan_tiles(*city.scene, levels, 1);
  const auto houses = city.scene->houses_in(tile_box(levels, before.back().at));
  for (Building& house : city.city.buildings)
    if (house.id == city.scene->houses()[houses.at(0)].id) house.roof_colour.r ^= 0x40;
  const BakeScene scene(
      city.city, [](const std::string&) { return std::string(); }, 1);
  const double start = cpu_now();
  const auto after = plan_tiles(scene, levels, 1);
  const double planned = cpu_now();
  int baked = 0;
  for (std::size_t i = 0; i < after.size(); ++i)
    if (before[i].key != after[i].key)
      for (const TileKind kind : kTileKinds)
        if (has_kind(after[i], kind)) {
          tile_bytes(scene, levels, after[i].at, kind, after[i].key);
          ++baked;
        }
  std::printf("%zu tiles; keys %.3f s, %d files baked again in %.3f s of one core (blind facades)\n", after.size(),
              planned - start, baked, cpu_now() - planned);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc >= 3) {
    Loaded city = load(argv[1]);
    if (std::strcmp(argv[2], "speed") == 0) return speed(city), 0;
    if (std::strcmp(argv[2], "prisms") == 0) return prisms(city), 0;
    if (std::strcmp(argv[2], "compare") == 0) return compare(city), 0;
    if (std::strcmp(argv[2], "error") == 0) return error(city), 0;
    if (std::strcmp(argv[2], "codecs") == 0) return codecs(city), 0;
    if (std::strcmp(argv[2], "rebake") == 0) return rebake(city), 0;
    if (std::strcmp(argv[2], "picture") == 0 && argc == 10) return picture(city, argv + 3), 0;
  }
  std::fprintf(
      stderr,
      "usage: blockmap_bench CITY.gpkg speed | prisms | compare | error | codecs | rebake | picture OUT E,N,UP DIST EL "
      "AZ SIDE CELLS\n");
  return 2;
}
