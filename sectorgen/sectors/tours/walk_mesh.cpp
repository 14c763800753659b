#include "sectorgen/sectors/tours/walk_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "city_db/z_order.hpp"
#include "sectorgen/geom/noding.hpp"
#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

constexpr std::uint32_t kGate = kNone, kCap = kNone - 1;  // owners that are no sectors

/// A piece of a ring or gate on the lattice, from lo to hi, or from hi to lo when turned; what it bounds is on its
/// left.
struct Bound {
  PlanPoint lo, hi;
  std::uint32_t owner = kGate;
  bool is_turned = false;
};

class Bounds {
 public:
  void add_ring(const Ring& ring, std::uint32_t owner) {
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], owner);
  }
  void add_line(const std::vector<PlanPoint>& line, std::uint32_t owner) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) add(line[i], line[i + 1], owner);
  }
  /// Caps cross walls and each other: everything is noded anew.
  void node() {
    std::vector<Segment> segments;
    segments.reserve(bounds_.size());
    for (const auto& b : bounds_) segments.push_back(b.is_turned ? Segment{b.hi, b.lo} : Segment{b.lo, b.hi});
    const Noded noded = node_segments(segments);
    const auto before = std::move(bounds_);
    bounds_.clear();
    for (std::size_t i = 0; i < before.size(); ++i)
      for (std::uint32_t p = noded.begin[i]; p + 1 < noded.begin[i + 1]; ++p)
        add(noded.points[p], noded.points[p + 1], before[i].owner);
  }
  Mesh mesh() {
    std::sort(bounds_.begin(), bounds_.end(), [](const Bound& a, const Bound& b) {
      return std::tie(a.lo, a.hi, a.owner, a.is_turned) < std::tie(b.lo, b.hi, b.owner, b.is_turned);
    });
    std::vector<PlanPoint> points;
    std::vector<Edge> edges;
    for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
      if (i > 0 && bounds_[i].lo == bounds_[i - 1].lo && bounds_[i].hi == bounds_[i - 1].hi) continue;
      run_.push_back(i);
      const auto at = static_cast<std::uint32_t>(points.size());
      points.push_back(bounds_[i].lo);
      points.push_back(bounds_[i].hi);
      edges.push_back({at, at + 1});
    }
    run_.push_back(static_cast<std::uint32_t>(bounds_.size()));
    return triangulate_edges(points, edges);
  }
  /// Visits what lies on the edge: visit(owner, is it on the left of a -> ...).   Needs  mesh() was called.
  template <class Visit>
  void visit(std::uint32_t edge, PlanPoint a, Visit visit) const {
    for (std::uint32_t i = run_[edge]; i < run_[edge + 1]; ++i)
      visit(bounds_[i].owner, bounds_[i].is_turned != (bounds_[i].lo == a));
  }

 private:
  void add(PlanPoint a, PlanPoint b, std::uint32_t owner) {
    if (a != b) bounds_.push_back(a < b ? Bound{a, b, owner, false} : Bound{b, a, owner, true});
  }

  std::vector<Bound> bounds_;
  std::vector<std::uint32_t> run_;  // per edge of the mesh its first bound
};

struct Cover {
  std::uint32_t sector = kNone;
  std::int32_t caps = 0;
};

/// What lies over each triangle, counted from outside.
std::vector<Cover> covers_of(const Mesh& mesh, const Bounds& bounds) {
  return flood_from_hull(mesh, Cover{}, [&](Cover cover, std::uint32_t t, int k) {
    const std::uint32_t edge = mesh.triangles[t].edge[static_cast<std::size_t>(k)];
    if (edge == kNone) return cover;
    std::uint32_t entered = kNone;
    bounds.visit(edge, mesh.points[mesh.corner(t, k + 1)], [&](std::uint32_t owner, bool is_left) {
      if (owner == kGate) return;
      if (owner == kCap)
        cover.caps += is_left ? 1 : -1;
      else if (is_left)
        entered = owner;
      else if (owner == cover.sector)
        cover.sector = kNone;
    });
    if (entered != kNone) cover.sector = entered;
    return cover;
  });
}

