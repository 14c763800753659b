#include "sectorgen/sectors/tracing.hpp"

#include <algorithm>

#include "sectorgen/sectors/locator.hpp"

namespace vicus {
namespace {

bool is_boundary(const Ground& g, const std::vector<std::uint32_t>& region, std::uint32_t t, int k) {
  return !g.is_crossable(t, k) || region[g.beyond(t, k)] != region[t];
}

/// The next boundary edge of the same region: turned about the end point, through the region.
HalfEdge next_edge(const Ground& g, const std::vector<std::uint32_t>& region, HalfEdge h) {
  std::uint32_t t = h.triangle;
  int k = (h.side + 1) % 3;  // starts where h ends
  while (!is_boundary(g, region, t, k)) {
    const int m = g.mesh.twin_side(t, k);
    t = g.beyond(t, k);
    k = (m + 1) % 3;
  }
  return {t, k};
}

BoundaryPiece piece_of(const Ground& g, const std::vector<std::uint32_t>& region, HalfEdge h) {
  BoundaryPiece p{g.from(h.triangle, h.side), g.to(h.triangle, h.side), kNone, kNone, h, h};
  if (g.is_crossable(h.triangle, h.side))
    p.other = region[g.beyond(h.triangle, h.side)];
  else
    p.ground_side = g.edges[g.mesh.triangles[h.triangle].edge[static_cast<std::size_t>(h.side)]].side;
  return p;
}

}  // namespace

bool continues(const Ground& g, const std::vector<std::uint32_t>& region, const BoundaryPiece& a,
               const BoundaryPiece& b) {
  const HalfEdge x = a.last, y = b.first;
  if (!g.is_crossable(x.triangle, x.side) || !g.is_crossable(y.triangle, y.side)) return false;
  const HalfEdge twin_x{g.beyond(x.triangle, x.side), g.mesh.twin_side(x.triangle, x.side)};
  const HalfEdge twin_y{g.beyond(y.triangle, y.side), g.mesh.twin_side(y.triangle, y.side)};
  if (region[twin_x.triangle] == kNone) return false;
  const HalfEdge next = next_edge(g, region, twin_y);
  return next.triangle == twin_x.triangle && next.side == twin_x.side;
}

Boundaries trace_regions(const Ground& g, const std::vector<std::uint32_t>& region, std::uint32_t count) {
  Boundaries out;
  out.walks.resize(count);
  out.is_kept.assign(g.mesh.points.size(), 1);
  for (std::size_t p = 0; p < out.is_kept.size(); ++p) out.is_kept[p] = !g.is_added[p];
  for (std::uint32_t t = 0; t < region.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (!g.is_crossable(t, k) || region[g.beyond(t, k)] == region[t]) continue;
      out.is_kept[g.mesh.corner(t, k + 1)] = 1;
      out.is_kept[g.mesh.corner(t, k + 2)] = 1;
    }
  out.is_pinch.assign(g.mesh.points.size(), 0);
  std::vector<std::uint32_t> passed_by(g.mesh.points.size(), kNone);
  std::uint32_t walk_number = 0;
  std::vector<char> visited(region.size() * 3, 0);
  for (std::uint32_t t = 0; t < region.size(); ++t) {
    if (region[t] == kNone) continue;
    for (int k = 0; k < 3; ++k) {
      // Start at a corner that stays.
      if (visited[3 * t + static_cast<std::uint32_t>(k)] || !is_boundary(g, region, t, k) ||
          !out.is_kept[g.mesh.corner(t, k + 1)])
        continue;
      BoundaryWalk walk;
      HalfEdge h{t, k};
      bool joins = false;
      while (!visited[3 * h.triangle + static_cast<std::uint32_t>(h.side)]) {
        visited[3 * h.triangle + static_cast<std::uint32_t>(h.side)] = 1;
        const BoundaryPiece piece = piece_of(g, region, h);
        const std::uint32_t start = g.mesh.corner(h.triangle, h.side + 1);
        if (passed_by[start] == walk_number) out.is_pinch[start] = 1;
        passed_by[start] = walk_number;
        if (joins) {
          walk.back().b = piece.b;
          walk.back().last = h;
        } else {
          walk.push_back(piece);
        }
        joins = !out.is_kept[g.mesh.corner(h.triangle, h.side + 2)];
        h = next_edge(g, region, h);
      }
      out.walks[region[t]].push_back(std::move(walk));
      ++walk_number;
    }
  }
  return out;
}

void locate_islands(const Ground& g, const std::vector<std::uint32_t>& region,
                    std::vector<std::vector<std::uint32_t>>& islands) {
  const Locator locator(g.mesh);
  for (std::uint32_t i = 0; i < g.islands.size(); ++i) {
    const std::uint32_t t = locator.locate(g.islands[i].area.outer.front());
    if (t != kNone && region[t] != kNone) islands[region[t]].push_back(i);
  }
}

Ring ring_of(const BoundaryWalk& walk) {
  Ring ring;
  for (const auto& piece : walk) ring.push_back(piece.a);
  return ring;
}

Bends::Bends(const Ground& g, const Boundaries& boundaries) {
  for (const auto& side : g.sides) {
    Bend bend{std::min(side.a, side.b), std::max(side.a, side.b), {}};
    for (PlanPoint p : side.added) {
      const auto it = std::lower_bound(g.mesh.points.begin(), g.mesh.points.end(), p);  // points are sorted
      if (boundaries.is_kept[static_cast<std::size_t>(it - g.mesh.points.begin())]) bend.points.push_back(p);
    }
    if (bend.points.empty()) continue;
    if (side.b < side.a) std::reverse(bend.points.begin(), bend.points.end());
    bends_.push_back(std::move(bend));
  }
  std::sort(bends_.begin(), bends_.end(),
            [](const Bend& x, const Bend& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
}

Ring Bends::apply(const Ring& ring) const {
  Ring out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint p = ring[i], q = ring[i + 1 == ring.size() ? 0 : i + 1];
    out.push_back(p);
    const Bend wanted{std::min(p, q), std::max(p, q), {}};
    const auto it = std::lower_bound(bends_.begin(), bends_.end(), wanted,
                                     [](const Bend& x, const Bend& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    if (it == bends_.end() || it->a != wanted.a || it->b != wanted.b) continue;
    if (p < q)
      out.insert(out.end(), it->points.begin(), it->points.end());
    else
      out.insert(out.end(), it->points.rbegin(), it->points.rend());
  }
  return out;
}

std::vector<FeatureSide> feature_sides(const std::vector<NodedPart>& map, MapLayer layer, const Bends& bends) {
  std::vector<FeatureSide> all;
  for (const auto& part : map) {
    if (part.layer != layer) continue;
    const Ring ring = bends.apply(part.points);
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (ring[i] != ring[(i + 1) % ring.size()]) all.push_back({ring[i], ring[(i + 1) % ring.size()], part.feature});
  }
  std::sort(all.begin(), all.end());
  const auto count = [&](const FeatureSide& s) {
    const auto [first, last] = std::equal_range(all.begin(), all.end(), s);
    return last - first;
  };
  std::vector<FeatureSide> out;
  for (const FeatureSide& s : all)  // a side walked on and back and on again is one
    if ((out.empty() || out.back() < s) && count(s) > count({s.b, s.a, s.feature})) out.push_back(s);
  return out;
}

}  // namespace vicus
