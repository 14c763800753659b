#include "sectorgen/models/plan_cover.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "sectorgen/geom/noding.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {

double FacePlane::up_at(double x, double y) const {
  return std::clamp(up_m + gx * (x - at.x) + gy * (y - at.y), least_m, most_m);
}

namespace {

constexpr std::int64_t kSameCornerMm = 5;  // a face's corner so near to one of the footprint's is the same corner

/// By Newell's normal through the mean of the outer ring's corners.
FacePlane plane_of(const ModelFace& face) {
  FacePlane plane;
  const auto& ring = face.rings[0];
  plane.at = ring[0].at;
  plane.least_m = plane.most_m = ring[0].up_m;
  double nx = 0, ny = 0, nz = 0, mx = 0, my = 0, mz = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ModelPoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double px = p.at.x - plane.at.x, py = p.at.y - plane.at.y, qx = q.at.x - plane.at.x, qy = q.at.y - plane.at.y;
    nx += (py - qy) * (p.up_m + q.up_m);
    ny += (p.up_m - q.up_m) * (px + qx);
    nz += (px - qx) * (py + qy);
    mx += px, my += py, mz += p.up_m;
    plane.least_m = std::min(plane.least_m, p.up_m);
    plane.most_m = std::max(plane.most_m, p.up_m);
  }
  const auto n = static_cast<double>(ring.size());
  if (nz != 0) plane.gx = -nx / nz, plane.gy = -ny / nz;
  plane.up_m = mz / n - plane.gx * mx / n - plane.gy * my / n;
  return plane;
}

bool holds(const ModelFace& face, double x, double y) {
  bool is_inside = false;
  for (const auto& ring : face.rings)
    for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
      const PlanPoint a = ring[i].at, b = ring[k].at;
      if ((a.y > y) != (b.y > y) &&
          x < a.x + (y - a.y) * (static_cast<double>(b.x) - a.x) / (static_cast<double>(b.y) - a.y))
        is_inside = !is_inside;
    }
  return is_inside;
}

/// A point that noding put beyond the edge a -> b goes to the nearest lattice point that is not outside.
PlanPoint drawn_in(PlanPoint a, PlanPoint b, PlanPoint p) {
  if (orient(a, b, p) >= 0) return p;
  PlanPoint best = p;
  std::int64_t least = -1;
  for (std::int32_t dx = -1; dx <= 1; ++dx)
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      const PlanPoint q{p.x + dx, p.y + dy};
      const std::int64_t side = orient(a, b, q);
      if (side >= 0 && (least < 0 || side < least)) best = q, least = side;
    }
  return best;
}

/// Edges for the triangulation.
struct Edges {
  std::vector<PlanPoint> points;
  std::vector<Edge> edges;
  std::vector<std::vector<PlanPoint>> chains;  // per edge of the footprint
};

std::vector<Segment> segments_of(const Polygon& footprint, const HouseModel& model, const std::vector<Segment>& cuts,
                                 std::size_t& of_footprint) {
  std::vector<Segment> segments;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  add(footprint.outer);
  for (const auto& hole : footprint.holes) add(hole);
  of_footprint = segments.size();
  const auto snapped = [&](PlanPoint p) {
    for (std::size_t i = 0; i < of_footprint; ++i)
      if (distance2(segments[i].a, p) <= kSameCornerMm * kSameCornerMm) return segments[i].a;
    return p;
  };
  for (const auto& face : model.tops)
    for (const auto& ring : face.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        if (const PlanPoint a = snapped(ring[i].at), b = snapped(ring[(i + 1) % ring.size()].at); a != b)
          segments.push_back({a, b});
  segments.insert(segments.end(), cuts.begin(), cuts.end());
  return segments;
}

/// Noded once, the footprint's new points drawn in, and noded again: what moved must not cross.
Edges noded_edges(const Polygon& footprint, const HouseModel& model, const std::vector<Segment>& cuts) {
  std::size_t of_footprint = 0;
  const auto segments = segments_of(footprint, model, cuts, of_footprint);
  const Noded noded = node_segments(segments);
  std::vector<std::pair<PlanPoint, PlanPoint>> moves;
  const auto moved = [&](PlanPoint p) {
    const auto at = std::lower_bound(moves.begin(), moves.end(), std::pair(p, PlanPoint{INT32_MIN, INT32_MIN}));
    return at != moves.end() && at->first == p ? at->second : p;
  };
  for (std::size_t i = 0; i < of_footprint; ++i)
    for (std::uint32_t k = noded.begin[i] + 1; k + 1 < noded.begin[i + 1]; ++k)
      if (const PlanPoint p = noded.points[k], q = drawn_in(segments[i].a, segments[i].b, p); q != p)
        moves.emplace_back(p, q);
  std::sort(moves.begin(), moves.end());
  Edges out;
  const auto add = [&](PlanPoint a, PlanPoint b) {
    if (a == b) return;
    const auto n = static_cast<std::uint32_t>(out.points.size());
    out.points.insert(out.points.end(), {a, b});
    out.edges.push_back({n, n + 1});
  };
  std::vector<Segment> pieces;
  std::vector<std::uint32_t> owner;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::uint32_t k = noded.begin[i]; k + 1 < noded.begin[i + 1]; ++k) {
      pieces.push_back({moved(noded.points[k]), moved(noded.points[k + 1])});
      owner.push_back(static_cast<std::uint32_t>(i));
    }
  const Noded again = moves.empty() ? Noded{} : node_segments(pieces);
  out.chains.resize(of_footprint);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::vector<PlanPoint> line = {pieces[i].a, pieces[i].b};
    if (!moves.empty()) line.assign(again.points.begin() + again.begin[i], again.points.begin() + again.begin[i + 1]);
    for (std::size_t k = 0; k + 1 < line.size(); ++k) add(line[k], line[k + 1]);
    if (owner[i] >= of_footprint) continue;
    auto& chain = out.chains[owner[i]];
    for (const PlanPoint p : line)
      if (chain.empty() || chain.back() != p) chain.push_back(p);
  }
  return out;
}