/// Can one step over this edge, as far as it bears marks: no sector ends there, or there is a gate.
bool is_passable(const Bounds& bounds, std::uint32_t edge) {
  bool is_end = false, is_gate = false;
  bounds.visit(edge, {}, [&](std::uint32_t owner, bool) {
    if (owner == kGate)
      is_gate = true;
    else if (owner != kCap)
      is_end = true;
  });
  return is_gate || !is_end;
}

void open_sides(WalkMesh& walk, const Bounds& bounds) {
  const auto& triangles = walk.mesh.triangles;
  walk.open.assign(triangles.size(), 0);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t n = triangles[t].neighbour[k];
      if (walk.sector[t] == kNone || n == kNone || walk.sector[n] == kNone) continue;
      if (triangles[t].edge[k] == kNone || is_passable(bounds, triangles[t].edge[k]))
        walk.open[t] = static_cast<std::uint8_t>(walk.open[t] | 1u << k);
    }
}

/// Round each point from wall to wall: a point may have several such fans of triangles, one of them wider than a half.
void find_bends(WalkMesh& walk) {
  walk.bends.assign(walk.mesh.triangles.size(), 0);
  walk.right_wall.assign(walk.mesh.points.size(), {});
  walk.left_wall.assign(walk.mesh.points.size(), {});
  std::vector<std::pair<std::uint32_t, int>> fan;
  for (std::uint32_t t = 0; t < walk.mesh.triangles.size(); ++t)
    for (int k = 0; walk.sector[t] != kNone && k < 3; ++k) {
      if (walk.is_open(t, k + 2)) continue;  // the side from corner k to corner k + 1
      fan.clear();
      int j = k;
      for (std::uint32_t at = t; at != kNone; at = turned_left(walk, at, j)) fan.emplace_back(at, j);
      const PlanPoint p = walk.at(t, k), first = walk.at(t, k + 1),
                      last = walk.at(fan.back().first, fan.back().second + 2);
      const auto side = orient(p, first, last);
      if (side > 0 || (side == 0 && dot(p, first, last) < 0)) continue;
      walk.right_wall[walk.mesh.corner(t, k)] = first;
      walk.left_wall[walk.mesh.corner(t, k)] = last;
      walk.corners.push_back({t, k});
      for (const auto& [at, corner] : fan) walk.bends[at] = static_cast<std::uint8_t>(walk.bends[at] | 1u << corner);
    }
  // What is looked at together lies together: a search goes through the graph's nodes from neighbour to neighbour.
  std::vector<std::pair<std::uint64_t, SideOfFan>> ordered;
  for (const auto& c : walk.corners) ordered.emplace_back(z_order(walk.at(c.triangle, c.corner)), c);
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < ordered.size(); ++i) walk.corners[i] = ordered[i].second;
}

void number_parts(WalkMesh& walk) {
  const auto& triangles = walk.mesh.triangles;
  walk.part.assign(triangles.size(), kNone);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t first = 0; first < triangles.size(); ++first) {
    if (walk.sector[first] == kNone || walk.part[first] != kNone) continue;
    walk.part[first] = walk.part_count;
    queue.push_back(first);
    while (!queue.empty()) {
      const std::uint32_t t = queue.back();
      queue.pop_back();
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t n = triangles[t].neighbour[static_cast<std::size_t>(k)];
        if (!walk.is_open(t, k) || walk.part[n] != kNone) continue;
        walk.part[n] = walk.part_count;
        queue.push_back(n);
      }
    }
    ++walk.part_count;
  }
}

