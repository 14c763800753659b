#include "sectorgen/sectors/corridors.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/locator.hpp"

namespace vicus {
namespace {

constexpr std::int64_t kPerMille = 1000;
constexpr std::int64_t kAddedPenalty =
    20;  // per mille for each T-vertex: of like cuts the one at corners or party walls
constexpr std::int64_t kDistancePenalty = 250;  // per mille per width away from the junction
constexpr std::int64_t kMouthReach = 60'000;    // mm
constexpr std::int64_t kNarrowStreet = 6'000;   // mm: narrower ones count as this wide
constexpr std::int64_t kMouthsApart = 8'000;    // mm
constexpr std::int64_t kJunctionSpan = 70'000, kJunctionSpanMax = 150'000;  // mm

struct EdgeRef {
  std::uint32_t triangle;
  int side;
};

std::int64_t chord_cost(const Ground& g, std::uint32_t t, int k, bool across_island) {
  if (across_island) return kNever;
  const std::int64_t length = length_mm(g.from(t, k), g.to(t, k));
  const int added = g.is_added[g.mesh.corner(t, k + 1)] + g.is_added[g.mesh.corner(t, k + 2)];
  return length * (kPerMille + kAddedPenalty * added) / kPerMille;
}

/// Follows used edges from triangle t through side k until a triangle that has not exactly two.
Corridor follow(const Ground& g, const StreetRoutes& r, std::uint32_t t, int k,
                const std::vector<std::uint32_t>& across, std::vector<char>& visited) {
  Corridor c;
  c.triangles.push_back(t);
  const std::uint32_t start = t;
  int exit = k, entry = -1;
  while (true) {
    const std::uint32_t id = g.edge_id(t, exit);
    if (visited[id]) break;  // a loop closed
    visited[id] = 1;
    if (c.chords.empty())
      c.along_mm.push_back(0);
    else
      c.along_mm.push_back(c.along_mm.back() + midpoint_distance_mm(g, t, entry, exit));
    c.chords.push_back(id);
    c.width_mm.push_back(length_mm(g.from(t, exit), g.to(t, exit)));
    c.cost_mm.push_back(chord_cost(g, t, exit, across[id] != kNone));
    const std::uint32_t n = g.beyond(t, exit);
    entry = g.mesh.twin_side(t, exit);
    t = n;
    c.triangles.push_back(t);
    if (used_count(g, r, t) != 2 || t == start) break;
    for (int j = 0; j < 3; ++j)
      if (j != entry && r.is_used[g.edge_id(t, j)]) exit = j;
  }
  c.has_junction[0] = used_count(g, r, start) == 3;
  c.has_junction[1] = used_count(g, r, t) == 3;
  return c;
}

/// Extent in eight directions: the diameter of a growing cluster to within 8 %.
struct Extent {
  std::array<std::int64_t, 8> low{}, high{};
  bool any = false;
  void add(PlanPoint p) {
    constexpr std::int64_t dx[8] = {1000, 924, 707, 383, 0, -383, -707, -924},
                           dy[8] = {0, 383, 707, 924, 1000, 924, 707, 383};
    for (std::size_t i = 0; i < 8; ++i) {
      const std::int64_t v = (dx[i] * p.x + dy[i] * p.y) / 1000;
      low[i] = any ? std::min(low[i], v) : v;
      high[i] = any ? std::max(high[i], v) : v;
    }
    any = true;
  }
  void add(const Extent& o) {
    if (!o.any) return;
    for (std::size_t i = 0; i < 8; ++i) {
      low[i] = any ? std::min(low[i], o.low[i]) : o.low[i];
      high[i] = any ? std::max(high[i], o.high[i]) : o.high[i];
    }
    any = true;
  }
  std::int64_t span() const {
    std::int64_t s = 0;
    for (std::size_t i = 0; i < 8; ++i) s = std::max(s, high[i] - low[i]);
    return s;
  }
};

/// Junction triangles united into crossroads and squares: "shorter than wide" corridors are inside one.
class Clusters {
 public:
  Clusters(const Ground& g, const std::vector<Corridor>& corridors) : ground_(g) {
    for (const auto& c : corridors)
      for (int end = 0; end < 2; ++end)
        if (c.has_junction[end]) add(end == 0 ? c.triangles.front() : c.triangles.back(), widest_end(c));
  }
  std::uint32_t find(std::uint32_t t) {
    std::uint32_t i = index_.at(t);
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool try_unite(const Corridor& c) {
    const std::uint32_t a = find(c.triangles.front()), b = find(c.triangles.back());
    if (a == b) return true;
    Extent both = extent_[a];
    both.add(extent_[b]);
    const std::int64_t widest = std::max(widest_[a], widest_[b]);
    if (both.span() > std::min(kJunctionSpanMax, std::max(kJunctionSpan, widest * 8 / 5))) return false;
    for (std::uint32_t t : c.triangles)
      for (int k = 0; k < 3; ++k) both.add(ground_.mesh.points[ground_.mesh.corner(t, k)]);
    parent_[b] = a;
    extent_[a] = both;
    widest_[a] = widest;
    return true;
  }

 private:
  static std::int64_t widest_end(const Corridor& c) { return c.narrowest(); }
  void add(std::uint32_t t, std::int64_t width) {
    const auto [it, is_new] = index_.emplace(t, static_cast<std::uint32_t>(parent_.size()));
    if (is_new) {
      parent_.push_back(it->second);
      extent_.emplace_back();
      widest_.push_back(0);
      for (int k = 0; k < 3; ++k) extent_.back().add(ground_.mesh.points[ground_.mesh.corner(t, k)]);
    }
    widest_[it->second] = std::max(widest_[it->second], width);
  }

  const Ground& ground_;
  std::map<std::uint32_t, std::uint32_t> index_;
  std::vector<std::uint32_t> parent_;
  std::vector<Extent> extent_;
  std::vector<std::int64_t> widest_;
};

/// Smallest end point of the corridor's chords' edges: a key that does not depend on numbering.
PlanPoint key_of(const Ground& g, const Corridor& c) {
  PlanPoint key{kPlanLimit, kPlanLimit};
  for (std::uint32_t id : {c.chords.front(), c.chords.back()})
    key = std::min({key, g.from(id / 3, static_cast<int>(id % 3)), g.to(id / 3, static_cast<int>(id % 3))});
  return key;
}

std::vector<char> contract(const Ground& g, const std::vector<Corridor>& corridors, Clusters& clusters) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < corridors.size(); ++i)
    if (corridors[i].has_junction[0] && corridors[i].has_junction[1]) order.push_back(i);
  const auto ratio = [&](std::uint32_t i) {
    return corridors[i].length() * 1000 / std::max<std::int64_t>(1, corridors[i].narrowest());
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto ra = ratio(a), rb = ratio(b);
    return ra != rb ? ra < rb : key_of(g, corridors[a]) < key_of(g, corridors[b]);
  });
  std::vector<char> contracted(corridors.size(), 0);
  for (std::uint32_t i : order) {
    if (ratio(i) >= 1000) break;
    contracted[i] = clusters.try_unite(corridors[i]);
  }
  return contracted;
}

