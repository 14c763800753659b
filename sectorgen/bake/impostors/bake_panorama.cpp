#include "sectorgen/bake/impostors/bake_panorama.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "city_db/panorama_sides.hpp"
#include "city_db/run_parallel.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/bake/impostors/cut_out_png.hpp"
#include "sectorgen/bake/render/render.hpp"

namespace vicus {
namespace {

constexpr double kEye_m = 1.7;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLowest = -0.5 * kDegree, kFineUpTo = 8 * kDegree, kHighest = 25 * kDegree;
constexpr double kFineStep = 0.25 * kDegree, kCoarseStep = 0.5 * kDegree;
constexpr std::size_t kLeastHits = 6;   // fewer are a chimney here and there
constexpr double kLeastRadius_m = 500;  // of the prism
constexpr double kMargin = 1.05;        // beyond all that L_vis names; of the top over what is seen
constexpr double kInwards = 0.1;        // from a triangle's corner to its middle
constexpr int kLeastHeight_px = 16;
constexpr double kLevel_m = 0.01, kUpright = 1e-3, kOverTop = 1e-4;  // of a wall's top edge; of its normal; rad

Vec3 place(PlanPoint p, double up_m) { return {metres(p.x), metres(p.y), up_m}; }
double distance_m(PlanPoint a, PlanPoint b) {
  return std::hypot(metres(std::int64_t{a.x} - b.x), metres(std::int64_t{a.y} - b.y));
}

struct Triangles {
  std::vector<PlanPoint> corners;  // three each
  double area_m2 = 0;
  PlanPoint middle;  // the triangle's middle that is nearest to the ground's
};

Triangles triangles_of(const Sector& s) {
  Triangles out;
  std::vector<PlanPoint> points = s.ground.outer;
  for (const auto& hole : s.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
  double east = 0, north = 0;
  std::vector<PlanPoint> middles;
  for (std::size_t i = 0; i + 2 < s.ground_triangles.size(); i += 3) {
    const PlanPoint a = points[s.ground_triangles[i]], b = points[s.ground_triangles[i + 1]],
                    c = points[s.ground_triangles[i + 2]];
    out.corners.insert(out.corners.end(), {a, b, c});
    const double area = std::abs(metres(std::int64_t{b.x} - a.x) * metres(std::int64_t{c.y} - a.y) -
                                 metres(std::int64_t{b.y} - a.y) * metres(std::int64_t{c.x} - a.x)) /
                        2;
    const PlanPoint m{static_cast<std::int32_t>((std::int64_t{a.x} + b.x + c.x) / 3),
                      static_cast<std::int32_t>((std::int64_t{a.y} + b.y + c.y) / 3)};
    middles.push_back(m);
    out.area_m2 += area;
    east += area * m.x;
    north += area * m.y;
  }
  if (out.area_m2 == 0) return out;
  const PlanPoint centre{static_cast<std::int32_t>(std::lround(east / out.area_m2)),
                         static_cast<std::int32_t>(std::lround(north / out.area_m2))};
  out.middle = *std::min_element(middles.begin(), middles.end(), [&](PlanPoint a, PlanPoint b) {
    return distance_m(a, centre) < distance_m(b, centre);
  });
  return out;
}

/// The middle, then each time the place that is farthest from all before.
std::vector<PlanPoint> spots_of(const Triangles& ground, int count) {
  std::vector<PlanPoint> places;
  for (std::size_t i = 0; i < ground.corners.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanPoint a = ground.corners[i + k], b = ground.corners[i + (k + 1) % 3],
                      c = ground.corners[i + (k + 2) % 3];
      const auto inwards = [](std::int64_t corner, std::int64_t second, std::int64_t third) {
        const double middle = static_cast<double>(corner + second + third) / 3;
        return static_cast<std::int32_t>(std::lround(std::lerp(static_cast<double>(corner), middle, kInwards)));
      };
      places.push_back({inwards(a.x, b.x, c.x), inwards(a.y, b.y, c.y)});
    }
  std::vector<PlanPoint> spots{ground.middle};
  std::vector<double> away(places.size(), HUGE_VAL);
  while (static_cast<int>(spots.size()) < count) {
    for (std::size_t i = 0; i < places.size(); ++i) away[i] = std::min(away[i], distance_m(places[i], spots.back()));
    const auto farthest = std::max_element(away.begin(), away.end());
    if (farthest == away.end() || *farthest < 1) break;
    spots.push_back(places[static_cast<std::size_t>(farthest - away.begin())]);
  }
  return spots;
}

/// The triangles named, by themselves.
RenderMesh part_of(const RenderMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  RenderMesh out;
  out.origin = mesh.origin;
  out.images = mesh.images;
  for (const std::uint32_t i : triangles) {
    RenderTriangle t = mesh.triangles[i];
    if (t.image != kNoImage) {
      out.places.push_back(mesh.places[t.places]);
      t.places = static_cast<std::uint32_t>(out.places.size() - 1);
    }
    for (std::uint32_t& corner : t.corners) {
      out.points.push_back(mesh.points[corner]);
      corner = static_cast<std::uint32_t>(out.points.size() - 1);
    }
    out.triangles.push_back(t);
  }
  return out;
}

class PanoramaBaker {
 public:
  PanoramaBaker(const City& city, const FarCity& far, const PanoramaOptions& options)
      : city_(city), far_(far), options_(options) {}

  /// `listed`: by sector, does L_vis of this one name it?
  std::optional<Panorama> run(const Sector& sector, const std::vector<bool>& listed) const {
    const Triangles ground = triangles_of(sector);
    if (ground.corners.empty()) return std::nullopt;
    Panorama out;
    out.sector_id = sector.id;
    out.eye = ground.middle;
    out.eye_up_m = height_m(city_.terrain, out.eye) + kEye_m;
    double radius = 0;
    for (const PlanPoint p : sector.ground.outer) radius = std::max(radius, distance_m(p, out.eye));
    const Seen seen = look_around(out, spots_of(ground, options_.spots), listed,
                                  std::max(options_.nearest_m, options_.nearest_radii * radius));
    if (seen.hits < kLeastHits) return std::nullopt;
    out.near_m = seen.near_m;
    out.far_m = seen.far_m;
    out.radius_m = kLeastRadius_m;
    for (std::size_t i = 0; i < listed.size(); ++i)
      if (listed[i])
        for (const PlanPoint p : city_.sectors[i].ground.outer)
          out.radius_m = std::max(out.radius_m, kMargin * distance_m(p, out.eye) + radius);
    out.radius_m = std::min(out.radius_m, kMostPanoramaRadius_m);
    const double inner = out.radius_m * std::cos(std::numbers::pi / kPanoramaSides);
    out.bottom_m = out.eye_up_m + inner * std::tan(kLowest);
    out.top_m = out.eye_up_m + out.radius_m * (kMargin * seen.slope + std::tan(kFineStep));
    draw(out, RayScene(part_of(far_.scene.mesh(), seen.triangles)));
    if (out.sides == 0) return std::nullopt;
    return out;
  }

 private:
  struct Seen {
    std::vector<std::uint32_t> triangles;  // sorted
    std::size_t hits = 0;
    double near_m = HUGE_VAL, far_m = 0, slope = 0;  // from the eye; slope: of the highest, up by along
  };

  Seen look_around(const Panorama& panorama, const std::vector<PlanPoint>& spots, const std::vector<bool>& listed,
                   double nearest_m) const {
    Seen seen;
    std::unordered_set<std::uint32_t> found;
    const Vec3 eye = place(panorama.eye, panorama.eye_up_m);
    for (std::size_t i = 0; i < spots.size(); ++i) {
      const Vec3 from = place(spots[i], height_m(city_.terrain, spots[i]) + kEye_m);
      for (int k = 0; k < options_.directions; ++k) {
        // Each spot looks between the directions of the others.
        const double turn = 2 * std::numbers::pi * (k + static_cast<double>(i) / static_cast<double>(spots.size())) /
                            options_.directions;
        for (double up = kLowest, step = 0; up < kHighest; up += step) {
          step = up < kFineUpTo ? kFineStep : kCoarseStep;
          const Vec3 way{std::sin(turn), std::cos(turn), std::tan(up)};
          const auto hit = far_.scene.first_hit(from, way, 0);
          if (!hit) break;  // the sky: nothing stands above it but what hangs
          // Nothing is seen over a wall below its top.
          if (const double top_m = level_top(hit->triangle); top_m > from[2])
            step = std::max(step, std::atan((top_m - from[2]) / hit->t) - up + kOverTop);
          if (listed[sector_of(hit->triangle)]) continue;
          const Vec3 to = from + way * hit->t - eye;
          const double away = std::hypot(to[0], to[1]);
          if (away < nearest_m) continue;
          found.insert(hit->triangle);
          ++seen.hits;
          seen.near_m = std::min(seen.near_m, away);
          seen.far_m = std::max(seen.far_m, away);
          seen.slope = std::max(seen.slope, to[2] / away);
        }
      }
    }
    seen.triangles = whole_faces(found);
    seen.slope = std::min(seen.slope, std::tan(kHighest));
    return seen;
  }

  /// The triangles of its face: a fan's stand one after the other and have their first corner in common.
  std::pair<std::uint32_t, std::uint32_t> face_of(std::uint32_t triangle) const {
    const auto& all = far_.scene.mesh().triangles;
    std::uint32_t first = triangle, last = triangle + 1;
    while (first > 0 && all[first - 1].corners[0] == all[triangle].corners[0]) --first;
    while (last < all.size() && all[last].corners[0] == all[triangle].corners[0]) ++last;
    return {first, last};
  }

  /// Height above the plan frame's 0 of the top of an upright face, where that is a level edge; else far below all.
  double level_top(std::uint32_t triangle) const {
    const RenderMesh& mesh = far_.scene.mesh();
    const auto corner = [&](std::uint32_t i) -> Vec3 {
      const auto& p = mesh.points[i];
      return {p[0], p[1], p[2]};
    };
    const auto& c = mesh.triangles[triangle].corners;
    const Vec3 normal = cross(corner(c[1]) - corner(c[0]), corner(c[2]) - corner(c[0]));
    if (std::abs(normal[2]) > kUpright * length(normal)) return -HUGE_VAL;
    const auto [first, last] = face_of(triangle);
    std::vector<Vec3> corners;
    for (std::uint32_t k = first; k < last; ++k)
      for (const std::uint32_t i : mesh.triangles[k].corners) corners.push_back(corner(i));
    double top = -HUGE_VAL;
    for (const Vec3& p : corners) top = std::max(top, p[2]);
    std::erase_if(corners, [&](const Vec3& p) { return p[2] < top - kLevel_m; });
    const auto is_apart = [&](const Vec3& p) {
      return std::hypot(p[0] - corners[0][0], p[1] - corners[0][1]) > kLevel_m;
    };
    return std::any_of(corners.begin(), corners.end(), is_apart) ? top + mesh.origin[2] : -HUGE_VAL;
  }

  std::vector<std::uint32_t> whole_faces(const std::unordered_set<std::uint32_t>& found) const {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t i : found) {
      const auto [first, last] = face_of(i);
      for (std::uint32_t k = first; k < last; ++k) out.push_back(k);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  std::size_t sector_of(std::uint32_t triangle) const {
    const auto& first = far_.first_triangle;
    return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), triangle) - first.begin()) - 1;
  }

