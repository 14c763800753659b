#include "sectorgen/build_city.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>

#include "sectorgen/geo/plan_frame.hpp"
#include "sectorgen/geo/read_terrain.hpp"
#include "sectorgen/models/author_models.hpp"
#include "sectorgen/models/facades.hpp"
#include "sectorgen/models/lay_ground.hpp"
#include "sectorgen/models/model_photos.hpp"
#include "sectorgen/models/photo_facades.hpp"
#include "sectorgen/models/roof_city.hpp"
#include "sectorgen/models/stand_objects.hpp"
#include "sectorgen/sectors/domain.hpp"
#include "sectorgen/sectors/interiors.hpp"
#include "sectorgen/sectors/naming.hpp"
#include "sectorgen/sectors/sectors.hpp"
#include "sectorgen/visibility/important.hpp"

namespace vicus {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double peak_resident_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

StageClock::StageClock(BuildReport& report, std::function<void(const char*)> on_stage)
    : report_(report), on_stage_(std::move(on_stage)) {}

void StageClock::begin(const char* stage) {
  end();
  if (on_stage_) on_stage_(stage);
  stage_ = stage;
  cpu_ = cpu_seconds();
  wall_ = std::chrono::steady_clock::now();
}

void StageClock::end() {
  if (stage_ == nullptr) return;
  malloc_trim(0);  // what the stage's threads gave back: else it stays theirs, and the next stage asks for more
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_;
  report_.stages.push_back({stage_, cpu_seconds() - cpu_, wall.count(), peak_resident_mb()});
  stage_ = nullptr;
}

namespace {

/// Before the long stages, so that a raster of another place is told at once.
void add_terrain(const std::filesystem::path& path, const std::vector<Polygon>& domain, City& city,
                 BuildReport& report) {
  PlanBox box;
  for (const auto& polygon : domain)
    for (const auto& p : polygon.outer) box.add(p);
  auto read = read_terrain(path, PlanFrame(city.origin), box, {}, city.issues);
  city.terrain = std::move(read.terrain);
  city.meta["terrain_base_m"] = std::to_string(read.base_m);
  report.is_terrain_coarsened = read.is_coarsened;
}

}  // namespace

City build_city(SourceMap map, const BuildOptions& options, std::vector<Issue> issues, BuildReport& report) {
  StageClock clock(report, options.on_stage);
  City city;
  city.origin = map.origin;
  city.issues = std::move(issues);
  Plan plan;

  clock.begin("normalise");
  plan.blocks = make_blocks(map, city.issues);
  plan.domain = make_domain(map, plan.blocks);
  if (plan.domain.empty()) throw CityError("nothing to build a city from: no footprint and no street", 4);
  if (!options.terrain.empty()) add_terrain(options.terrain, plan.domain, city, report);
  plan.kerbs = make_kerbs(map, plan.blocks, plan.domain);
  plan.noded = node_map(plan.blocks, plan.domain, plan.kerbs);

  clock.begin("sectors");
  const auto limit =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(options.budget_bytes / kBytesPerSide, kMostSides));
  const CoverMesh cover(plan.noded, reach_points(map.axes, map.areas));
  GroundOptions ground;
  CutOptions cuts;
  std::vector<PlanPoint> needed;
  for (;; cuts.join_across_islands = true,
          ground.no_islands.insert(ground.no_islands.end(), needed.begin(), needed.end())) {
    std::sort(ground.no_islands.begin(), ground.no_islands.end());
    plan.ground = make_ground(cover, ground);
    plan.routes = route_axes(plan.ground, map.axes, map.areas);
    plan.cells = cut_cells(plan.ground, plan.routes, cuts);
    merge_cells(plan.ground, plan.routes, plan.cells);
    split_long_cells(plan.ground, cuts, plan.cells);
    // A cut through a small obstacle, or a sector too heavy to leave whole: cut again with those obstacles in the mesh.
    const auto heavy = islands_in_heavy_cells(plan.ground, plan.cells, limit);
    needed = crossed_islands(plan.ground, plan.cells);
    needed.insert(needed.end(), heavy.begin(), heavy.end());
    if (needed.empty()) break;
  }
  split_heavy_cells(plan.ground, plan.cells, limit);
  if (plan.cells.kind.empty())
    throw CityError("no walkable ground: no street, path or square reaches any open ground", 4);

  clock.begin("records");
  write_sectors(map, plan, city);
  name_sectors(map, plan, city);
  furnish(map, plan, city);
  add_start_views(plan, city);
  identify(options.previous, city);
  add_interiors(map, city);
  const PlanFrame frame(city.origin);
  mark_important(city, {options.important, [&](LatLon p) { return frame.plan_from_latlon(p); }, options.previous},
                 city.issues);

  clock.begin("models");
  roof_houses(city, map.models);
  lay_out_facades(city, map.models);
  hang_model_photos(map.models, city);
  hang_photos(options.photos, city);
  if (options.with_textures) paint_textures(city, options.threads);

  clock.begin("ground");
  stand_objects(map, city);
  add_author_models(options.models, city);
  const auto ground_figures = lay_ground(map, city, options.threads);
  report.ground_triangles = ground_figures.triangles;
  report.largest_gap_m = ground_figures.largest_gap_m;
  level_interiors(city);

  clock.begin("visibility");
  if (options.with_visibility) {
    list_visible(city, options.visible);
    add_important(city);
  }
  clock.end();
  return city;
}

}  // namespace vicus
