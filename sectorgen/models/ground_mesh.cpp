#include "sectorgen/models/ground_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

#include "sectorgen/geom/noding.hpp"

namespace vicus {
namespace {

constexpr double kSeenOver_m = 1.6;  // who is taller looks down on the top of a wall

enum class Owner : char { sector, obstacle, patch };

/// A polygon whose covers are counted.
struct Part {
  Owner owner = Owner::sector;
  std::uint32_t index = 0;
};

/// What covers a triangle: counts and sums, so that every way through the mesh leads to the same.
struct Covers {
  std::int32_t sectors = 0, obstacles = 0, treads = 0;
  std::int64_t sector_sum = 0, obstacle_sum = 0, tread_sum = 0;
  std::array<std::int16_t, 10> kinds{};

  void add(const Part& part, int sign, const std::vector<Patch>& patches) {
    switch (part.owner) {
      case Owner::sector:
        sectors += sign;
        sector_sum += sign * std::int64_t{part.index};
        break;
      case Owner::obstacle:
        obstacles += sign;
        obstacle_sum += sign * std::int64_t{part.index};
        break;
      case Owner::patch: {
        const Patch& patch = patches[part.index];
        kinds[static_cast<std::size_t>(patch.kind)] =
            static_cast<std::int16_t>(kinds[static_cast<std::size_t>(patch.kind)] + sign);
        if (!patch.is_tread) break;
        treads += sign;
        tread_sum += sign * std::int64_t{part.index};
        break;
      }
    }
  }
};

struct Crossing {
  std::uint32_t part = 0;
  bool is_forward = true;  // the part lies on the left of the edge from its smaller point to its greater
};

struct PointHash {
  std::size_t operator()(const PlanPoint& p) const {
    return std::hash<std::uint64_t>()(std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32 |
                                      static_cast<std::uint32_t>(p.y));
  }
};

class Builder {
 public:
  Builder(const City& city, const std::vector<Patch>& patches) : city_(city), patches_(patches) {
    for (std::size_t i = 0; i < city.sectors.size(); ++i) add(Owner::sector, i, city.sectors[i].ground);
    for (std::size_t i = 0; i < city.obstacles.size(); ++i) add(Owner::obstacle, i, city.obstacles[i].area);
    for (std::size_t i = 0; i < patches.size(); ++i) add(Owner::patch, i, patches[i].area);
  }

  GroundMesh run(const std::vector<PlanPoint>& free_points) {
    for (PlanPoint p : free_points) {  // a millimetre long, so that noding splits an edge on which one lies
      segments_.push_back({p, {p.x + 1, p.y}});
      part_of_.push_back(kNone);
    }
    node();
    GroundMesh out{triangulate_edges(points_, edges_), {}};
    const auto covers = flood_from_hull(out.mesh, Covers(), [&](Covers value, std::uint32_t t, int k) {
      const std::uint32_t edge = out.mesh.triangles[t].edge[static_cast<std::size_t>(k)];
      if (edge == kNone) return value;
      // t lies on the left of its own side.
      const bool is_forward = out.mesh.points[out.mesh.corner(t, k + 1)] < out.mesh.points[out.mesh.corner(t, k + 2)];
      for (const Crossing& c : crossings_[edge])
        value.add(parts_[c.part], c.is_forward == is_forward ? 1 : -1, patches_);
      return value;
    });
    out.cells.resize(covers.size());
    for (std::size_t t = 0; t < covers.size(); ++t) out.cells[t] = cell_of(covers[t]);
    give_to_neighbours(out, covers);
    return out;
  }

 private:
  void add(Owner owner, std::size_t index, const Polygon& polygon) {
    const auto part = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back({owner, static_cast<std::uint32_t>(index)});
    const auto add_ring = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        segments_.push_back({ring[i], ring[(i + 1) % ring.size()]});
        part_of_.push_back(part);
      }
    };
    add_ring(polygon.outer);
    for (const auto& hole : polygon.holes) add_ring(hole);
  }

  std::uint32_t number_of(PlanPoint p) {
    const auto [at, is_new] = numbers_.emplace(p, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(p);
    return at->second;
  }

  void node() {
    const Noded noded = node_segments(segments_);
    std::unordered_map<std::uint64_t, std::uint32_t> edge_of;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (part_of_[s] == kNone) {
        number_of(noded.points[noded.begin[s]]);
        continue;
      }
      for (std::uint32_t i = noded.begin[s]; i + 1 < noded.begin[s + 1]; ++i) {
        const PlanPoint p = noded.points[i], q = noded.points[i + 1];
        if (p == q) continue;
        const std::uint32_t a = number_of(std::min(p, q)), b = number_of(std::max(p, q));
        const auto [at, is_new] =
            edge_of.emplace(std::uint64_t{a} << 32 | b, static_cast<std::uint32_t>(edges_.size()));
        if (is_new) {
          edges_.push_back({a, b});
          crossings_.emplace_back();
        }
        crossings_[at->second].push_back({part_of_[s], p < q});
      }
    }
    segments_ = {};
  }

