/// What a level of detail differs from the finest one, by distance: level_errors CITY.gpkg [EYES] [SAMPLES] >
/// errors.csv
///
/// From viewpoints spread over the city, once forwards and once backwards, as a window of 600 lines shows it (the
/// middle 640 x 400 pixels of it). Each view is rendered with all facades in levels 1, 2, 3 and 4; pixels of facades
/// count for the distance at which they are. Columns: level, from_m, to_m, pixels, flip (mean, against level 4),
/// flip_p99, pop (mean FLIP against the next finer level), iou (of what lies at that distance), and for all views
/// together with from_m = 0: psnr_db, ssim, silhouette_iou, skyline_px.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "city_db/store.hpp"
#include "cli/city_mesh.hpp"
#include "sectorgen/bake/picture/flip.hpp"
#include "sectorgen/bake/picture/silhouette.hpp"
#include "sectorgen/bake/picture/similarity.hpp"
#include "sectorgen/bake/render/render.hpp"

namespace {

using namespace vicus;

constexpr double kBounds_m[] = {5, 10, 15, 20, 25, 30, 40, 50, 60, 75, 90, 110, 130, 160, 200, 250, 350};
constexpr std::size_t kBins = std::size(kBounds_m) - 1;
constexpr int kWidth = 640, kHeight = 400;
constexpr double kUnit_px = 583;  // 300 lines by the tangent of half of 0.95

struct Bin {
  std::vector<float> flip, pop;
  double both = 0, either = 0;
};
struct Totals {
  Bin bins[kBins];
  double psnr = 0, ssim = 0, iou = 0, skyline = 0;
};

std::size_t bin_of(float depth) {
  for (std::size_t b = 0; b < kBins; ++b)
    if (depth >= kBounds_m[b] && depth < kBounds_m[b + 1]) return b;
  return kBins;
}

std::vector<Camera> cameras(const City& city, std::size_t count) {
  std::vector<const Viewpoint*> all;
  for (const Viewpoint& v : city.viewpoints) all.push_back(&v);
  std::vector<Camera> out;
  const double field = 2 * std::atan(kHeight / 2 / kUnit_px);
  for (std::size_t i = 0; i < count && !all.empty(); ++i) {
    const Viewpoint& v = *all[i * all.size() / count];
    for (const double turn : {0.0, 180.0}) {
      const double heading = (v.heading_deg + turn) * std::numbers::pi / 180;
      const Enu eye{metres(v.at.x), metres(v.at.y), v.ground_m + v.eye_m};
      out.push_back(camera_at(eye, {eye.east + std::sin(heading), eye.north + std::cos(heading), eye.up}, field, kWidth,
                              kHeight));
    }
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: level_errors CITY.gpkg [EYES] [SAMPLES]\n"), 2;
  const std::size_t eyes = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 12;
  RenderOptions options{kWidth, kHeight, argc > 3 ? std::atoi(argv[3]) : 16, 0.05, 0};
  const City city = read_city(argv[1]);
  const CityReader reader(argv[1]);
  const CityIndex index(city);
  const ImageSource image = [&](const std::string& id) {
    return reader.artefact("textures/" + id + ".png", {"identity"})->body;
  };
  const auto scene_at = [&](int level, bool marks) {
    CityMeshOptions mesh;
    mesh.level = level;
    mesh.marks_facades = marks;
    return RayScene(city_mesh(index, image, mesh));
  };
  const RayScene marks = scene_at(1, true),
                 levels[] = {scene_at(1, false), scene_at(2, false), scene_at(3, false), scene_at(4, false)};
  const auto views = cameras(city, eyes);
  Totals totals[3];
  for (const Camera& camera : views) {
    const View mark = render(marks, camera, {kWidth, kHeight, 1, 0.05, 0});
    std::vector<View> shown;
    for (const RayScene& scene : levels) shown.push_back(render(scene, camera, options));
    for (std::size_t level = 0; level < 3; ++level) {
      Totals& t = totals[level];
      const auto flip = flip_map(shown[3].colour, shown[level].colour);
      const auto pop = flip_map(shown[level + 1].colour, shown[level].colour);
      for (std::size_t i = 0; i < flip.pixels.size(); ++i) {
        const std::size_t a = bin_of(shown[3].depth.pixels[i]), b = bin_of(shown[level].depth.pixels[i]);
        if (a < kBins) t.bins[a].either += 1;
        if (b < kBins && a != b) t.bins[b].either += 1;
        if (a < kBins && a == b) t.bins[a].both += 1;
        if (mark.coverage.pixels[i] < 1 || mark.colour.pixels[i][0] < 0.5f) continue;
        const std::size_t bin = bin_of(mark.depth.pixels[i]);
        if (bin == kBins) continue;
        t.bins[bin].flip.push_back(flip.pixels[i]);
        t.bins[bin].pop.push_back(pop.pixels[i]);
      }
      const double n = static_cast<double>(views.size());
      t.psnr += psnr_db(shown[3].colour, shown[level].colour) / n;
      t.ssim += ssim(shown[3].colour, shown[level].colour) / n;
      t.iou += silhouette_iou(shown[3].coverage, shown[level].coverage) / n;
      t.skyline += skyline_distance(shown[3].coverage, shown[level].coverage).mean_px / n;
    }
    std::fprintf(stderr, ".");
  }
  std::printf("level,from_m,to_m,pixels,flip,flip_p99,pop,iou,psnr_db,ssim,silhouette_iou,skyline_px\n");
  for (int level = 0; level < 3; ++level) {
    const Totals& t = totals[level];
    std::printf("%d,0,0,,,,,,%.2f,%.4f,%.5f,%.3f\n", level + 1, t.psnr, t.ssim, t.iou, t.skyline);
    for (std::size_t b = 0; b < kBins; ++b) {
      const Bin& bin = t.bins[b];
      const auto flip = summary_of(bin.flip), pop = summary_of(bin.pop);
      std::printf("%d,%g,%g,%zu,%.4f,%.4f,%.4f,%.4f,,,,\n", level + 1, kBounds_m[b], kBounds_m[b + 1], bin.flip.size(),
                  flip.mean, flip.p99, pop.mean, bin.either > 0 ? bin.both / bin.either : 1);
    }
  }
}
