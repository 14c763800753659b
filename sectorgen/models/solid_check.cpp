#include "sectorgen/models/solid_check.hpp"

#include <algorithm>
#include <cmath>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/models/roof_flat.hpp"

namespace vicus {
namespace {

using Fault = std::optional<std::string>;
using SolidEdge = std::pair<RoofPoint, RoofPoint>;

Ring plan_ring(const Roof& roof, const std::vector<std::uint32_t>& ring) {
  Ring out;
  out.reserve(ring.size());
  for (const std::uint32_t i : ring) out.push_back(roof.points[i].at);
  return out;
}

/// No two edges meet but neighbours in their common point. Exact.
bool is_simple(const Ring& ring) {
  struct Span {
    std::int32_t low, high;
    std::size_t edge;
  };
  const std::size_t n = ring.size();
  std::vector<Span> spans;
  for (std::size_t i = 0; i < n; ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % n];
    if (a == b) return false;
    spans.push_back({std::min(a.x, b.x), std::max(a.x, b.x), i});
  }
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.low < b.low; });
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 1; k < n && spans[k].low <= spans[i].high; ++k) {
      const std::size_t e = spans[i].edge, f = spans[k].edge;
      const PlanPoint a = ring[e], b = ring[(e + 1) % n], c = ring[f], d = ring[(f + 1) % n];
      if ((e + 1) % n == f || (f + 1) % n == e) {
        // Neighbours: the far ends must not lie on the other edge.
        const bool e_first = (e + 1) % n == f;
        const PlanPoint far_e = e_first ? a : b, far_f = e_first ? d : c;
        if (on_segment(c, d, far_e) || on_segment(a, b, far_f)) return false;
        continue;
      }
      if (cross_properly(a, b, c, d) || on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) ||
          on_segment(c, d, b))
        return false;
    }
  return true;
}

/// Rings that may share points but nothing else.
bool is_apart(const Ring& p, const Ring& q) {
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t k = 0; k < q.size(); ++k) {
      const PlanPoint a = p[i], b = p[(i + 1) % p.size()], c = q[k], d = q[(k + 1) % q.size()];
      if (cross_properly(a, b, c, d)) return false;
      for (const PlanPoint x : {c, d})
        if (x != a && x != b && on_segment(a, b, x)) return false;
      for (const PlanPoint x : {a, b})
        if (x != c && x != d && on_segment(c, d, x)) return false;
      if ((a == c && b == d) || (a == d && b == c)) return false;
    }
  return true;
}

Fault fault_of_plan(const Roof& roof, const RoofFacet& facet) {
  Polygon polygon;
  for (std::size_t r = 0; r < facet.rings.size(); ++r) {
    Ring ring = plan_ring(roof, facet.rings[r]);
    if (!is_simple(ring)) return "a slope that crosses or touches itself in plan";
    if ((area2(ring) > 0) != (r == 0) || area2(ring) == 0) return "a slope that is turned over in plan";
    for (const PlanPoint p : ring)
      if (r > 0 && locate(Polygon{polygon.outer, {}}, p) == Side::outside) return "a hole outside of its facet";
    if (r > 0 && !is_apart(polygon.outer, ring)) return "a hole that crosses its facet's rim";
    for (const auto& hole : polygon.holes) {
      if (!is_apart(hole, ring)) return "two holes that cross";
      if (locate(Polygon{hole, {}}, ring[0]) == Side::inside || locate(Polygon{ring, {}}, hole[0]) == Side::inside)
        return "a hole in a hole";
    }
    (r == 0 ? polygon.outer : polygon.holes.emplace_back()) = std::move(ring);
  }
  return std::nullopt;
}

/// Upright over a -> b, which is where its ring touches the eave first to last, or exactly in one upright plane.
Fault fault_of_gable(const Roof& roof, const RoofFacet& facet, const std::vector<SolidEdge>& rim) {
  if (facet.rings.size() != 1) return "a gable with a hole";
  const auto& ring = facet.rings[0];
  const std::size_t n = ring.size();
  std::size_t base = n;
  for (std::size_t i = 0; i < n; ++i)
    if (std::binary_search(rim.begin(), rim.end(), SolidEdge{roof.points[ring[i]], roof.points[ring[(i + 1) % n]]})) {
      if (base != n) return "a gable over two edges of the footprint";
      base = i;
    }
  if (base == n) return "a gable over no edge of the footprint";
  const RoofPoint a = roof.points[ring[base]], b = roof.points[ring[(base + 1) % n]];
  const double length = std::sqrt(static_cast<double>(distance2(a.at, b.at)));
  std::int64_t last = dot(a.at, b.at, b.at);
  int rise = 0;  // of the move before, where it was upright: 1 up, -1 down
  // From b back to a along the top: never backwards, never below the eave, never outside, hardly inside.
  for (std::size_t k = 2; k <= n; ++k) {
    const RoofPoint p = roof.points[ring[(base + k) % n]], before = roof.points[ring[(base + k - 1) % n]];
    const std::int64_t along = dot(a.at, b.at, p.at);
    if (along > last || along < 0) return "a gable that folds back";
    if (k < n && p.up <= a.up) return "a gable that sinks below the eave";
    const int now = p.at != before.at ? 0 : p.up > before.up ? 1 : -1;
    if (now * rise < 0) return "a gable with a spike";
    rise = now;
    const std::int64_t side = orient(a.at, b.at, p.at);
    if (side < 0) return "a gable that leans outwards";
    if (static_cast<double>(side) > kMostLean_mm * length) return "a gable that leans inwards";
    last = along;
  }
  return std::nullopt;
}