/// A triangle with one way on is a blind alley's end; taken away, its neighbour may be the next.
void find_blind_alleys(WalkMesh& walk) {
  const auto& triangles = walk.mesh.triangles;
  walk.way_out.assign(triangles.size(), kNone);
  std::vector<std::uint8_t> ways(triangles.size(), 0);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) ways[t] = static_cast<std::uint8_t>(ways[t] + walk.is_open(t, k));
    if (ways[t] == 1) queue.push_back(t);
  }
  while (!queue.empty()) {
    const std::uint32_t t = queue.back();
    queue.pop_back();
    if (ways[t] != 1) continue;  // its neighbour went before: the last of a part without rounds
    ways[t] = 0;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = triangles[t].neighbour[static_cast<std::size_t>(k)];
      if (!walk.is_open(t, k) || walk.way_out[n] != kNone) continue;
      walk.way_out[t] = n;
      if (--ways[n] == 1) queue.push_back(n);
    }
  }
}

void mark_radii(WalkMesh& walk, const std::vector<CornerCap>& caps) {
  walk.radius_mm.assign(walk.mesh.points.size(), 0);
  std::vector<std::pair<PlanPoint, std::int32_t>> rims;
  for (const auto& cap : caps)
    for (const PlanPoint p : cap.rim) rims.emplace_back(p, cap.radius_mm);
  std::sort(rims.begin(), rims.end());  // of one point the least
  for (std::size_t i = 0; i < walk.mesh.points.size(); ++i) {
    const auto rim = std::lower_bound(rims.begin(), rims.end(), std::pair(walk.mesh.points[i], std::int32_t{0}));
    if (rim != rims.end() && rim->first == walk.mesh.points[i]) walk.radius_mm[i] = rim->second;
  }
}

}  // namespace

std::uint32_t turned_left(const WalkMesh& walk, std::uint32_t t, int& j) {
  const int side = (j + 1) % 3;  // from corner j + 2 to corner j
  if (!walk.is_open(t, side)) return kNone;
  const int twin = walk.mesh.twin_side(t, side);
  j = (twin + 1) % 3;  // the twin runs from corner j
  return walk.mesh.triangles[t].neighbour[static_cast<std::size_t>(side)];
}

std::uint32_t turned_right(const WalkMesh& walk, std::uint32_t t, int& j) {
  const int side = (j + 2) % 3;  // from corner j to corner j + 1
  if (!walk.is_open(t, side)) return kNone;
  const int twin = walk.mesh.twin_side(t, side);
  j = (twin + 2) % 3;  // the twin runs to corner j
  return walk.mesh.triangles[t].neighbour[static_cast<std::size_t>(side)];
}

WalkMesh make_walk_mesh(const std::vector<Sector>& sectors, const std::vector<Gate>& gates,
                        const std::vector<CornerCap>& caps) {
  Bounds bounds;
  for (std::uint32_t s = 0; s < sectors.size(); ++s) {
    bounds.add_ring(sectors[s].ground.outer, s);
    for (const auto& hole : sectors[s].ground.holes) bounds.add_ring(hole, s);
  }
  for (const auto& gate : gates)
    if (!gate.to_sector_id.empty()) bounds.add_line(gate.line, kGate);
  for (const auto& cap : caps) {
    assert(cap.rim.size() >= 2);
    Ring ring{cap.corner};
    ring.insert(ring.end(), cap.rim.begin(), cap.rim.end());
    bounds.add_ring(ring, kCap);
  }
  if (!caps.empty()) bounds.node();
  WalkMesh walk;
  walk.mesh = bounds.mesh();
  const auto covers = covers_of(walk.mesh, bounds);
  walk.sector.reserve(covers.size());
  for (const auto& cover : covers) walk.sector.push_back(cover.caps == 0 ? cover.sector : kNone);
  open_sides(walk, bounds);
  find_bends(walk);
  number_parts(walk);
  find_blind_alleys(walk);
  mark_radii(walk, caps);
  return walk;
}

}  // namespace vicus