/// The chord at one end where the street begins: least cost, rising with the distance from the junction.
std::size_t find_mouth(const Corridor& c, int end) {
  const std::int64_t reach = std::min(c.length() / 2, kMouthReach), width = std::max(kNarrowStreet, c.narrowest());
  std::size_t best = end == 0 ? 0 : c.chords.size() - 1;
  std::int64_t best_cost = -1;
  for (std::size_t j = 0; j < c.chords.size(); ++j) {
    const std::size_t i = end == 0 ? j : c.chords.size() - 1 - j;
    const std::int64_t d = end == 0 ? c.along_mm[i] : c.length() - c.along_mm[i];
    if (d > reach) break;
    if (c.cost_mm[i] >= kNever) continue;
    const std::int64_t cost = c.cost_mm[i] + c.cost_mm[i] * kDistancePenalty / kPerMille * d / width;
    if (best_cost < 0 || cost < best_cost) best = i, best_cost = cost;
  }
  return best;
}

/// Chords that cut the stretch first..last into pieces of about piece_mm.
void cut_long(const Corridor& c, std::size_t first, std::size_t last, std::int64_t piece_mm,
              std::vector<std::size_t>& out) {
  const std::int64_t from = c.along_mm[first], length = c.along_mm[last] - from;
  const std::int64_t n = (length + piece_mm - 1) / piece_mm;
  if (n < 2) return;
  const std::int64_t window = std::max<std::int64_t>(1, length / n / 4);
  for (std::int64_t j = 1; j < n; ++j) {
    const std::int64_t target = from + length * j / n;
    std::size_t best = c.chords.size();
    std::int64_t best_cost = -1;
    for (std::size_t i = first + 1; i < last; ++i) {
      const std::int64_t off = std::abs(c.along_mm[i] - target);
      if (off > 2 * window || c.cost_mm[i] >= kNever) continue;
      const std::int64_t cost = c.cost_mm[i] + c.cost_mm[i] * 300 / kPerMille * off / window;
      if (best_cost < 0 || cost < best_cost) best = i, best_cost = cost;
    }
    if (best < c.chords.size() && (out.empty() || best != out.back())) out.push_back(best);
  }
}

