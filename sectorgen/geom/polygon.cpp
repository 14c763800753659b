#include "sectorgen/geom/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "sectorgen/geom/triangulation.hpp"

namespace vicus {

Int128 area2(const Ring& ring) {
  Int128 sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    sum += Int128{a.x} * b.y - Int128{b.x} * a.y;
  }
  return sum;
}

Int128 area2(const Polygon& polygon) {
  Int128 sum = area2(polygon.outer);
  for (const auto& hole : polygon.holes) sum += area2(hole);
  return sum;
}

double area_m2(const Polygon& polygon) { return static_cast<double>(area2(polygon)) / 2 / kMmPerMetre / kMmPerMetre; }

Side locate(const Polygon& polygon, PlanPoint p) {
  bool inside = false;
  const auto scan = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const PlanPoint a = ring[j], b = ring[i];
      if (on_segment(a, b, p)) return true;
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if ((orient(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
    }
    return false;
  };
  if (scan(polygon.outer)) return Side::boundary;
  for (const auto& hole : polygon.holes)
    if (scan(hole)) return Side::boundary;
  return inside ? Side::inside : Side::outside;
}

double inside_length_m(PlanPoint a, PlanPoint b, const Polygon& polygon, PlanPoint& middle) {
  std::vector<double> cuts = {0, 1};
  const auto cut_at_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint c = ring[i], d = ring[i + 1 == ring.size() ? 0 : i + 1];
      const std::int64_t side_c = orient(a, b, c), side_d = orient(a, b, d);
      if ((side_c > 0) == (side_d > 0) && side_c != 0 && side_d != 0) continue;
      const double from = static_cast<double>(orient(c, d, a)), to = static_cast<double>(orient(c, d, b));
      if (from != to) cuts.push_back(std::clamp(from / (from - to), 0.0, 1.0));
    }
  };
  cut_at_ring(polygon.outer);
  for (const Ring& hole : polygon.holes) cut_at_ring(hole);
  std::sort(cuts.begin(), cuts.end());
  const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
  double inside = 0, longest = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double t = (cuts[i - 1] + cuts[i]) / 2, piece = cuts[i] - cuts[i - 1];
    const PlanPoint at{static_cast<std::int32_t>(std::llround(a.x + t * dx)),
                       static_cast<std::int32_t>(std::llround(a.y + t * dy))};
    if (piece <= 0 || locate(polygon, at) != Side::inside) continue;
    inside += piece;
    if (piece > longest) {
      longest = piece;
      middle = at;
    }
  }
  return inside * std::hypot(dx, dy) / kMmPerMetre;
}

double perimeter_m(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += std::hypot(static_cast<double>(b.x) - a.x, static_cast<double>(b.y) - a.y);
  }
  return sum / kMmPerMetre;
}

Ring convex_hull(std::vector<PlanPoint> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring hull(2 * points.size());
  std::size_t n = 0;
  const auto push = [&](PlanPoint p, std::size_t base) {
    while (n >= base + 2 && orient(hull[n - 2], hull[n - 1], p) <= 0) --n;
    hull[n++] = p;
  };
  for (PlanPoint p : points) push(p, 0);
  const std::size_t base = n - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) push(points[i], base);
  hull.resize(n - 1);
  return hull;
}

double diameter_m(const Ring& hull) {
  std::int64_t best = 0;
  const std::size_t n = hull.size();
  if (n < 2) return 0;
  if (n == 2) return std::sqrt(static_cast<double>(distance2(hull[0], hull[1]))) / kMmPerMetre;
  for (std::size_t i = 0, j = 1; i < n; ++i) {  // rotating calipers
    const PlanPoint a = hull[i], b = hull[(i + 1) % n];
    while (orient(a, b, hull[(j + 1) % n]) > orient(a, b, hull[j])) j = (j + 1) % n;
    best = std::max({best, distance2(a, hull[j]), distance2(b, hull[j]), distance2(a, hull[(j + 1) % n])});
  }
  return std::sqrt(static_cast<double>(best)) / kMmPerMetre;
}

namespace {

/// Drops repeated points and spikes (a-b-a); empty when nothing is left.
Ring without_spikes(const Ring& walk) {
  Ring ring;
  for (PlanPoint p : walk) {
    while (!ring.empty() && ring.back() == p) ring.pop_back();
    if (ring.size() >= 2 && ring[ring.size() - 2] == p)
      ring.pop_back();
    else
      ring.push_back(p);
  }
  std::size_t begin = 0;
  while (ring.size() - begin >= 3) {
    if (ring[begin] == ring.back()) {
      ring.pop_back();
    } else if (ring[begin + 1] == ring.back()) {
      ++begin;
      ring.pop_back();
    } else if (ring[begin] == ring[ring.size() - 2]) {
      ring.pop_back();
      ring.pop_back();
    } else {
      break;
    }
  }
  ring.erase(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(begin));
  if (ring.size() < 3) ring.clear();
  return ring;
}

}  // namespace