  void draw(Panorama& out, const RayScene& scene) const {
    const Enu eye{metres(out.eye.x), metres(out.eye.y), out.eye_up_m};
    const double width_m = distance_m(panorama_edge(out.eye, out.radius_m, 0), panorama_edge(out.eye, out.radius_m, 1));
    RenderOptions size;
    size.width = options_.side_px;
    size.height = kLeastHeight_px;
    while (size.height < options_.side_px * (out.top_m - out.bottom_m) / width_m && size.height < options_.side_px)
      size.height *= 2;
    size.samples = options_.samples;
    std::vector<CutOut> pictures;
    for (int k = 0; k < kPanoramaSides; ++k) {
      const Vec3 left = place(panorama_edge(out.eye, out.radius_m, k), 0),
                 right = place(panorama_edge(out.eye, out.radius_m, k + 1), 0);
      View view = render(scene, camera_through(eye, left, right, out.bottom_m, out.top_m), size);
      const auto& pixels = view.cut_out.pixels;
      if (std::none_of(pixels.begin(), pixels.end(), [](const Rgba& p) { return p[3] > 0.5f; })) continue;
      out.sides |= 1u << k;
      pictures.push_back(std::move(view.cut_out));
    }
    if (pictures.empty()) return;
    out.width_px = static_cast<std::uint32_t>(size.width) * static_cast<std::uint32_t>(pictures.size());
    out.height_px = static_cast<std::uint32_t>(size.height);
    out.png = cut_out_png(pictures, options_.colours);
  }