std::vector<std::vector<std::uint32_t>> indexed(const std::vector<std::vector<PlanPoint>>& chains, const Mesh& mesh) {
  std::vector<std::pair<PlanPoint, std::uint32_t>> index;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) index.emplace_back(mesh.points[i], i);
  std::sort(index.begin(), index.end());
  std::vector<std::vector<std::uint32_t>> out;
  for (const auto& chain : chains) {
    out.emplace_back();
    for (const PlanPoint p : chain)
      out.back().push_back(std::lower_bound(index.begin(), index.end(), std::pair(p, 0u))->second);
  }
  return out;
}

/// Triangles that no face holds take the face of a neighbour, the nearest ones first.
void fill_gaps(const std::vector<char>& is_inside, PlanCover& cover) {
  std::deque<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < cover.face.size(); ++t)
    if (cover.face[t] != kNone) queue.push_back(t);
  while (!queue.empty()) {
    const std::uint32_t t = queue.front();
    queue.pop_front();
    for (const std::uint32_t n : cover.mesh.triangles[t].neighbour)
      if (n != kNone && is_inside[n] && cover.face[n] == kNone) cover.face[n] = cover.face[t], queue.push_back(n);
  }
}

}  // namespace

PlanCover cover_plan(const Polygon& footprint, const HouseModel& model, const std::vector<Segment>& cuts) {
  PlanCover cover;
  for (const auto& face : model.tops) cover.planes.push_back(plane_of(face));
  Edges edges = noded_edges(footprint, model, cuts);
  cover.mesh = triangulate_edges(edges.points, edges.edges);
  const Mesh& mesh = cover.mesh;
  cover.chains = indexed(edges.chains, mesh);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rim;
  for (const auto& chain : cover.chains)
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) rim.push_back(std::minmax(chain[k], chain[k + 1]));
  std::sort(rim.begin(), rim.end());
  const auto is_inside = flood_from_hull(mesh, char{0}, [&](char value, std::uint32_t t, int k) {
    const auto side = std::minmax({mesh.corner(t, k + 1), mesh.corner(t, k + 2)});
    return static_cast<char>(std::binary_search(rim.begin(), rim.end(), std::pair(side)) ? 1 - value : value);
  });
  cover.face.assign(mesh.triangles.size(), kNone);
  double inside2 = 0, covered2 = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_inside[t]) continue;
    const PlanPoint a = mesh.points[mesh.corner(t, 0)], b = mesh.points[mesh.corner(t, 1)],
                    c = mesh.points[mesh.corner(t, 2)];
    const double x = (static_cast<double>(a.x) + b.x + c.x) / 3, y = (static_cast<double>(a.y) + b.y + c.y) / 3;
    double most = -HUGE_VAL;
    for (std::uint32_t f = 0; f < model.tops.size(); ++f)
      if (holds(model.tops[f], x, y))
        if (const double up = cover.planes[f].up_at(x, y); up > most) most = up, cover.face[t] = f;
    const auto area2 = static_cast<double>(orient(a, b, c));
    inside2 += area2;
    if (cover.face[t] != kNone) covered2 += area2;
  }
  cover.covered = inside2 > 0 ? covered2 / inside2 : 0;
  fill_gaps(is_inside, cover);
  return cover;
}

}  // namespace vicus