void cut_corridor(const Corridor& c, std::int64_t piece_mm, std::vector<char>& is_cut) {
  std::size_t first = 0, last = c.chords.size() - 1;
  const auto cut = [&](std::size_t i) {
    if (c.cost_mm[i] < kNever) is_cut[c.chords[i]] = 1;
  };
  if (c.has_junction[0]) first = find_mouth(c, 0);
  if (c.has_junction[1]) last = find_mouth(c, 1);
  if (c.has_junction[0] && c.has_junction[1]) {
    const std::int64_t apart = c.along_mm[std::max(first, last)] - c.along_mm[std::min(first, last)];
    if (apart < std::max(kMouthsApart, std::min(c.width_mm[first], c.width_mm[last]) / 2)) {
      cut(c.cost_mm[first] <= c.cost_mm[last] ? first : last);
      return;
    }
  }
  if (c.has_junction[0]) cut(first);
  if (c.has_junction[1]) cut(last);
  std::vector<std::size_t> cuts;
  if (first < last) cut_long(c, first, last, piece_mm, cuts);
  for (std::size_t i : cuts) cut(i);
}

}  // namespace

std::int64_t Corridor::narrowest() const {
  return width_mm.empty() ? 0 : *std::min_element(width_mm.begin(), width_mm.end());
}

std::vector<std::uint32_t> edges_across_islands(const Ground& g) {
  std::vector<std::uint32_t> out(g.edge_ids(), kNone);
  const Locator locator(g.mesh);
  std::vector<char> seen(g.mesh.triangles.size(), 0);
  for (std::uint32_t i = 0; i < g.islands.size(); ++i) {
    const Island& island = g.islands[i];
    const auto meets = [&](PlanPoint a, PlanPoint b) {
      const Ring& ring = island.area.outer;
      for (std::size_t j = 0; j < ring.size(); ++j) {
        const PlanPoint c = ring[j], d = ring[(j + 1) % ring.size()];
        if (cross_properly(a, b, c, d) || on_segment(a, b, c)) return true;
      }
      return false;
    };
    std::vector<std::uint32_t> queue{locator.locate(island.area.outer.front())};
    if (queue.front() == kNone) continue;
    seen[queue.front()] = 1;
    for (std::size_t j = 0; j < queue.size(); ++j)
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t t = queue[j], n = g.beyond(t, k);
        if (n == kNone || !meets(g.from(t, k), g.to(t, k))) continue;
        out[g.edge_id(t, k)] = i;
        if (!seen[n]) {
          seen[n] = 1;
          queue.push_back(n);
        }
      }
    for (std::uint32_t t : queue) seen[t] = 0;
  }
  return out;
}

std::vector<Corridor> find_corridors(const Ground& g, const StreetRoutes& r, const std::vector<std::uint32_t>& across) {
  std::vector<Corridor> out;
  std::vector<char> visited(g.edge_ids(), 0);
  const auto start = [&](std::uint32_t t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t id = g.edge_id(t, k);
      if (r.is_used[id] && !visited[id]) out.push_back(follow(g, r, t, k, across, visited));
    }
  };
  for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t) {
    const int n = used_count(g, r, t);
    if (n == 1 || n == 3) start(t);
  }
  for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t)
    if (used_count(g, r, t) == 2) start(t);  // what is left are loops
  return out;
}

Cuts choose_cuts(const Ground& g, const std::vector<Corridor>& corridors, const CutOptions& options) {
  Cuts cuts{std::vector<char>(g.edge_ids(), 0), std::vector<char>(g.mesh.triangles.size(), 0)};
  Clusters clusters(g, corridors);
  const std::vector<char> contracted = contract(g, corridors, clusters);
  for (std::size_t i = 0; i < corridors.size(); ++i) {
    const Corridor& c = corridors[i];
    if (c.has_junction[0]) cuts.in_junction[c.triangles.front()] = 1;
    if (c.has_junction[1]) cuts.in_junction[c.triangles.back()] = 1;
    if (!contracted[i]) cut_corridor(c, static_cast<std::int64_t>(options.piece_m * kMmPerMetre), cuts.is_cut);
  }
  return cuts;
}

}  // namespace vicus
