#include "sectorgen/models/lay_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

#include "city_db/boxes.hpp"
#include "city_db/house_parts.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/models/ground_mesh.hpp"
#include "sectorgen/models/roof_city.hpp"
#include "sectorgen/sectors/locator.hpp"

namespace vicus {
namespace {

const std::int32_t kKerb_mm = lattice_mm(kKerb_m);
/// Nodes of the terrain where the ground bends by more than this from node to node, and every fourth, shape the ground.
constexpr std::int32_t kBend_mm = 150;
constexpr std::uint32_t kEvery = 4;

std::int32_t terrain_mm(const Terrain& terrain, PlanPoint at) { return lattice_mm(height_m(terrain, at)); }

std::vector<PlanPoint> shaping_nodes(const City& city) {
  const Terrain& t = city.terrain;
  std::vector<PlanPoint> out;
  PlanBox box;
  for (const auto& s : city.sectors)
    for (const auto& p : s.ground.outer) box.add(p);
  const auto at = [&](std::uint32_t c, std::uint32_t r) { return t.height_mm[std::size_t{r} * t.columns + c]; };
  for (std::uint32_t r = 0; r < t.rows; ++r)
    for (std::uint32_t c = 0; c < t.columns; ++c) {
      const PlanPoint p{t.corner.x + static_cast<std::int32_t>(c) * t.step_mm,
                        t.corner.y + static_cast<std::int32_t>(r) * t.step_mm};
      if (!box.contains(p)) continue;
      const bool is_regular = c % kEvery == 0 && r % kEvery == 0;
      const bool is_inside = c > 0 && r > 0 && c + 1 < t.columns && r + 1 < t.rows;
      const auto bends = [&] {
        return std::abs(at(c - 1, r) - 2 * at(c, r) + at(c + 1, r)) > kBend_mm ||
               std::abs(at(c, r - 1) - 2 * at(c, r) + at(c, r + 1)) > kBend_mm;
      };
      if (is_regular || (is_inside && bends())) out.push_back(p);
    }
  return out;
}

/// Heights of the mesh's corners, as each triangle sees them.
class GroundHeights {
 public:
  GroundHeights(const City& city, const GroundMesh& ground, const std::vector<Patch>& patches)
      : city_(city), ground_(ground), patches_(patches) {
    vertex_mm_.reserve(ground.mesh.points.size());
    for (PlanPoint p : ground.mesh.points) vertex_mm_.push_back(terrain_mm(city.terrain, p));
  }

  /// Of vertex v, seen from triangle t; the terrain where t is nobody's, or kNone.
  std::int32_t at(std::uint32_t t, std::uint32_t v) const {
    if (t == kNone) return vertex_mm_[v];
    const GroundCell& cell = ground_.cells[t];
    if (cell.sector == kNone) return vertex_mm_[v];
    if (cell.kind == SurfaceKind::water && !cell.is_walkable) return water_mm(cell.obstacle);
    if (cell.tread != kNone && !city_.terrain.height_mm.empty()) return tread_mm(cell.tread);
    return vertex_mm_[v] + lattice_mm(cell.raised_m) - (cell.is_sunk ? kKerb_mm : 0);
  }

  /// Of a place in triangle t: on the plane through its corners.
  double metres_at(std::uint32_t t, PlanPoint p) const {
    const Mesh& m = ground_.mesh;
    const PlanPoint a = m.points[m.corner(t, 0)], b = m.points[m.corner(t, 1)], c = m.points[m.corner(t, 2)];
    const auto cross = [](PlanPoint o, PlanPoint u, PlanPoint v) {
      return double(u.x - o.x) * double(v.y - o.y) - double(u.y - o.y) * double(v.x - o.x);
    };
    const double all = cross(a, b, c), wa = cross(p, b, c) / all, wb = cross(a, p, c) / all;
    return (wa * at(t, m.corner(t, 0)) + wb * at(t, m.corner(t, 1)) + (1 - wa - wb) * at(t, m.corner(t, 2))) /
           kMmPerMetre;
  }

