#include "sectorgen/visibility/sight_map.hpp"

#include <algorithm>
#include <tuple>

#include "sectorgen/geom/triangulation.hpp"

namespace vicus {
namespace {

/// A ring's edge: from lo to hi, or from hi to lo when turned; what the ring bounds is on its left.
struct RingEdge {
  PlanPoint lo, hi;
  bool is_turned = false;
  std::uint32_t sector = kNowhere;  // kNowhere: of something that stops sight
};

class RingEdges {
 public:
  void add(const Polygon& polygon, std::uint32_t sector) {
    add(polygon.outer, sector);
    for (const auto& hole : polygon.holes) add(hole, sector);
  }
  /// Sorts; after it the runs of equal edges are the mesh's constraints.
  void finish() {
    std::sort(edges_.begin(), edges_.end(), [](const RingEdge& a, const RingEdge& b) {
      return std::tie(a.lo, a.hi, a.is_turned, a.sector) < std::tie(b.lo, b.hi, b.is_turned, b.sector);
    });
    for (std::uint32_t i = 0; i < edges_.size(); ++i)
      if (i == 0 || edges_[i].lo != edges_[i - 1].lo || edges_[i].hi != edges_[i - 1].hi) run_.push_back(i);
    run_.push_back(static_cast<std::uint32_t>(edges_.size()));
  }

  Mesh mesh() const {
    std::vector<PlanPoint> points;
    std::vector<Edge> constraints;
    for (std::size_t r = 0; r + 1 < run_.size(); ++r) {
      const auto at = static_cast<std::uint32_t>(points.size());
      points.push_back(edges_[run_[r]].lo);
      points.push_back(edges_[run_[r]].hi);
      constraints.push_back({at, at + 1});
    }
    return triangulate_edges(points, constraints);
  }

  /// Visits the edges of a constraint; is_left: what they bound lies left of a -> b.
  template <class Visit>
  void visit(std::uint32_t constraint, PlanPoint a, Visit visit) const {
    for (std::uint32_t i = run_[constraint]; i < run_[constraint + 1]; ++i)
      visit(edges_[i].sector, edges_[i].is_turned != (edges_[i].lo == a));
  }

 private:
  void add(const Ring& ring, std::uint32_t sector) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      edges_.push_back(a < b ? RingEdge{a, b, false, sector} : RingEdge{b, a, true, sector});
    }
  }

  std::vector<RingEdge> edges_;
  std::vector<std::uint32_t> run_;
};

/// What lies over a triangle.
struct Cover {
  std::uint32_t sector = kNowhere;
  std::int32_t stoppers = 0;
};

/// Every triangle's, counted from outside.
std::vector<Cover> covers_of(const Mesh& mesh, const RingEdges& edges) {
  return flood_from_hull(mesh, Cover{}, [&](Cover cover, std::uint32_t t, int k) {
    const std::uint32_t constraint = mesh.triangles[t].edge[static_cast<std::size_t>(k)];
    if (constraint == kNone) return cover;
    std::uint32_t entered = kNowhere;
    edges.visit(constraint, mesh.points[mesh.corner(t, k + 1)], [&](std::uint32_t sector, bool is_left) {
      if (sector == kNowhere)
        cover.stoppers += is_left ? 1 : -1;
      else if (is_left)
        entered = sector;
      else
        cover.sector = kNowhere;
    });
    if (entered != kNowhere) cover.sector = entered;
    return cover;
  });
}

}  // namespace

bool stops_sight(const Building& building) { return building.base_m <= 0 && building.height_m > kStopsSight_m; }
bool stops_sight(const Obstacle& obstacle) { return obstacle.height_m > kStopsSight_m; }

SightMap make_sight_map(const City& city) {
  RingEdges edges;
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) edges.add(city.sectors[s].ground, s);
  for (const auto& b : city.buildings)
    if (stops_sight(b)) edges.add(b.footprint, kNowhere);
  for (const auto& o : city.obstacles)
    if (stops_sight(o)) edges.add(o.area, kNowhere);
  SightMap map;
  map.begin.assign(city.sectors.size() + 1, 0);
  if (city.sectors.empty()) return map;
  edges.finish();
  const Mesh mesh = edges.mesh();
  const std::vector<Cover> covers = covers_of(mesh, edges);

  std::vector<std::uint32_t> order;  // open triangles by sector, those of none last
  for (std::uint32_t t = 0; t < covers.size(); ++t)
    if (covers[t].stoppers == 0) order.push_back(t);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return covers[a].sector < covers[b].sector; });
  std::vector<std::uint32_t> cell_of(covers.size(), kNowhere);
  for (std::uint32_t c = 0; c < order.size(); ++c) cell_of[order[c]] = c;
  map.cells.resize(order.size());
  for (std::uint32_t c = 0; c < order.size(); ++c) {
    const std::uint32_t t = order[c];
    SightCell& cell = map.cells[c];
    cell.sector = covers[t].sector;
    if (cell.sector != kNowhere) ++map.begin[cell.sector + 1];
    for (int k = 0; k < 3; ++k) {
      const auto side = static_cast<std::size_t>(k);
      cell.corner[side] = mesh.points[mesh.corner(t, k)];
      const std::uint32_t n = mesh.triangles[t].neighbour[side];
      if (n != kNone && cell_of[n] != kNowhere)
        cell.beyond[side] = 4 * cell_of[n] + static_cast<std::uint32_t>(mesh.twin_side(t, k));
    }
  }
  for (std::size_t s = 0; s < city.sectors.size(); ++s) map.begin[s + 1] += map.begin[s];
  return map;
}

}  // namespace vicus
