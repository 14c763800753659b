#include "tests/support/triangulate.hpp"

#include <cassert>

namespace vicus::test {
namespace {

struct Corner {
  PlanPoint at;
  std::uint32_t index;
};

std::int64_t orient(PlanPoint a, PlanPoint b, PlanPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

int sign(std::int64_t v) { return (v > 0) - (v < 0); }

bool in_box(PlanPoint a, PlanPoint b, PlanPoint p) {
  PlanBox box;
  box.add(a);
  box.add(b);
  return box.contains(p);
}

/// Closed segments ab and cd share a point that is no common end.
bool crosses(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) {
  if (a == c || a == d || b == c || b == d) return false;
  const int abc = sign(orient(a, b, c)), abd = sign(orient(a, b, d));
  const int cda = sign(orient(c, d, a)), cdb = sign(orient(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) || (cda == 0 && in_box(c, d, a)) ||
         (cdb == 0 && in_box(c, d, b));
}

bool sees(const std::vector<std::vector<Corner>>& rings, PlanPoint a, PlanPoint b) {
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (crosses(a, b, ring[i].at, ring[(i + 1) % ring.size()].at)) return false;
  return true;
}

/// Joins the last ring (a hole) to the first by a bridge along which they see each other.
void join_hole(std::vector<std::vector<Corner>>& rings, std::size_t hole) {
  auto& outer = rings[0];
  const auto& inner = rings[hole];
  for (std::size_t o = 0; o < outer.size(); ++o)
    for (std::size_t h = 0; h < inner.size(); ++h) {
      if (!sees(rings, outer[o].at, inner[h].at)) continue;
      std::vector<Corner> bridge;
      for (std::size_t k = 0; k <= inner.size(); ++k) bridge.push_back(inner[(h + k) % inner.size()]);
      bridge.push_back(outer[o]);
      outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(o) + 1, bridge.begin(), bridge.end());
      rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(hole));
      return;
    }
  assert(!"a hole sees no corner of the outer ring");
}

bool is_ear(const std::vector<Corner>& ring, std::size_t i) {
  const PlanPoint a = ring[(i + ring.size() - 1) % ring.size()].at, b = ring[i].at, c = ring[(i + 1) % ring.size()].at;
  if (orient(a, b, c) <= 0) return false;
  for (const auto& [p, index] : ring) {
    if (p == a || p == b || p == c) continue;
    if (orient(a, b, p) >= 0 && orient(b, c, p) >= 0 && orient(c, a, p) >= 0) return false;
  }
  return true;
}

}  // namespace

Triangles triangulate(const Polygon& polygon) {
  std::vector<std::vector<Corner>> rings(1 + polygon.holes.size());
  std::uint32_t index = 0;
  for (PlanPoint p : polygon.outer) rings[0].push_back({p, index++});
  for (std::size_t h = 0; h < polygon.holes.size(); ++h)
    for (PlanPoint p : polygon.holes[h]) rings[h + 1].push_back({p, index++});
  while (rings.size() > 1) join_hole(rings, rings.size() - 1);
  auto& ring = rings[0];
  Triangles triangles;
  while (ring.size() >= 3) {
    std::size_t ear = 0;
    while (ear < ring.size() && !is_ear(ring, ear)) ++ear;
    assert(ear < ring.size() && "no ear: the polygon is not simple");
    for (std::size_t k : {ear + ring.size() - 1, ear, ear + 1}) triangles.push_back(ring[k % ring.size()].index);
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

}  // namespace vicus::test