  GroundCell cell_of(const Covers& c) const {
    GroundCell cell;
    if (c.sectors != 1) return cell;  // 0, or a crumb of rounding between two
    cell.sector = static_cast<std::uint32_t>(c.sector_sum);
    cell.is_walkable = true;
    cell.kind = plain_ground(city_.sectors[cell.sector].kind);
    const auto has = [&](SurfaceKind kind) { return c.kinds[static_cast<std::size_t>(kind)] > 0; };
    for (const SurfaceKind kind : kCoverOrder)
      if (has(kind)) {
        cell.kind = kind;
        break;
      }
    cell.is_sunk = has(SurfaceKind::carriageway);
    if (cell.kind == SurfaceKind::steps && c.treads > 0)
      cell.tread = static_cast<std::uint32_t>(c.tread_sum / c.treads);
    return cell;
  }

  /// What nobody walks on, but may see, belongs to the sector from which the way over such ground is shortest.
  void give_to_neighbours(GroundMesh& out, const std::vector<Covers>& covers) const {
    struct Step {
      double distance = 0;
      std::uint32_t triangle = 0, sector = kNone;
      bool operator<(const Step& o) const {
        return std::tie(o.distance, o.sector, o.triangle) < std::tie(distance, sector, triangle);
      }
    };
    const auto is_seen = [&](std::uint32_t t) {
      if (covers[t].sectors != 0 || covers[t].obstacles < 1) return false;
      const Obstacle& o = city_.obstacles[static_cast<std::size_t>(covers[t].obstacle_sum / covers[t].obstacles)];
      return o.kind != ObstacleKind::courtyard && (o.kind != ObstacleKind::wall || o.height_m < kSeenOver_m);
    };
    std::priority_queue<Step> queue;
    const auto centre = [&](std::uint32_t t) {
      double x = 0, y = 0;
      for (int k = 0; k < 3; ++k)
        x += out.mesh.points[out.mesh.corner(t, k)].x, y += out.mesh.points[out.mesh.corner(t, k)].y;
      return std::pair(x / 3, y / 3);
    };
    const auto push_around = [&](std::uint32_t t, double distance, std::uint32_t sector) {
      const auto [x, y] = centre(t);
      for (const std::uint32_t n : out.mesh.triangles[t].neighbour) {
        if (n == kNone || out.cells[n].sector != kNone || !is_seen(n)) continue;
        const auto [nx, ny] = centre(n);
        queue.push({distance + std::hypot(nx - x, ny - y), n, sector});
      }
    };
    for (std::uint32_t t = 0; t < out.cells.size(); ++t)
      if (out.cells[t].is_walkable) push_around(t, 0, out.cells[t].sector);
    while (!queue.empty()) {
      const Step step = queue.top();
      queue.pop();
      GroundCell& cell = out.cells[step.triangle];
      if (cell.sector != kNone) continue;
      cell.sector = step.sector;
      const Covers& c = covers[step.triangle];
      cell.obstacle = static_cast<std::uint32_t>(c.obstacle_sum / c.obstacles);
      const Obstacle& o = city_.obstacles[cell.obstacle];
      cell.kind = o.kind == ObstacleKind::water  ? SurfaceKind::water
                  : o.kind == ObstacleKind::yard ? SurfaceKind::grass
                  : o.kind == ObstacleKind::wall ? SurfaceKind::kerb
                                                 : SurfaceKind::earth;
      if (o.kind == ObstacleKind::wall) cell.raised_m = o.height_m;
      push_around(step.triangle, step.distance, step.sector);
    }
  }

  const City& city_;
  const std::vector<Patch>& patches_;
  std::vector<Part> parts_;
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> part_of_;
  std::vector<PlanPoint> points_;
  std::unordered_map<PlanPoint, std::uint32_t, PointHash> numbers_;
  std::vector<Edge> edges_;
  std::vector<std::vector<Crossing>> crossings_;
};

}  // namespace

GroundMesh mesh_ground(const City& city, const std::vector<Patch>& patches, const std::vector<PlanPoint>& free_points) {
  return Builder(city, patches).run(free_points);
}

}  // namespace vicus
