#include "sectorgen/sectors/routes.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"
#include "sectorgen/sectors/locator.hpp"

namespace vicus {
namespace {

constexpr double kBridgedBlockM = 8;  // an axis may cut a corner of a house this far and go on behind it
constexpr std::size_t kDetourTriangles = 600;
constexpr std::int64_t kStubMm = 15'000;

/// A path in the dual graph with back-tracking cancelled as it grows.
struct ReducedPath {
  std::vector<std::uint32_t> triangles;
  void push(std::uint32_t t) {
    if (!triangles.empty() && triangles.back() == t) return;
    if (triangles.size() >= 2 && triangles[triangles.size() - 2] == t)
      triangles.pop_back();
    else
      triangles.push_back(t);
  }
};

class Router {
 public:
  Router(const Ground& ground, StreetRoutes& routes)
      : ground_(ground),
        routes_(routes),
        locator_(ground.mesh),
        seen_(ground.mesh.triangles.size(), 0),
        is_taken_(seen_.size(), 0) {}

  /// `below`: the axes it passes over, added before.
  void add(const Axis& axis, std::uint32_t name, const std::vector<std::uint32_t>& below) {
    for (std::uint32_t lower : below) set_taken(lower, 1);
    ReducedPath path;
    std::uint32_t here = kNone;
    for (std::size_t i = 0; i + 1 < axis.line.size(); ++i) {
      walk(path, axis.line[i], axis.line[i + 1], name, here);
    }
    finish(path);
    for (std::uint32_t lower : below) set_taken(lower, 0);
  }

  /// Axes whose triangles must be known when those above them are added.
  void remember(std::uint32_t axis) { recorded_ = &triangles_of_[axis]; }
  void forget() { recorded_ = nullptr; }

 private:
  /// One straight piece; `here` is the triangle it starts from, then the one it ends in.
  void walk(ReducedPath& path, PlanPoint p, PlanPoint q, std::uint32_t name, std::uint32_t& here) {
    here = locator_.locate(towards(p, q), here);
    PlanPoint at = p;
    // From beyond the mesh's hull, where nothing of the city is: begin at the first point inside.
    const std::int64_t steps_in = here == kNone ? length_mm(p, q) / kReachMm : 0;
    for (std::int64_t i = 1; here == kNone && i <= steps_in; ++i) {
      at = {static_cast<std::int32_t>(p.x + (std::int64_t{q.x} - p.x) * i / steps_in),
            static_cast<std::int32_t>(p.y + (std::int64_t{q.y} - p.y) * i / steps_in)};
      here = locator_.locate(at);
    }
    for (std::size_t steps = 0; here != kNone && steps < ground_.mesh.triangles.size(); ++steps) {
      const auto exit = exit_of(here, p, q);
      const PlanPoint end = exit ? meeting(here, *exit, p, q) : q;
      if (ground_.is_free[here] && is_taken_[here]) {
        finish(path);
      } else if (ground_.is_free[here]) {
        enter(path, here, at);
        if (name != kNone) routes_.uses.push_back({here, name, length_mm(at, end)});
        left_at_ = end;
      }
      if (!exit) return;
      at = end;
      here = ground_.beyond(here, *exit);
    }
    finish(path);
  }

  /// A point 2 mm along pq: decides on which side of a vertex the walk starts.
  static PlanPoint towards(PlanPoint p, PlanPoint q) {
    const double length = std::sqrt(static_cast<double>(distance2(p, q)));
    const double t = std::min(1.0, 2 / length);
    return {static_cast<std::int32_t>(std::lround(p.x + t * (double(q.x) - p.x))),
            static_cast<std::int32_t>(std::lround(p.y + t * (double(q.y) - p.y)))};
  }

  /// The edge through which pq leaves t; none when q lies in t.
  std::optional<int> exit_of(std::uint32_t t, PlanPoint p, PlanPoint q) const {
    std::optional<int> fallback;
    for (int k = 0; k < 3; ++k) {
      const PlanPoint u = ground_.from(t, k), v = ground_.to(t, k);
      if (orient(u, v, q) >= 0) continue;
      if (orient(p, q, u) <= 0 && orient(p, q, v) > 0) return k;
      fallback = k;
    }
    return fallback;  // p was rounded off the line: still a step towards q
  }

