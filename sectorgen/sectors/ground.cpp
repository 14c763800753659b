#include "sectorgen/sectors/ground.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "city_db/issues.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/locator.hpp"

namespace vicus {
namespace {

enum CoverLayer { kHouse, kWall, kWater, kDomain, kLayers };  // as in MapLayer
using Cover = std::array<std::int16_t, kLayers>;

/// A distinct noded edge (a < b): what its left side has more than its right.
struct LayerEdge {
  PlanPoint a, b;
  Cover delta{};
  bool is_kerb = false;
  bool matters() const { return is_kerb || delta != Cover{}; }
};

std::vector<LayerEdge> layer_edges(const std::vector<NodedPart>& map) {
  std::vector<LayerEdge> all;
  for (const auto& part : map) {
    if (part.layer == MapLayer::overhead) continue;  // bounds nothing on the ground
    const bool is_kerb = part.layer == MapLayer::kerb;
    for (std::size_t i = 0; i + (is_kerb ? 1 : 0) < part.points.size(); ++i) {
      const PlanPoint p = part.points[i], q = part.points[i + 1 == part.points.size() ? 0 : i + 1];
      if (p == q) continue;
      LayerEdge e{std::min(p, q), std::max(p, q), {}, is_kerb};
      if (!is_kerb) e.delta[static_cast<std::size_t>(part.layer)] = p < q ? 1 : -1;
      all.push_back(e);
    }
  }
  std::sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  std::vector<LayerEdge> out;
  for (const auto& e : all) {
    if (out.empty() || out.back().a != e.a || out.back().b != e.b) {
      if (!out.empty() && !out.back().matters()) out.pop_back();
      out.push_back(e);
      continue;
    }
    for (std::size_t l = 0; l < kLayers; ++l)
      out.back().delta[l] = static_cast<std::int16_t>(out.back().delta[l] + e.delta[l]);
    out.back().is_kerb = out.back().is_kerb || e.is_kerb;
  }
  if (!out.empty() && !out.back().matters()) out.pop_back();
  return out;
}

Mesh mesh_of(const std::vector<std::pair<PlanPoint, PlanPoint>>& pieces) {
  std::vector<PlanPoint> points;
  std::vector<Edge> edges;
  for (const auto& [a, b] : pieces) {
    const auto i = static_cast<std::uint32_t>(points.size());
    points.push_back(a);
    points.push_back(b);
    edges.push_back({i, i + 1});
  }
  return triangulate_edges(points, edges);
}

/// How many features of each layer cover each triangle.
std::vector<Cover> flood(const Mesh& mesh, const std::vector<LayerEdge>& edges) {
  return flood_from_hull(mesh, Cover{}, [&](Cover cover, std::uint32_t t, int k) {
    const std::uint32_t e = mesh.triangles[t].edge[static_cast<std::size_t>(k)];
    if (e == kNone) return cover;
    const bool forward = mesh.corner(t, k + 1) < mesh.corner(t, k + 2);  // points are sorted, so a < b
    for (std::size_t l = 0; l < kLayers; ++l)
      cover[l] = static_cast<std::int16_t>(cover[l] + (forward ? edges[e].delta[l] : -edges[e].delta[l]));
    return cover;
  });
}

bool is_free(const Cover& c) { return c[kDomain] > 0 && c[kHouse] <= 0 && c[kWall] <= 0 && c[kWater] <= 0; }
Beyond beyond_of(const Cover& c) {
  return c[kHouse] > 0   ? Beyond::house
         : c[kWall] > 0  ? Beyond::wall
         : c[kWater] > 0 ? Beyond::water
                         : Beyond::city_edge;
}

/// Components of blocked triangles inside the city that are small and touch no other: island number per triangle.
std::vector<std::uint32_t> find_islands(const Mesh& mesh, const std::vector<Cover>& cover, double limit_m2,
                                        std::uint32_t& count) {
  const std::size_t n = mesh.triangles.size();
  std::vector<std::uint32_t> component(n, kNone);
  std::vector<std::uint32_t> of_point(mesh.points.size(), kNone);
  std::vector<char> shared;  // per component: touches another one, or the city's edge
  std::vector<double> area;
  for (std::uint32_t seed = 0; seed < n; ++seed) {
    if (component[seed] != kNone || is_free(cover[seed])) continue;
    const auto id = static_cast<std::uint32_t>(area.size());
    area.push_back(0);
    shared.push_back(0);
    std::vector<std::uint32_t> queue{seed};
    component[seed] = id;
    while (!queue.empty()) {
      const std::uint32_t t = queue.back();
      queue.pop_back();
      const auto& c = mesh.triangles[t].corner;
      area[id] += static_cast<double>(orient(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]])) / 2e6;
      if (cover[t][kDomain] <= 0) shared[id] = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t p = c[k];
        if (of_point[p] != kNone && of_point[p] != id) shared[id] = shared[of_point[p]] = 1;
        of_point[p] = id;
        const std::uint32_t m = mesh.triangles[t].neighbour[k];
        if (m == kNone) shared[id] = 1;
        if (m == kNone || component[m] != kNone || is_free(cover[m])) continue;
        component[m] = id;
        queue.push_back(m);
      }
    }
  }
  std::vector<std::uint32_t> number(area.size(), kNone);
  count = 0;
  for (std::size_t i = 0; i < area.size(); ++i)
    if (!shared[i] && area[i] < limit_m2) number[i] = count++;
  std::vector<std::uint32_t> island(n, kNone);
  for (std::size_t t = 0; t < n; ++t)
    if (component[t] != kNone) island[t] = number[component[t]];
  return island;
}