  const City& city_;
  const FarCity& far_;
  const PanoramaOptions& options_;
};

}  // namespace

bool is_open(const Sector& sector, const PanoramaOptions& options) {
  return (sector.kind == SectorKind::square || sector.kind == SectorKind::open) &&
         triangles_of(sector).area_m2 >= options.least_ground_m2;
}

std::vector<Panorama> bake_panoramas(const City& city, const FarCity& far, const PanoramaOptions& options,
                                     const std::function<void(std::size_t)>& on_sector) {
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < city.sectors.size(); ++i) index.emplace(city.sectors[i].id, i);
  std::vector<std::vector<std::size_t>> lists(city.sectors.size());
  const auto list = [&](const std::string& from, const std::string& to) {
    const auto a = index.find(from), b = index.find(to);
    if (a != index.end() && b != index.end()) lists[a->second].push_back(b->second);
  };
  for (const Visible& v : city.visible) list(v.sector_id, v.visible_sector_id);
  for (const Gate& g : city.gates) list(g.sector_id, g.to_sector_id);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < city.sectors.size(); ++i)
    if (is_open(city.sectors[i], options)) open.push_back(i);
  std::vector<std::optional<Panorama>> found(open.size());
  std::atomic<std::size_t> done{0};
  const PanoramaBaker baker(city, far, options);
  run_parallel(open.size(), thread_count(options.threads), [&](std::size_t k, unsigned) {
    std::vector<bool> listed(city.sectors.size());
    listed[open[k]] = true;
    for (const std::size_t i : lists[open[k]]) listed[i] = true;
    found[k] = baker.run(city.sectors[open[k]], listed);
    const std::size_t count = ++done;
    if (on_sector) on_sector(count);
  });
  std::vector<Panorama> out;
  for (auto& panorama : found)
    if (panorama) out.push_back(std::move(*panorama));
  return out;
}

}  // namespace vicus