 private:
  std::int32_t water_mm(std::uint32_t obstacle) const {
    const auto [it, is_new] = water_.emplace(obstacle, 0);
    if (is_new) {
      std::int32_t least = std::numeric_limits<std::int32_t>::max();
      for (PlanPoint p : city_.obstacles[obstacle].area.outer) least = std::min(least, terrain_mm(city_.terrain, p));
      it->second = least - lattice_mm(kWaterBelow_m);
    }
    return it->second;
  }
  std::int32_t tread_mm(std::uint32_t patch) const {
    std::int64_t x = 0, y = 0;
    const Ring& ring = patches_[patch].area.outer;
    for (PlanPoint p : ring) x += p.x, y += p.y;
    const auto n = static_cast<std::int64_t>(ring.size());
    return terrain_mm(city_.terrain, {static_cast<std::int32_t>(x / n), static_cast<std::int32_t>(y / n)});
  }

  const City& city_;
  const GroundMesh& ground_;
  const std::vector<Patch>& patches_;
  std::vector<std::int32_t> vertex_mm_;
  mutable std::unordered_map<std::uint32_t, std::int32_t> water_;
};

/// Gathers the triangles of each sector and kind.
class SurfaceGatherer {
 public:
  void add(std::uint32_t sector, SurfaceKind kind, const std::array<GroundPoint, 3>& corners) {
    Gathered& g = gathered_[{sector, kind}];
    for (const GroundPoint& p : corners) {
      const auto [at, is_new] = g.number.emplace(p, static_cast<std::uint32_t>(g.surface.points.size()));
      if (is_new) g.surface.points.push_back(p);
      g.surface.triangles.push_back(at->second);
    }
  }
  std::vector<Surface> take(const City& city) {
    std::vector<Surface> out;
    for (auto& [key, g] : gathered_) {
      g.surface.sector_id = city.sectors[key.first].id;
      g.surface.kind = key.second;
      out.push_back(std::move(g.surface));
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Surface& a, const Surface& b) { return a.sector_id < b.sector_id; });
    return out;
  }

 private:
  struct Gathered {
    Surface surface;
    std::map<GroundPoint, std::uint32_t> number;
  };
  std::map<std::pair<std::uint32_t, SurfaceKind>, Gathered> gathered_;
};

/// Two treads that follow each other differ in colour.
SurfaceKind shown_kind(const GroundCell& cell) {
  if (cell.kind == SurfaceKind::steps && cell.tread % 2 == 1) return SurfaceKind::paving;
  return cell.kind;
}

/// The upright face over side k of t where the ground beyond is higher, seen from t:  q1--p1
///                                                                                   q0--p0
void add_riser(const GroundMesh& ground, const GroundHeights& heights, std::uint32_t t, int k, SurfaceGatherer& out) {
  const Mesh& mesh = ground.mesh;
  const std::uint32_t n = mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
  const GroundCell& low = ground.cells[t];
  if (low.sector == kNone || low.raised_m > 0 || (n != kNone && ground.cells[n].raised_m > 0)) return;
  const std::uint32_t p = mesh.corner(t, k + 1), q = mesh.corner(t, k + 2);
  const GroundPoint p0{mesh.points[p], heights.at(t, p)}, q0{mesh.points[q], heights.at(t, q)};
  const GroundPoint p1{mesh.points[p], heights.at(n, p)}, q1{mesh.points[q], heights.at(n, q)};
  if (p1.up_mm > p0.up_mm) out.add(low.sector, SurfaceKind::kerb, {q0, p0, p1});
  if (q1.up_mm > q0.up_mm) out.add(low.sector, SurfaceKind::kerb, {q0, p1.up_mm > p0.up_mm ? p1 : p0, q1});
}

std::vector<Surface> surfaces_of(const City& city, const GroundMesh& ground, const GroundHeights& heights) {
  SurfaceGatherer gatherer;
  const Mesh& mesh = ground.mesh;
  for (std::uint32_t t = 0; t < ground.cells.size(); ++t) {
    const GroundCell& cell = ground.cells[t];
    if (cell.sector == kNone) continue;
    std::array<GroundPoint, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.corner(t, k);
      corners[static_cast<std::size_t>(k)] = {mesh.points[v], heights.at(t, v)};
    }
    gatherer.add(cell.sector, shown_kind(cell), corners);
    for (int k = 0; k < 3; ++k) add_riser(ground, heights, t, k, gatherer);
  }
  return gatherer.take(city);
}