/// Candidate vertices on one bounding edge: feet of the apexes seen from it, and evenly spaced points.
struct Candidates {
  std::vector<PlanPoint> feet;
};

constexpr std::int64_t kFootFromEnd = 700, kFootApart = 500;  // mm (research/SECTORS.md §4.2)

PlanPoint point_along(PlanPoint a, PlanPoint b, std::int64_t numerator, std::int64_t denominator) {
  const auto part = [&](std::int32_t from, std::int32_t to) {
    const Int128 twice = 2 * Int128{numerator} * (std::int64_t{to} - from) + denominator;
    Int128 q = twice / (2 * Int128{denominator});
    if (twice % (2 * Int128{denominator}) < 0) --q;
    return static_cast<std::int32_t>(from + static_cast<std::int64_t>(q));
  };
  return {part(a.x, b.x), part(a.y, b.y)};
}

/// f is on ab, or inside the triangle of ab and the centroid of the empty triangle on f's side. Those triangles are
/// convex and disjoint for all edges, so no bent edges meet however many bends they get.
bool keeps_clear(const Mesh& mesh, std::uint32_t t, int k, PlanPoint a, PlanPoint b, PlanPoint f) {
  const std::int64_t side = orient(a, b, f);
  if (side == 0) return dot(f, a, b) < 0;
  const PlanPoint u = mesh.points[mesh.corner(t, k + 1)];
  const bool in_t = (side > 0) == (u == a);  // t lies left of its edge
  std::uint32_t host = t;
  int edge = k;
  if (!in_t) {
    host = mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
    if (host == kNone) return true;  // beyond the hull is nothing
    edge = mesh.twin_side(t, k);
  }
  const PlanPoint p = mesh.points[mesh.corner(host, edge)], q = mesh.points[mesh.corner(host, edge + 1)],
                  r = mesh.points[mesh.corner(host, edge + 2)];
  return std::abs(side) < orient(p, q, f) && std::abs(side) < orient(r, p, f);
}

/// The accepted candidates of edge k of free triangle t, in order from its smaller end.
std::vector<PlanPoint> candidates(const Mesh& mesh, std::uint32_t t, int k, double piece_m) {
  const PlanPoint u = mesh.points[mesh.corner(t, k + 1)], v = mesh.points[mesh.corner(t, k + 2)];
  const PlanPoint a = std::min(u, v), b = std::max(u, v);
  const std::int64_t length2 = distance2(a, b), length = integer_sqrt(length2);
  if (length < 2 * kFootFromEnd) return {};
  std::vector<std::int64_t> along;  // mm from a
  const std::int64_t foot = dot(a, b, mesh.points[mesh.corner(t, k)]);
  if (foot > 0 && foot < length2) {
    const std::int64_t mm = foot / std::max<std::int64_t>(1, length);
    if (mm >= kFootFromEnd && mm <= length - kFootFromEnd) along.push_back(mm);
  }
  const auto piece = static_cast<std::int64_t>(piece_m * kMmPerMetre);
  std::vector<std::int64_t> stops{0};
  stops.insert(stops.end(), along.begin(), along.end());
  stops.push_back(length);
  std::vector<std::int64_t> all = along;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const std::int64_t gap = stops[i + 1] - stops[i], n = gap / piece + 1;
    for (std::int64_t j = 1; j < n; ++j) all.push_back(stops[i] + gap * j / n);
  }
  std::sort(all.begin(), all.end());
  std::vector<PlanPoint> out;
  std::int64_t last = -kFootApart;
  for (std::int64_t mm : all) {
    if (mm - last < kFootApart) continue;
    const PlanPoint f = point_along(a, b, mm, length);
    if (!keeps_clear(mesh, t, k, a, b, f)) continue;
    out.push_back(f);
    last = mm;
  }
  return out;
}

