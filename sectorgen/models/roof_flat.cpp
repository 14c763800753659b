#include "sectorgen/models/roof_flat.hpp"

#include <algorithm>
#include <cmath>

#include "sectorgen/geom/polygon.hpp"

namespace vicus {
namespace {

bool is_convex(const Ring& ring) {
  for (std::size_t i = 0, n = ring.size(); i < n; ++i)
    if (orient(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) <= 0) return false;
  return true;
}

/// The facet as a polygon of its own: upright ones are unrolled along their longest run in plan, which is their width.
Polygon polygon_of(const Roof& roof, const RoofFacet& facet) {
  PlanPoint from, to;
  std::int64_t most = -1;
  const auto& outer = facet.rings.front();
  if (is_upright(facet.kind)) {
    for (const std::uint32_t i : outer)
      for (const std::uint32_t j : {outer[0], outer[1]})
        if (const auto d = distance2(roof.points[j].at, roof.points[i].at); d > most)
          most = d, from = roof.points[j].at, to = roof.points[i].at;
  }
  const double length = most > 0 ? std::sqrt(static_cast<double>(most)) : 1;
  const double dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
  const auto flat = [&](std::uint32_t i) {
    const RoofPoint& p = roof.points[i];
    if (!is_upright(facet.kind)) return p.at;
    const double along = 10 * (dx * (p.at.x - from.x) + dy * (p.at.y - from.y));
    return PlanPoint{static_cast<std::int32_t>(std::llround(along)), p.up};
  };
  Polygon polygon;
  for (std::size_t r = 0; r < facet.rings.size(); ++r) {
    Ring ring;
    for (const std::uint32_t i : facet.rings[r]) ring.push_back(flat(i));
    if (r == 0)
      polygon.outer = std::move(ring);
    else
      polygon.holes.push_back(std::move(ring));
  }
  // Unrolled from its far end a gable is seen from behind.
  if (is_upright(facet.kind) && area2(polygon.outer) < 0)
    for (auto& p : polygon.outer) p.x = -p.x;
  return polygon;
}

/// Ears, the first that holds no other corner; where rounding leaves none, the first that turns left at all. Gables
/// have few corners, and unrolled they are only nearly the polygon that the checker passed: this never fails.
std::vector<std::uint32_t> ears_of(const Ring& ring) {
  std::vector<std::uint32_t> left(ring.size()), out;
  for (std::uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    std::size_t best = n, turning = n;
    for (std::size_t i = 0; i < n && best == n; ++i) {
      const std::uint32_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
      if (orient(ring[a], ring[b], ring[c]) <= 0) continue;
      if (turning == n) turning = i;
      const bool is_empty = std::none_of(left.begin(), left.end(), [&](std::uint32_t p) {
        return p != a && p != b && p != c && orient(ring[a], ring[b], ring[p]) >= 0 &&
               orient(ring[b], ring[c], ring[p]) >= 0 && orient(ring[c], ring[a], ring[p]) >= 0;
      });
      if (is_empty) best = i;
    }
    if (best == n) best = turning == n ? 0 : turning;
    out.insert(out.end(), {left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  out.insert(out.end(), left.begin(), left.end());
  return out;
}

}  // namespace

std::int32_t roof_steps(double up_m) { return static_cast<std::int32_t>(std::llround(up_m * kRoofStepsPerMetre)); }

Roof flat_roof(const Polygon& footprint, double up_m) {
  Roof roof;
  RoofFacet top;
  const auto add = [&](const Ring& ring) {
    top.rings.emplace_back();
    for (const PlanPoint p : ring) {
      top.rings.back().push_back(static_cast<std::uint32_t>(roof.points.size()));
      roof.points.push_back({p, roof_steps(up_m)});
    }
  };
  add(footprint.outer);
  for (const auto& hole : footprint.holes) add(hole);
  roof.facets.push_back(std::move(top));
  triangulate_facets(roof);
  return roof;
}

void triangulate_facets(Roof& roof) {
  for (auto& facet : roof.facets) {
    const Polygon polygon = polygon_of(roof, facet);
    std::vector<std::uint32_t> points;
    for (const auto& ring : facet.rings) points.insert(points.end(), ring.begin(), ring.end());
    facet.triangles.clear();
    if (polygon.holes.empty() && is_convex(polygon.outer)) {
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        facet.triangles.insert(facet.triangles.end(), {points[0], points[i], points[i + 1]});
      continue;
    }
    for (const std::uint32_t i : is_upright(facet.kind) ? ears_of(polygon.outer) : triangulate(polygon))
      facet.triangles.push_back(points[i]);
  }
}

}  // namespace vicus
