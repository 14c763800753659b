#include <algorithm>
#include <numeric>
#include <queue>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/cells.hpp"
#include "sectorgen/sectors/corridors.hpp"

namespace vicus {
namespace {

constexpr std::int64_t kDeepMm = 30'000;        // ground farther than this from any street is a yard of its own
constexpr double kNicheM2 = 40;                 // smaller ground behind a narrow gap joins the street
constexpr double kForecourtM2 = 400;            // smaller ground behind a kerb joins the street
constexpr double kPocketM2 = 150, kNeck = 0.5;  // a yard begins at a neck narrower than half its side
constexpr std::int64_t kRimMm = 8'000;          // a yard open to the city's edge this far is not part of the city

double area_m2(const Ground& g, std::uint32_t t) {
  const auto& c = g.mesh.triangles[t].corner;
  return static_cast<double>(orient(g.mesh.points[c[0]], g.mesh.points[c[1]], g.mesh.points[c[2]])) / 2e6;
}

/// Disjoint sets of triangles; a set may have a seed (its cell) and knows its area.
class Sets {
 public:
  explicit Sets(const Ground& g)
      : parent_(g.mesh.triangles.size()), seed_(parent_.size(), kNone), area_(parent_.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::uint32_t t = 0; t < parent_.size(); ++t) area_[t] = g.is_free[t] ? area_m2(g, t) : 0;
  }
  std::uint32_t find(std::uint32_t t) {
    while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
    return t;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    area_[a] += area_[b];
    if (seed_[a] == kNone) seed_[a] = seed_[b];
  }
  std::uint32_t& seed(std::uint32_t t) { return seed_[find(t)]; }
  double area(std::uint32_t t) { return area_[find(t)]; }