/// Outlines of the marked triangles, inside on the left, as polygons.
std::vector<Polygon> outline(const Mesh& mesh, const std::vector<std::uint32_t>& triangles,
                             const std::vector<std::uint32_t>& group, std::uint32_t id) {
  std::vector<std::pair<PlanPoint, PlanPoint>> out;
  for (std::uint32_t t : triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
      if (n == kNone || group[n] != id)
        out.push_back({mesh.points[mesh.corner(t, k + 1)], mesh.points[mesh.corner(t, k + 2)]});
    }
  std::sort(out.begin(), out.end());
  std::vector<char> used(out.size(), 0);
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (used[i]) continue;
    Ring walk;
    for (std::size_t j = i; !used[j];) {
      used[j] = 1;
      walk.push_back(out[j].first);
      auto next =
          std::lower_bound(out.begin(), out.end(), std::make_pair(out[j].second, PlanPoint{-kPlanLimit, -kPlanLimit}));
      while (next != out.end() && next->first == out[j].second && used[static_cast<std::size_t>(next - out.begin())])
        ++next;
      if (next == out.end() || next->first != out[j].second) break;
      j = static_cast<std::size_t>(next - out.begin());
    }
    for (auto& ring : simple_rings(walk)) rings.push_back(std::move(ring));
  }
  return assemble(std::move(rings));
}

/// The constrained edges of the second mesh: sides of free ground with their T-vertices, and kerbs.
std::vector<GroundEdge> ground_edges(const Mesh& mesh, const std::vector<LayerEdge>& edges,
                                     const std::vector<Cover>& cover, const std::vector<std::uint32_t>& island,
                                     double piece_m, std::vector<GroundSide>& sides) {
  std::vector<GroundEdge> out;
  const auto free = [&](std::uint32_t t) { return t != kNone && (is_free(cover[t]) || island[t] != kNone); };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!free(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const auto s = static_cast<std::size_t>(k);
      const std::uint32_t e = mesh.triangles[t].edge[s], n = mesh.triangles[t].neighbour[s];
      if (e == kNone) continue;
      const PlanPoint u = mesh.points[mesh.corner(t, k + 1)], v = mesh.points[mesh.corner(t, k + 2)];
      if (free(n)) {
        // Inside an island, and where one meets the ground, nothing is left; a kerb counts once.
        const bool on_island = island[t] != kNone || island[n] != kNone;
        if (edges[e].is_kerb && !on_island && u < v) out.push_back({u, v, kNone});
        continue;
      }
      const Beyond what = n == kNone ? Beyond::city_edge : beyond_of(cover[n]);
      GroundSide side{u, v, what, candidates(mesh, t, k, piece_m)};
      if (v < u) std::reverse(side.added.begin(), side.added.end());
      PlanPoint last = u;
      const auto number = static_cast<std::uint32_t>(sides.size());
      for (PlanPoint p : side.added) {
        out.push_back({last, p, number});
        last = p;
      }
      out.push_back({last, v, number});
      sides.push_back(std::move(side));
    }
  }
  return out;
}

/// Free triangles of the second mesh: left of every bounding edge, and what hangs together with it.
std::vector<char> free_triangles(const Mesh& mesh, const std::vector<GroundEdge>& edges) {
  std::vector<char> free(mesh.triangles.size(), 0);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3 && !free[t]; ++k) {
      const std::uint32_t e = mesh.triangles[t].edge[static_cast<std::size_t>(k)];
      if (e == kNone || edges[e].is_kerb() || mesh.points[mesh.corner(t, k + 1)] != edges[e].a) continue;
      free[t] = 1;
      queue.push_back(t);
    }
  while (!queue.empty()) {
    const std::uint32_t t = queue.back();
    queue.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t n = mesh.triangles[t].neighbour[k], e = mesh.triangles[t].edge[k];
      if (n == kNone || free[n] || (e != kNone && !edges[e].is_kerb())) continue;
      free[n] = 1;
      queue.push_back(n);
    }
  }
  return free;
}

}  // namespace

bool Ground::is_city_edge(std::uint32_t t, int k) const {
  const std::uint32_t e = mesh.triangles[t].edge[static_cast<std::size_t>(k)];
  return is_free[t] && e != kNone && !edges[e].is_kerb() && sides[edges[e].side].beyond == Beyond::city_edge;
}

struct CoverMesh::Impl {
  std::vector<LayerEdge> edges;
  Mesh mesh;
  std::vector<Cover> cover;
  std::vector<Ring> domain;
  std::vector<Polygon> courtyards;
};