/// Ground heights along the foot of a house, every metre.
std::vector<double> heights_around(const Terrain& terrain, const Polygon& footprint) {
  constexpr double kStep_mm = 1000;
  std::vector<double> out;
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      const int steps = 1 + static_cast<int>(std::sqrt(static_cast<double>(distance2(a, b))) / kStep_mm);
      for (int k = 0; k < steps; ++k)
        out.push_back(height_m(terrain, {a.x + static_cast<std::int32_t>(std::int64_t{b.x - a.x} * k / steps),
                                         a.y + static_cast<std::int32_t>(std::int64_t{b.y - a.y} * k / steps)}));
    }
  };
  add_ring(footprint.outer);
  for (const auto& hole : footprint.holes) add_ring(hole);
  return out;
}

void stand_houses(City& city) {
  if (city.terrain.height_mm.empty()) return;
  std::unordered_map<std::string, double> at_door;
  for (const Facade& f : city.facades)
    if (f.door_bay >= 0) {
      const double share = 1 - (f.door_bay + 0.5) / (f.bays * f.repeats);
      at_door.emplace(f.building_id,
                      height_m(city.terrain, {f.a.x + static_cast<std::int32_t>((f.b.x - f.a.x) * share),
                                              f.a.y + static_cast<std::int32_t>((f.b.y - f.a.y) * share)}));
    }
  // A house's parts stand at one level, or its walls would part.
  std::map<std::string, std::vector<Building*>> houses;
  for (Building& b : city.buildings) houses[b.tags.contains(kPartOf) ? house_of(b) : "b " + b.id].push_back(&b);
  for (const auto& [name, parts] : houses) {
    std::vector<double> all;
    std::optional<double> level;
    std::vector<double> lowest;
    for (const Building* part : parts) {
      const auto around = heights_around(city.terrain, part->footprint);
      lowest.push_back(around.empty() ? HUGE_VAL : *std::min_element(around.begin(), around.end()));
      all.insert(all.end(), around.begin(), around.end());
      if (const auto door = at_door.find(part->id); door != at_door.end() && !level) level = door->second;
    }
    if (all.empty()) continue;
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i]->ground_m = metres(lattice_mm(level.value_or(all[all.size() / 2])));
      parts[i]->foot_m = metres(lattice_mm(parts[i]->ground_m - std::min(lowest[i], all.back()) + kBuried_m));
    }
  }
  update_side_walls(city);
}

/// How far the foot of a wall hangs above the ground before it, where it does most.
double largest_gap(const City& city) {
  std::map<std::string, std::map<PlanPoint, std::int32_t>> ground;
  for (const Surface& s : city.surfaces)
    if (s.kind != SurfaceKind::kerb && s.kind != SurfaceKind::water)
      for (const auto& p : s.points) {
        const auto [at, is_new] = ground[s.sector_id].emplace(p.at, p.up_mm);
        if (!is_new) at->second = std::min(at->second, p.up_mm);
      }
  std::unordered_map<std::string, const Building*> houses;
  for (const auto& h : city.buildings) houses.emplace(h.id, &h);
  double gap = 0;
  for (const Border& b : city.borders) {
    const auto house = houses.find(b.building_id);
    if (b.kind != BorderKind::facade || house == houses.end() || house->second->base_m > 0) continue;
    const double foot_m = house->second->ground_m - house->second->foot_m;
    for (PlanPoint p : b.line)
      if (const auto at = ground[b.sector_id].find(p); at != ground[b.sector_id].end())
        gap = std::max(gap, foot_m - metres(at->second));
  }
  return gap;
}

}  // namespace

GroundFigures lay_ground(const SourceMap& map, City& city, unsigned threads) {
  const auto patches = ground_patches(map, city, threads);
  const auto nodes = city.terrain.height_mm.empty() ? std::vector<PlanPoint>() : shaping_nodes(city);
  const GroundMesh ground = mesh_ground(city, patches, nodes);
  const GroundHeights heights(city, ground, patches);
  city.surfaces = surfaces_of(city, ground, heights);
  const Locator locator(ground.mesh);
  const auto height_at = [&](PlanPoint p) {
    const std::uint32_t t = locator.locate(p);
    return t == kNone ? height_m(city.terrain, p) : metres(lattice_mm(heights.metres_at(t, p)));
  };
  for (auto& object : city.objects) object.ground_m = height_at(object.at);
  for (auto& view : city.viewpoints) view.ground_m = height_at(view.at);
  stand_houses(city);
  GroundFigures figures;
  for (const auto& s : city.surfaces) figures.triangles += s.triangles.size() / 3;
  figures.largest_gap_m = largest_gap(city);
  return figures;
}

}  // namespace vicus