 private:
  std::vector<std::uint32_t> parent_, seed_;
  std::vector<double> area_;
};

/// Distance in the dual graph from the streets, in mm, along edge midpoints.
std::vector<std::int64_t> depth_mm(const Ground& g, const StreetRoutes& r) {
  constexpr std::int64_t kFar = std::int64_t{1} << 60;
  std::vector<std::int64_t> depth(g.mesh.triangles.size(), kFar);
  using Item = std::pair<std::int64_t, std::uint32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (std::uint32_t t = 0; t < depth.size(); ++t)
    if (used_count(g, r, t) > 0) {
      depth[t] = 0;
      queue.push({0, t});
    }
  const auto centre = [&](std::uint32_t t) {
    const auto& c = g.mesh.triangles[t].corner;
    const PlanPoint a = g.mesh.points[c[0]], b = g.mesh.points[c[1]], d = g.mesh.points[c[2]];
    return PlanPoint{static_cast<std::int32_t>((std::int64_t{a.x} + b.x + d.x) / 3),
                     static_cast<std::int32_t>((std::int64_t{a.y} + b.y + d.y) / 3)};
  };
  while (!queue.empty()) {
    const auto [d, t] = queue.top();
    queue.pop();
    if (d != depth[t]) continue;
    if (d > kDeepMm) continue;  // beyond, everything is deep
    for (int k = 0; k < 3; ++k) {
      if (!g.is_crossable(t, k)) continue;
      const std::uint32_t n = g.beyond(t, k);
      const std::int64_t through = d + length_mm(centre(t), centre(n));
      if (through >= depth[n]) continue;
      depth[n] = through;
      queue.push({through, n});
    }
  }
  return depth;
}

struct ForestEdge {
  std::int64_t width;  // effective: kNever across an island, 0 at a kerb
  PlanPoint a, b;
  std::uint32_t triangle, other;
  bool is_kerb;
  bool operator<(const ForestEdge& o) const {
    if (width != o.width) return width > o.width;
    return a != o.a ? a < o.a : b < o.b;
  }
};

/// Seeds: what the cut streets are, then deep ground.
void seed_sets(const Ground& g, const StreetRoutes& r, const Cuts& cuts, Sets& sets, std::vector<CellKind>& kind) {
  const auto n = static_cast<std::uint32_t>(g.mesh.triangles.size());
  for (std::uint32_t t = 0; t < n; ++t)
    for (int k = 0; k < 3; ++k) {
      if (!g.is_crossable(t, k) || g.beyond(t, k) < t) continue;
      const std::uint32_t id = g.edge_id(t, k);
      if (r.is_used[id] && !cuts.is_cut[id]) sets.unite(t, g.beyond(t, k));
    }
  for (std::uint32_t t = 0; t < n; ++t) {
    if (used_count(g, r, t) == 0) continue;
    if (sets.seed(t) == kNone) {
      sets.seed(t) = static_cast<std::uint32_t>(kind.size());
      kind.push_back(CellKind::street);
    }
    if (cuts.in_junction[t]) kind[sets.seed(t)] = CellKind::junction;
  }
  const std::vector<std::int64_t> depth = depth_mm(g, r);
  const auto is_deep = [&](std::uint32_t t) { return g.is_free[t] && r.is_reached[t] && depth[t] > kDeepMm; };
  for (std::uint32_t t = 0; t < n; ++t)
    for (int k = 0; is_deep(t) && k < 3; ++k)
      if (g.is_crossable(t, k) && is_deep(g.beyond(t, k))) sets.unite(t, g.beyond(t, k));
  for (std::uint32_t t = 0; t < n; ++t)
    if (is_deep(t) && sets.seed(t) == kNone) {
      sets.seed(t) = static_cast<std::uint32_t>(kind.size());
      kind.push_back(CellKind::yard);
    }
}

/// Maximum spanning forest: cells meet where the ground between them is narrowest.
void grow(const Ground& g, const StreetRoutes& r, const Cuts& cuts, const CutOptions& options,
          const std::vector<std::uint32_t>& across, Sets& sets, std::vector<CellKind>& kind) {
  std::vector<ForestEdge> edges;
  for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = g.beyond(t, k);
      if (!r.is_reached[t] || !g.is_crossable(t, k) || n < t) continue;
      const std::uint32_t id = g.edge_id(t, k);
      if (r.is_used[id] && cuts.is_cut[id]) continue;
      const bool is_kerb = g.mesh.triangles[t].edge[static_cast<std::size_t>(k)] != kNone;
      const PlanPoint u = g.from(t, k), v = g.to(t, k);
      edges.push_back({across[id] != kNone ? kNever
                       : is_kerb           ? 0
                                           : length_mm(u, v),
                       std::min(u, v), std::max(u, v), t, n, is_kerb});
    }
  std::sort(edges.begin(), edges.end());
  const auto narrow = static_cast<std::int64_t>(options.fence_m * kMmPerMetre);
  for (const auto& e : edges) {
    const std::uint32_t a = sets.seed(e.triangle), b = sets.seed(e.other);
    if (sets.find(e.triangle) == sets.find(e.other) || (a != kNone && b != kNone && a != b)) continue;
    if (e.width < narrow) {
      if (a == kNone && b == kNone) continue;
      const double behind = sets.area(a == kNone ? e.triangle : e.other);
      if (behind >= (e.is_kerb ? kForecourtM2 : kNicheM2)) continue;
    }
    // A pocket behind a neck is a yard of its own, however shallow.
    if ((a == kNone) != (b == kNone) && e.width < kNever) {
      const std::uint32_t pocket = a == kNone ? e.triangle : e.other;
      const double area = sets.area(pocket), neck = metres(e.width);
      if (area >= kPocketM2 && neck * neck < kNeck * kNeck * area) {
        sets.seed(pocket) = static_cast<std::uint32_t>(kind.size());
        kind.push_back(CellKind::yard);
        continue;
      }
    }
    sets.unite(e.triangle, e.other);
  }
  // Ground that only kerbs part from a street is open ground of its own.
  for (const auto& e : edges) {
    if (!e.is_kerb) continue;
    for (std::uint32_t t : {e.triangle, e.other})
      if (sets.seed(t) == kNone) {
        sets.seed(t) = static_cast<std::uint32_t>(kind.size());
        kind.push_back(CellKind::yard);
      }
  }
}

/// Components that an axis or square reaches but that have no seed yet become one yard each.
void seed_the_rest(const Ground& g, const StreetRoutes& r, Sets& sets, std::vector<CellKind>& kind) {
  std::vector<char> has_seed(g.mesh.triangles.size(), 0), done(g.mesh.triangles.size(), 0);
  for (std::uint32_t t = 0; t < done.size(); ++t) {
    if (done[t] || !g.is_free[t] || !r.is_reached[t]) continue;
    std::vector<std::uint32_t> component{t};
    done[t] = 1;
    bool seeded = false;
    for (std::size_t i = 0; i < component.size(); ++i) {
      seeded = seeded || sets.seed(component[i]) != kNone;
      for (int k = 0; k < 3; ++k) {
        if (!g.is_crossable(component[i], k) || done[g.beyond(component[i], k)]) continue;
        done[g.beyond(component[i], k)] = 1;
        component.push_back(g.beyond(component[i], k));
      }
    }
    if (seeded) continue;
    for (std::uint32_t m : component) sets.unite(t, m);
    sets.seed(t) = static_cast<std::uint32_t>(kind.size());
    kind.push_back(CellKind::street);
  }
}