  PlanPoint meeting(std::uint32_t t, int k, PlanPoint p, PlanPoint q) const {
    const PlanPoint u = ground_.from(t, k), v = ground_.to(t, k);
    const auto a = static_cast<double>(orient(u, v, p)), b = static_cast<double>(orient(u, v, q));
    const double s = a <= 0 ? 0 : a / (a - b);
    return {static_cast<std::int32_t>(std::lround(p.x + s * (double(q.x) - p.x))),
            static_cast<std::int32_t>(std::lround(p.y + s * (double(q.y) - p.y)))};
  }

  void enter(ReducedPath& path, std::uint32_t t, PlanPoint entered_at) {
    if (path.triangles.empty() || path.triangles.back() == t) return path.push(t);
    if (is_neighbour(path.triangles.back(), t)) return path.push(t);
    // Cut a corner of an obstacle: go round it if the detour is near, else the axis falls in two.
    if (metres(length_mm(left_at_, entered_at)) <= kBridgedBlockM) {
      const auto way = detour(path.triangles.back(), t);
      if (!way.empty()) {
        for (std::uint32_t step : way) path.push(step);
        return;
      }
    }
    finish(path);
    path.push(t);
  }

  bool is_neighbour(std::uint32_t a, std::uint32_t b) const {
    for (int k = 0; k < 3; ++k)
      if (ground_.beyond(a, k) == b) return ground_.is_crossable(a, k);
    return false;
  }

  /// Shortest way in free triangles, breadth first, within kDetourTriangles; empty when there is none.
  std::vector<std::uint32_t> detour(std::uint32_t from, std::uint32_t to) {
    ++stamp_;
    std::vector<std::pair<std::uint32_t, std::size_t>> queue{{from, 0}};
    seen_[from] = stamp_;
    for (std::size_t i = 0; i < queue.size() && queue.size() < kDetourTriangles; ++i) {
      const std::uint32_t t = queue[i].first;
      for (int k = 0; k < 3; ++k) {
        if (!ground_.is_crossable(t, k)) continue;
        const std::uint32_t n = ground_.beyond(t, k);
        if (seen_[n] == stamp_) continue;
        seen_[n] = stamp_;
        queue.push_back({n, i});
        if (n != to) continue;
        std::vector<std::uint32_t> way;
        for (std::size_t j = queue.size() - 1; j != 0; j = queue[j].second) way.push_back(queue[j].first);
        std::reverse(way.begin(), way.end());
        return way;
      }
    }
    return {};
  }

  void finish(ReducedPath& path) {
    for (std::size_t i = 0; i + 1 < path.triangles.size(); ++i) {
      const std::uint32_t t = path.triangles[i];
      routes_.is_used[ground_.edge_id(t, ground_.mesh.side_towards(t, path.triangles[i + 1]))] = 1;
    }
    for (std::uint32_t t : path.triangles) routes_.is_reached[t] = 1;
    if (recorded_ != nullptr) recorded_->insert(recorded_->end(), path.triangles.begin(), path.triangles.end());
    path.triangles.clear();
  }

  void set_taken(std::uint32_t axis, char value) {
    const auto it = triangles_of_.find(axis);
    if (it == triangles_of_.end()) return;
    for (std::uint32_t t : it->second) is_taken_[t] = value;
  }