namespace {

/// Takes the cover's freedom from ground that no point reaches: courtyards become blocked, what is open to the city's
/// edge leaves the city. Returns the courtyards' triangles.
std::vector<std::uint32_t> shut_unreached(const Mesh& mesh, const std::vector<PlanPoint>& reach,
                                          std::vector<Cover>& cover) {
  std::vector<char> seen(mesh.triangles.size(), 0);
  std::vector<std::uint32_t> component, courtyards;
  bool at_edge = false;
  const auto flood_from = [&](std::uint32_t seed) {
    component.assign(1, seed);
    seen[seed] = 1;
    at_edge = false;
    for (std::size_t i = 0; i < component.size(); ++i)
      for (std::uint32_t n : mesh.triangles[component[i]].neighbour) {
        if (n == kNone || cover[n][kDomain] <= 0) at_edge = true;
        if (n == kNone || seen[n] || !is_free(cover[n])) continue;
        seen[n] = 1;
        component.push_back(n);
      }
  };
  const Locator locator(mesh);
  for (PlanPoint p : reach) {
    const std::uint32_t t = locator.locate(p);
    if (t != kNone && !seen[t] && is_free(cover[t])) flood_from(t);
  }
  for (std::uint32_t t = 0; t < seen.size(); ++t) {
    if (seen[t] || !is_free(cover[t])) continue;
    flood_from(t);
    if (!at_edge) courtyards.insert(courtyards.end(), component.begin(), component.end());
    for (std::uint32_t m : component) cover[m][at_edge ? kDomain : kWall] = at_edge ? 0 : 1;
  }
  return courtyards;
}

}  // namespace

CoverMesh::CoverMesh(const std::vector<NodedPart>& map, const std::vector<PlanPoint>& reach)
    : impl_(std::make_unique<Impl>()) {
  impl_->edges = layer_edges(map);
  std::vector<std::pair<PlanPoint, PlanPoint>> pieces;
  for (const auto& e : impl_->edges) pieces.push_back({e.a, e.b});
  const Mesh& mesh = impl_->mesh = mesh_of(pieces);
  impl_->cover = flood(mesh, impl_->edges);
  std::vector<std::uint32_t> group(mesh.triangles.size(), kNone);
  if (!reach.empty()) {
    const auto courtyards = shut_unreached(mesh, reach, impl_->cover);
    for (std::uint32_t t : courtyards) group[t] = 0;
    impl_->courtyards = outline(mesh, courtyards, group, 0);
  }
  std::vector<std::uint32_t> all;
  for (std::uint32_t t = 0; t < group.size(); ++t) {
    group[t] = impl_->cover[t][kDomain] > 0 ? 1 : kNone;
    if (group[t] == 1) all.push_back(t);
  }
  for (auto& p : outline(mesh, all, group, 1)) {
    impl_->domain.push_back(std::move(p.outer));
    for (auto& hole : p.holes) impl_->domain.push_back(std::move(hole));
  }
}

CoverMesh::~CoverMesh() = default;

namespace {

/// Small free-standing obstacles become islands; per triangle the island's number.
std::vector<std::uint32_t> take_islands(const CoverMesh::Impl& first, const GroundOptions& options,
                                        std::vector<Island>& islands) {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> island = find_islands(first.mesh, first.cover, options.island_m2, count);
  std::vector<std::vector<std::uint32_t>> members(count);
  for (std::uint32_t t = 0; t < island.size(); ++t)
    if (island[t] != kNone) members[island[t]].push_back(t);
  for (std::uint32_t i = 0; i < count; ++i) {
    auto polygons = outline(first.mesh, members[i], island, i);
    const bool is_island =
        polygons.size() == 1 &&
        !std::binary_search(options.no_islands.begin(), options.no_islands.end(), polygons[0].outer.front());
    if (is_island)
      islands.push_back({std::move(polygons[0]), beyond_of(first.cover[members[i].front()])});
    else
      for (std::uint32_t t : members[i]) island[t] = kNone;
  }
  return island;
}

}  // namespace

Ground make_ground(const CoverMesh& cover_mesh, const GroundOptions& options) {
  const CoverMesh::Impl& first = cover_mesh.impl();
  Ground ground;
  ground.domain = first.domain;
  ground.courtyards = first.courtyards;
  const std::vector<std::uint32_t> island = take_islands(first, options, ground.islands);
  ground.edges = ground_edges(first.mesh, first.edges, first.cover, island, options.piece_m, ground.sides);
  if (ground.edges.empty()) throw CityError("no open ground: the footprints and water fill the whole city outline", 4);

  std::vector<std::pair<PlanPoint, PlanPoint>> pieces;
  for (const auto& e : ground.edges) pieces.push_back({e.a, e.b});
  ground.mesh = mesh_of(pieces);
  ground.is_free = free_triangles(ground.mesh, ground.edges);
  ground.is_added.assign(ground.mesh.points.size(), 0);
  std::vector<PlanPoint> added;
  for (const auto& side : ground.sides) added.insert(added.end(), side.added.begin(), side.added.end());
  std::sort(added.begin(), added.end());
  for (std::size_t i = 0; i < ground.mesh.points.size(); ++i)
    ground.is_added[i] = std::binary_search(added.begin(), added.end(), ground.mesh.points[i]);
  return ground;
}

}  // namespace vicus
