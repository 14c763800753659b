#include "sectorgen/geo/ring_check.hpp"

#include <algorithm>
#include <cmath>

namespace vicus {

namespace {

struct Edge {
  PlanPoint a, b;
  std::size_t ring, index, next;  // `next` is the index of the edge that follows in its ring
  std::int32_t min_x, max_x, min_y, max_y;
};

bool is_on_segment(PlanPoint p, const Edge& e) {
  return p.x >= e.min_x && p.x <= e.max_x && p.y >= e.min_y && p.y <= e.max_y && orient(e.a, e.b, p) == 0;
}

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

bool have_common_point(const Edge& e, const Edge& f) {
  const int fa = sign(orient(e.a, e.b, f.a)), fb = sign(orient(e.a, e.b, f.b));
  const int ea = sign(orient(f.a, f.b, e.a)), eb = sign(orient(f.a, f.b, e.b));
  if (fa * fb < 0 && ea * eb < 0) return true;
  return is_on_segment(f.a, e) || is_on_segment(f.b, e) || is_on_segment(e.a, f) || is_on_segment(e.b, f);
}

/// `f` follows `e` in their ring: only the common point is allowed.
bool fold_back(const Edge& e, const Edge& f) { return is_on_segment(f.b, e) || is_on_segment(e.a, f); }

bool is_clash(const Edge& e, const Edge& f) {
  if (e.min_y > f.max_y || f.min_y > e.max_y) return false;
  if (e.ring == f.ring) {
    if (e.next == f.index) return fold_back(e, f);
    if (f.next == e.index) return fold_back(f, e);
  }
  return have_common_point(e, f);
}

void append_edges(const Ring& ring, std::size_t ring_index, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    edges.push_back({a, b, ring_index, i, (i + 1) % ring.size(), std::min(a.x, b.x), std::max(a.x, b.x),
                     std::min(a.y, b.y), std::max(a.y, b.y)});
  }
}

bool has_clash(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.min_x < f.min_x; });
  std::vector<const Edge*> active;
  for (const Edge& edge : edges) {
    std::size_t kept = 0;
    for (const Edge* other : active) {
      if (other->max_x < edge.min_x) continue;
      if (is_clash(*other, edge)) return true;
      active[kept++] = other;
    }
    active.resize(kept);
    active.push_back(&edge);
  }
  return false;
}

}  // namespace

Ring without_repeats(const Ring& ring) {
  Ring kept;
  kept.reserve(ring.size());
  for (PlanPoint p : ring)
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

void orient_rings(Polygon& polygon) {
  if (area2(polygon.outer) < 0) std::reverse(polygon.outer.begin(), polygon.outer.end());
  for (Ring& hole : polygon.holes)
    if (area2(hole) > 0) std::reverse(hole.begin(), hole.end());
}

Side side_of(PlanPoint point, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const PlanPoint a = ring[j], b = ring[i];
    if ((a.y > point.y) != (b.y > point.y)) {
      const std::int64_t side = a.y < b.y ? orient(a, b, point) : orient(b, a, point);
      if (side == 0) return Side::boundary;
      if (side > 0) inside = !inside;
    } else if (a.y == point.y && b.y == point.y) {
      if (std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x)) return Side::boundary;
    }
    if (b == point) return Side::boundary;
  }
  return inside ? Side::inside : Side::outside;
}

bool is_strictly_simple(const Polygon& polygon) {
  if (polygon.outer.size() < 3 || area2(polygon.outer) == 0) return false;
  std::vector<Edge> edges;
  append_edges(polygon.outer, 0, edges);
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
    if (polygon.holes[i].size() < 3 || area2(polygon.holes[i]) == 0) return false;
    append_edges(polygon.holes[i], i + 1, edges);
  }
  for (const Edge& edge : edges)
    if (edge.a == edge.b) return false;
  if (has_clash(edges)) return false;
  // No two rings touch, so one point tells where a whole ring lies.
  for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
    if (side_of(polygon.holes[i].front(), polygon.outer) != Side::inside) return false;
    for (std::size_t j = 0; j < polygon.holes.size(); ++j)
      if (i != j && side_of(polygon.holes[i].front(), polygon.holes[j]) == Side::inside) return false;
  }
  return true;
}

}  // namespace vicus