  const Ground& ground_;
  StreetRoutes& routes_;
  Locator locator_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t stamp_ = 0;
  PlanPoint left_at_;           ///< where the axis left free ground last
  std::vector<char> is_taken_;  ///< per triangle: below the axis that is being added
  std::map<std::uint32_t, std::vector<std::uint32_t>> triangles_of_;
  std::vector<std::uint32_t>* recorded_ = nullptr;
};

/// For each axis the lower ones it crosses without a common point.
std::map<std::uint32_t, std::vector<std::uint32_t>> passes_over(const std::vector<Axis>& axes) {
  std::vector<PlanBox> boxes;
  for (const Axis& axis : axes) {
    boxes.emplace_back();
    for (PlanPoint p : axis.line) boxes.back().add(p);
  }
  const BoxIndex index(boxes);
  const auto cross = [](const Axis& a, const Axis& b) {
    for (std::size_t i = 0; i + 1 < a.line.size(); ++i)
      for (std::size_t j = 0; j + 1 < b.line.size(); ++j)
        if (cross_properly(a.line[i], a.line[i + 1], b.line[j], b.line[j + 1])) return true;
    return false;
  };
  std::map<std::uint32_t, std::vector<std::uint32_t>> over;
  for (std::uint32_t i = 0; i < axes.size(); ++i) {
    if (axes[i].level <= 0) continue;
    for (std::uint32_t j : index.meeting(boxes[i]))
      if (axes[j].level < axes[i].level && cross(axes[i], axes[j])) over[i].push_back(j);
  }
  return over;
}

/// A dead end of used edges: from its leaf to the junction it hangs on.
struct Stub {
  std::int64_t length = 0;
  PlanPoint key;  // breaks ties
  std::vector<std::uint32_t> edges;
  std::uint32_t junction = 0;
};

std::optional<Stub> stub_from(const Ground& g, const StreetRoutes& r, std::uint32_t leaf) {
  Stub stub;
  std::uint32_t t = leaf;
  int entry = -1;
  std::int64_t mouth = 0;
  while (true) {
    int exit = -1;
    for (int k = 0; k < 3; ++k)
      if (k != entry && r.is_used[g.edge_id(t, k)]) exit = k;
    if (exit < 0) return std::nullopt;  // a path with two leaves is a street
    if (entry >= 0) stub.length += midpoint_distance_mm(g, t, entry, exit);
    stub.edges.push_back(g.edge_id(t, exit));
    mouth = length_mm(g.from(t, exit), g.to(t, exit));
    stub.key = std::min(g.from(t, exit), g.to(t, exit));
    const std::uint32_t n = g.beyond(t, exit);
    entry = g.mesh.twin_side(t, exit);
    t = n;
    const int count = used_count(g, r, t);
    if (count == 3) break;
    if (count == 1) return std::nullopt;
  }
  stub.junction = t;
  if (stub.length >= std::max(kStubMm, mouth)) return std::nullopt;
  return stub;
}

/// Driveway stubs and axis ends in niches go, the shortest first.
void prune(const Ground& g, StreetRoutes& r) {
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t)
    if (used_count(g, r, t) == 1) leaves.push_back(t);
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<Stub> stubs;
    for (std::uint32_t leaf : leaves)
      if (used_count(g, r, leaf) == 1)
        if (auto stub = stub_from(g, r, leaf)) stubs.push_back(std::move(*stub));
    std::sort(stubs.begin(), stubs.end(),
              [](const Stub& a, const Stub& b) { return a.length != b.length ? a.length < b.length : a.key < b.key; });
    for (const Stub& stub : stubs) {
      if (used_count(g, r, stub.junction) < 3) continue;  // its sibling went already
      for (std::uint32_t e : stub.edges) r.is_used[e] = 0;
      changed = true;
    }
  }
}

/// Spreads is_reached over the components of the ground.
void spread_reached(const Ground& g, StreetRoutes& r) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < r.is_reached.size(); ++t)
    if (r.is_reached[t]) queue.push_back(t);
  while (!queue.empty()) {
    const std::uint32_t t = queue.back();
    queue.pop_back();
    for (int k = 0; k < 3; ++k) {
      if (!g.is_crossable(t, k) || r.is_reached[g.beyond(t, k)]) continue;
      r.is_reached[g.beyond(t, k)] = 1;
      queue.push_back(g.beyond(t, k));
    }
  }
}