std::vector<Ring> simple_rings(const Ring& walk) {
  std::vector<Ring> rings;
  Ring stack;
  std::map<PlanPoint, std::size_t> at;  // position on the stack
  const Ring clean = without_spikes(walk);
  for (std::size_t k = 0; k <= clean.size() && !clean.empty(); ++k) {
    const PlanPoint p = clean[k % clean.size()];
    const auto seen = at.find(p);
    if (seen != at.end()) {
      const std::size_t from = seen->second;  // the erasing below ends `seen`
      Ring loop(stack.begin() + static_cast<std::ptrdiff_t>(from), stack.end());
      for (PlanPoint q : loop) at.erase(q);
      stack.resize(from);
      loop = without_spikes(loop);
      if (loop.size() >= 3 && area2(loop) != 0) rings.push_back(std::move(loop));
    }
    at[p] = stack.size();
    stack.push_back(p);
  }
  return rings;
}

std::vector<Ring> simple_rings(const std::vector<Ring>& walks) {
  std::map<std::pair<PlanPoint, PlanPoint>, int> edges;  // how often walked from the first to the second
  bool is_cancelled = false;
  for (const Ring& walk : walks)
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const PlanPoint a = walk[i], b = walk[i + 1 == walk.size() ? 0 : i + 1];
      const auto back = edges.find({b, a});
      if (back == edges.end() || back->second == 0) {
        ++edges[{a, b}];
        continue;
      }
      --back->second;
      is_cancelled = true;
    }
  std::vector<Ring> rings;
  const auto take_apart = [&](const Ring& walk) {
    for (auto& ring : simple_rings(walk)) rings.push_back(std::move(ring));
  };
  if (walks.size() < 2 || !is_cancelled) {
    for (const Ring& walk : walks) take_apart(walk);
    return rings;
  }
  // What is left closes: at each point as many edges begin as end.
  std::map<PlanPoint, std::vector<PlanPoint>> next;
  for (const auto& [edge, count] : edges)
    next[edge.first].insert(next[edge.first].end(), static_cast<std::size_t>(count), edge.second);
  for (auto& [begin, ways] : next)
    while (!ways.empty()) {
      Ring walk;
      for (PlanPoint at = begin; !next[at].empty();) {
        walk.push_back(at);
        const PlanPoint to = next[at].back();
        next[at].pop_back();
        at = to;
      }
      take_apart(walk);
    }
  return rings;
}

void canonicalise(Ring& ring) { std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end()); }

std::vector<Polygon> assemble(std::vector<Ring> rings) {
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (auto& ring : rings) {
    canonicalise(ring);
    if (area2(ring) > 0)
      polygons.push_back({std::move(ring), {}});
    else
      holes.push_back(std::move(ring));
  }
  std::sort(polygons.begin(), polygons.end(), [](const auto& a, const auto& b) { return a.outer < b.outer; });
  std::sort(holes.begin(), holes.end());
  for (auto& hole : holes) {
    Polygon* best = nullptr;
    for (auto& polygon : polygons) {
      const Polygon shell{polygon.outer, {}};
      Side side = Side::boundary;
      for (PlanPoint p : hole)
        if ((side = locate(shell, p)) != Side::boundary) break;
      if (side == Side::outside) continue;
      if (side == Side::boundary && area2(polygon.outer) < -area2(hole)) continue;
      if (best == nullptr || area2(polygon.outer) < area2(best->outer)) best = &polygon;
    }
    if (best != nullptr) best->holes.push_back(std::move(hole));
  }
  return polygons;
}

Triangles triangulate(const Polygon& polygon) {
  std::vector<PlanPoint> points = polygon.outer;
  std::vector<Edge> edges;
  std::uint32_t begin = 0;
  const auto add = [&](const Ring& ring) {
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) edges.push_back({begin + i, begin + (i + 1 == n ? 0 : i + 1)});
    begin += n;
  };
  add(polygon.outer);
  for (const auto& hole : polygon.holes) {
    points.insert(points.end(), hole.begin(), hole.end());
    add(hole);
  }
  if (points.size() == 3) return {0, 1, 2};
  // Rings may touch in points: the mesh has each point once, so look up every copy's first index.
  std::map<PlanPoint, std::uint32_t> first;
  for (std::uint32_t i = 0; i < points.size(); ++i) first.emplace(points[i], i);
  Mesh mesh = triangulate_edges(points, edges);
  // The inside is left of each ring edge; flood from there.
  std::map<std::pair<PlanPoint, PlanPoint>, bool> ring_edge;
  for (const Edge& e : edges) ring_edge[{points[e.a], points[e.b]}] = true;
  std::vector<char> inside(mesh.triangles.size(), 0);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3 && !inside[t]; ++k)
      if (ring_edge.count({mesh.points[mesh.corner(t, k + 1)], mesh.points[mesh.corner(t, k + 2)]}) != 0) {
        inside[t] = 1;
        queue.push_back(t);
      }
  while (!queue.empty()) {
    const std::uint32_t t = queue.back();
    queue.pop_back();
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = mesh.triangles[t].neighbour[k];
      if (n == kNone || mesh.triangles[t].edge[k] != kNone || inside[n]) continue;
      inside[n] = 1;
      queue.push_back(n);
    }
  }
  Triangles out;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (inside[t])
      for (int k = 0; k < 3; ++k) out.push_back(first.at(mesh.points[mesh.corner(t, k)]));
  return out;
}

}  // namespace vicus