/// Upright over a -> b exactly: up over b, back over a down, and nothing else.
Fault fault_of_step(const Roof& roof, const RoofFacet& facet) {
  if (facet.rings.size() != 1) return "a step with a hole";
  std::vector<RoofPoint> ring;
  for (const std::uint32_t i : facet.rings[0]) ring.push_back(roof.points[i]);
  const std::size_t n = ring.size();
  std::size_t crossings = 0, first = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (ring[i].at != ring[(i + 1) % n].at) ++crossings, first = (i + 1) % n;
  if (crossings != 2) return "a step that is not upright";
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
  const auto turn = std::find_if(ring.begin(), ring.end(), [&](const RoofPoint& p) { return p.at != ring[0].at; });
  const auto rises = [](auto from, auto to) {
    return std::adjacent_find(from, to, [](const RoofPoint& p, const RoofPoint& q) { return p.up >= q.up; }) == to;
  };
  const auto falls = [](auto from, auto to) {
    return std::adjacent_find(from, to, [](const RoofPoint& p, const RoofPoint& q) { return p.up <= q.up; }) == to;
  };
  // One run goes up and the other down; a run of one point does both.
  const bool is_good =
      (rises(ring.begin(), turn) && falls(turn, ring.end())) || (falls(ring.begin(), turn) && rises(turn, ring.end()));
  return is_good ? std::nullopt : Fault("a step with a spike");
}

Fault fault_of_facet(const Roof& roof, const RoofFacet& facet, const std::vector<SolidEdge>& rim) {
  if (facet.kind == FacetKind::gable) return fault_of_gable(roof, facet, rim);
  return facet.kind == FacetKind::step ? fault_of_step(roof, facet) : fault_of_plan(roof, facet);
}

Fault fault_of_edges(const Roof& roof, const std::vector<SolidEdge>& rim) {
  std::vector<SolidEdge> edges;
  for (const auto& facet : roof.facets)
    for (const auto& ring : facet.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.push_back({roof.points[ring[i]], roof.points[ring[(i + 1) % ring.size()]]});
  // The top edge of a wall runs against the footprint's ring.
  for (const auto& [a, b] : rim) edges.push_back({b, a});
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].first == edges[i].second) return "an edge without length";
    if (i > 0 && edges[i] == edges[i - 1]) return "an edge used twice in one direction";
    if (!std::binary_search(edges.begin(), edges.end(), SolidEdge{edges[i].second, edges[i].first}))
      return "an open edge";
  }
  return std::nullopt;
}

}  // namespace

double off_plane_m(const Roof& roof, const RoofFacet& facet) {
  struct Vector {
    double x, y, z;
  };
  const RoofPoint origin = roof.points[facet.rings[0][0]];
  const auto metres_of = [&](std::uint32_t i) {
    const RoofPoint& p = roof.points[i];
    return Vector{metres(std::int64_t{p.at.x} - origin.at.x), metres(std::int64_t{p.at.y} - origin.at.y),
                  (p.up - origin.up) / kRoofStepsPerMetre};
  };
  Vector normal{0, 0, 0}, centre{0, 0, 0};
  double count = 0;
  for (const auto& ring : facet.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector p = metres_of(ring[i]), q = metres_of(ring[(i + 1) % ring.size()]);
      normal.x += (p.y - q.y) * (p.z + q.z);
      normal.y += (p.z - q.z) * (p.x + q.x);
      normal.z += (p.x - q.x) * (p.y + q.y);
      centre = {centre.x + p.x, centre.y + p.y, centre.z + p.z};
      ++count;
    }
  if (count <= 3) return 0;
  const double length = std::hypot(normal.x, normal.y, normal.z);
  if (length == 0) return HUGE_VAL;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const auto& ring : facet.rings)
    for (const std::uint32_t i : ring) {
      const Vector p = metres_of(i);
      const double off = (normal.x * p.x + normal.y * p.y + normal.z * p.z) / length;
      least = std::min(least, off);
      most = std::max(most, off);
    }
  return (most - least) / 2;
}

Fault fault_of_roof(const Polygon& footprint, double eave_m, const Roof& roof) {
  std::vector<SolidEdge> rim;
  const std::int32_t eave = roof_steps(eave_m);
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) rim.push_back({{ring[i], eave}, {ring[(i + 1) % ring.size()], eave}});
  };
  add(footprint.outer);
  for (const auto& hole : footprint.holes) add(hole);
  std::sort(rim.begin(), rim.end());
  for (const auto& p : roof.points)
    if (p.up < eave) return "a point below the eave";
  for (const auto& facet : roof.facets) {
    if (facet.rings.empty()) return "a facet without a ring";
    for (const auto& ring : facet.rings) {
      if (ring.size() < 3) return "a ring of two points";
      for (const std::uint32_t i : ring)
        if (i >= roof.points.size()) return "an index beyond the points";
    }
    if (facet.kind == FacetKind::top)
      for (const auto& ring : facet.rings)
        for (const std::uint32_t i : ring)
          if (roof.points[i].up != roof.points[facet.rings[0][0]].up) return "a top that is not level";
    if (off_plane_m(roof, facet) >= kMostOffPlane_m) return "a facet that is not planar";
    if (auto fault = fault_of_facet(roof, facet, rim)) return fault;
  }
  return fault_of_edges(roof, rim);
}

}  // namespace vicus