/// No axis anywhere: every wide edge of ground that reaches the city's edge is taken as used.
void invent_routes(const Ground& g, StreetRoutes& r) {
  for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t) {
    if (!g.is_free[t]) continue;
    for (int k = 0; k < 3; ++k)
      if (g.is_city_edge(t, k)) r.is_reached[t] = 1;
  }
  spread_reached(g, r);
  for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (r.is_reached[t] && g.is_crossable(t, k) && length_mm(g.from(t, k), g.to(t, k)) >= kWideMm)
        r.is_used[g.edge_id(t, k)] = 1;
}

}  // namespace

int used_count(const Ground& g, const StreetRoutes& r, std::uint32_t t) {
  if (!g.is_free[t]) return 0;
  int n = 0;
  for (int k = 0; k < 3; ++k) n += r.is_used[g.edge_id(t, k)];
  return n;
}

std::int64_t midpoint_distance_mm(const Ground& g, std::uint32_t t, int k, int m) {
  const PlanPoint a = g.from(t, k), b = g.to(t, k), c = g.from(t, m), d = g.to(t, m);
  const std::int64_t dx = std::int64_t{a.x} + b.x - c.x - d.x, dy = std::int64_t{a.y} + b.y - c.y - d.y;
  return integer_sqrt((dx * dx + dy * dy) / 4);
}

std::vector<PlanPoint> reach_points(const std::vector<Axis>& axes, const std::vector<Area>& areas) {
  std::vector<PlanPoint> out;
  const auto add = [&](PlanPoint a, PlanPoint b) {
    const std::int64_t n = length_mm(a, b) / kReachMm + 1;
    for (std::int64_t i = 0; i < n; ++i)
      out.push_back({static_cast<std::int32_t>(a.x + (std::int64_t{b.x} - a.x) * i / n),
                     static_cast<std::int32_t>(a.y + (std::int64_t{b.y} - a.y) * i / n)});
  };
  for (const Axis& axis : axes) {
    for (std::size_t i = 0; i + 1 < axis.line.size(); ++i) add(axis.line[i], axis.line[i + 1]);
    out.push_back(axis.line.back());
  }
  if (axes.empty()) return {};  // the network is invented from all ground
  for (const Area& area : areas)
    if (area.kind == AreaKind::square)
      for (std::size_t i = 0; i < area.area.outer.size(); ++i)
        add(area.area.outer[i], area.area.outer[(i + 1) % area.area.outer.size()]);
  return out;
}

StreetRoutes route_axes(const Ground& g, const std::vector<Axis>& axes, const std::vector<Area>& areas) {
  StreetRoutes r;
  r.is_used.assign(g.edge_ids(), 0);
  r.is_reached.assign(g.mesh.triangles.size(), 0);
  for (const Axis& axis : axes)
    if (!axis.name.empty()) r.names.push_back(axis.name);
  std::sort(r.names.begin(), r.names.end());
  r.names.erase(std::unique(r.names.begin(), r.names.end()), r.names.end());
  {
    Router router(g, r);
    const auto over = passes_over(axes);
    std::set<std::uint32_t> lower;
    for (const auto& [i, below] : over) lower.insert(below.begin(), below.end());
    std::vector<std::uint32_t> order(axes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return axes[a].level < axes[b].level; });
    for (std::uint32_t i : order) {
      const Axis& axis = axes[i];
      const auto it = std::lower_bound(r.names.begin(), r.names.end(), axis.name);
      const auto below = over.find(i);
      if (lower.count(i) != 0) router.remember(i);
      router.add(axis, axis.name.empty() ? kNone : static_cast<std::uint32_t>(it - r.names.begin()),
                 below == over.end() ? std::vector<std::uint32_t>{} : below->second);
      router.forget();
    }
    const Locator locator(g.mesh);
    for (const Area& area : areas) {
      if (area.kind != AreaKind::square) continue;
      for (PlanPoint p : area.area.outer) {
        const std::uint32_t t = locator.locate(p);
        if (t != kNone && g.is_free[t]) r.is_reached[t] = 1;
      }
    }
  }
  if (axes.empty()) invent_routes(g, r);
  spread_reached(g, r);
  prune(g, r);
  return r;
}

}  // namespace vicus