/// Takes away the cells a walker cannot get to (only gaps narrower than fence_m lead there), and yards open to the
/// city's edge: those are no part of the city.
void close_off(const Ground& g, const StreetRoutes& r, const CutOptions& options, Cells& cells) {
  const std::size_t n = cells.kind.size();
  std::vector<std::vector<std::uint32_t>> open(n);
  std::vector<std::int64_t> rim(n, 0);
  const auto narrow = static_cast<std::int64_t>(options.fence_m * kMmPerMetre);
  for (std::uint32_t t = 0; t < cells.of.size(); ++t) {
    const std::uint32_t c = cells.of[t];
    if (c == kNone) continue;
    for (int k = 0; k < 3; ++k) {
      const std::int64_t length = length_mm(g.from(t, k), g.to(t, k));
      if (g.is_crossable(t, k)) {
        const std::uint32_t d = cells.of[g.beyond(t, k)];
        if (d != kNone && d != c && (length >= narrow || r.is_used[g.edge_id(t, k)])) open[c].push_back(d);
        continue;
      }
      if (g.is_city_edge(t, k)) rim[c] += length;
    }
  }
  std::vector<char> closed(n, 1);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t c = 0; c < n; ++c)
    if (cells.kind[c] != CellKind::yard) {
      closed[c] = 0;
      queue.push_back(c);
    }
  while (!queue.empty()) {
    const std::uint32_t c = queue.back();
    queue.pop_back();
    for (std::uint32_t d : open[c])
      if (closed[d] && rim[d] < kRimMm) {
        closed[d] = 0;
        queue.push_back(d);
      }
  }
  cells.closed.assign(cells.of.size(), Closed::no);
  for (std::uint32_t t = 0; t < cells.of.size(); ++t) {
    std::uint32_t& c = cells.of[t];
    if (!g.is_free[t]) continue;
    if (c == kNone)
      cells.closed[t] = r.is_reached[t] ? Closed::yard : Closed::courtyard;
    else if (closed[c])
      cells.closed[t] = rim[c] >= kRimMm ? Closed::outside : Closed::yard, c = kNone;
  }
  // Ground no street reaches: outside where it is open to the city's edge, else a courtyard.
  std::vector<std::uint32_t> spread;
  for (std::uint32_t t = 0; t < cells.of.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (cells.closed[t] == Closed::courtyard && g.is_city_edge(t, k)) {
        cells.closed[t] = Closed::outside;
        spread.push_back(t);
      }
  while (!spread.empty()) {
    const std::uint32_t t = spread.back();
    spread.pop_back();
    for (int k = 0; k < 3; ++k) {
      if (!g.is_crossable(t, k) || cells.closed[g.beyond(t, k)] != Closed::courtyard) continue;
      cells.closed[g.beyond(t, k)] = Closed::outside;
      spread.push_back(g.beyond(t, k));
    }
  }
}

}  // namespace

std::vector<PlanPoint> crossed_islands(const Ground& g, const Cells& cells) {
  const std::vector<std::uint32_t> across = edges_across_islands(g);
  std::vector<PlanPoint> out;
  for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (!g.is_crossable(t, k)) continue;
      const std::uint32_t island = across[g.edge_id(t, k)], n = g.beyond(t, k);
      if (island == kNone || (cells.of[t] == cells.of[n] && cells.closed[t] == cells.closed[n])) continue;
      out.push_back(g.islands[island].area.outer.front());
    }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

Cells cut_cells(const Ground& g, const StreetRoutes& r, const CutOptions& options) {
  const std::vector<std::uint32_t> across = edges_across_islands(g);
  const Cuts cuts = choose_cuts(g, find_corridors(g, r, across), options);
  Sets sets(g);
  Cells cells;
  seed_sets(g, r, cuts, sets, cells.kind);
  seed_the_rest(g, r, sets, cells.kind);
  grow(g, r, cuts, options, across, sets, cells.kind);
  if (options.join_across_islands)
    for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (r.is_reached[t] && g.is_crossable(t, k) && across[g.edge_id(t, k)] != kNone) sets.unite(t, g.beyond(t, k));
  cells.of.assign(g.mesh.triangles.size(), kNone);
  for (std::uint32_t t = 0; t < cells.of.size(); ++t)
    if (g.is_free[t] && r.is_reached[t]) cells.of[t] = sets.seed(t);
  close_off(g, r, options, cells);
  return cells;
}

}  // namespace vicus
