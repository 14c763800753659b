#include "sectorgen/visibility/sight_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/geom/triangulation.hpp"

namespace vicus {
namespace {

/// What a ring bounds: a sector's ground; a house or a wall that stops a look.
struct Bounded {
  bool is_stopper = false;
  std::uint32_t index = kNowhere;  // of the sector, of the house; kNowhere: a wall
  auto key() const { return std::tie(is_stopper, index); }
};

/// A ring's edge: from lo to hi, or from hi to lo when turned; what the ring bounds is on its left.
struct RingEdge {
  PlanPoint lo, hi;
  bool is_turned = false;
  Bounded bounded;
};

class RingEdges {
 public:
  void add(const Polygon& polygon, Bounded bounded) {
    add(polygon.outer, bounded);
    for (const auto& hole : polygon.holes) add(hole, bounded);
  }
  /// Sorts; after it the runs of equal edges are the mesh's constraints.
  void finish() {
    std::sort(edges_.begin(), edges_.end(), [](const RingEdge& a, const RingEdge& b) {
      return std::tuple(a.lo, a.hi, a.is_turned, a.bounded.key()) <
             std::tuple(b.lo, b.hi, b.is_turned, b.bounded.key());
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
      visit(edges_[i].bounded, edges_[i].is_turned != (edges_[i].lo == a));
  }

 private:
  void add(const Ring& ring, Bounded bounded) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      edges_.push_back(a < b ? RingEdge{a, b, false, bounded} : RingEdge{b, a, true, bounded});
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
    edges.visit(constraint, mesh.points[mesh.corner(t, k + 1)], [&](Bounded bounded, bool is_left) {
      if (bounded.is_stopper)
        cover.stoppers += is_left ? 1 : -1;
      else if (is_left)
        entered = bounded.index;
      else
        cover.sector = kNowhere;
    });
    if (entered != kNowhere) cover.sector = entered;
    return cover;
  });
}

/// Per house its owner, kNowhere where nobody sends it.
std::vector<std::uint32_t> owners_of(const City& city) {
  std::unordered_map<std::string, std::uint32_t> sectors;
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) sectors.emplace(city.sectors[s].id, s);
  std::vector<std::uint32_t> owners;
  for (const auto& b : city.buildings) {
    const auto found = sectors.find(b.sector_id);
    owners.push_back(found == sectors.end() ? kNowhere : found->second);
  }
  return owners;
}

/// Groups of houses, equal ones once.
class Groups {
 public:
  explicit Groups(const std::vector<std::uint32_t>& owner) : owner_(owner) {}

  /// Without those that the sector itself sends, or nobody.
  std::uint32_t of_others(std::vector<std::uint32_t> houses, std::uint32_t sector) {
    std::erase_if(houses, [&](std::uint32_t h) { return owner_[h] == kNowhere || owner_[h] == sector; });
    std::sort(houses.begin(), houses.end());
    houses.erase(std::unique(houses.begin(), houses.end()), houses.end());
    const auto [at, is_new] = number_.emplace(std::move(houses), static_cast<std::uint32_t>(lists_.size()));
    if (is_new) lists_.push_back(at->first);
    return at->second;
  }
  const std::vector<std::vector<std::uint32_t>>& lists() const { return lists_; }

 private:
  const std::vector<std::uint32_t>& owner_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> number_{{{}, 0}};
  std::vector<std::vector<std::uint32_t>> lists_{{}};
};

/// The houses that begin at side k of the triangle and stop a look there.
std::uint32_t wall_at(const Mesh& mesh, const RingEdges& edges, std::uint32_t t, int k, std::uint32_t sector,
                      Groups& groups) {
  const std::uint32_t constraint = mesh.triangles[t].edge[static_cast<std::size_t>(k)];
  if (constraint == kNone) return kNowhere;
  std::vector<std::uint32_t> houses;
  edges.visit(constraint, mesh.points[mesh.corner(t, k + 1)], [&](Bounded bounded, bool is_left) {
    if (bounded.is_stopper && !is_left && bounded.index != kNowhere) houses.push_back(bounded.index);
  });
  const std::uint32_t group = groups.of_others(std::move(houses), sector);
  return group == 0 ? kNowhere : kWall + group;
}

bool touch(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) {
  return cross_properly(a, b, c, d) || on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) ||
         on_segment(c, d, b);
}

bool touches(const SightCell& cell, const Polygon& polygon) {
  for (const PlanPoint p : cell.corner)
    if (locate(polygon, p) != Side::outside) return true;
  const auto meets = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (touch(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], cell.corner[k], cell.corner[(k + 1) % 3]))
          return true;
    return false;
  };
  if (std::any_of(polygon.holes.begin(), polygon.holes.end(), meets) || meets(polygon.outer)) return true;
  // Else the polygon is inside the triangle, or outside.
  const PlanPoint p = polygon.outer.front();
  return orient(cell.corner[0], cell.corner[1], p) > 0 && orient(cell.corner[1], cell.corner[2], p) > 0 &&
         orient(cell.corner[2], cell.corner[0], p) > 0;
}

/// Houses that do not stop a look, in squares of a grid by their boxes.
class LooseHouses {
 public:
  explicit LooseHouses(const City& city) : city_(city) {
    for (std::uint32_t h = 0; h < city.buildings.size(); ++h) {
      const Building& b = city.buildings[h];
      if (stops_sight(b) || b.footprint.outer.empty()) continue;
      PlanBox box;
      for (const PlanPoint p : b.footprint.outer) box.add(p);
      visit(box, [&](std::uint64_t square) { squares_[square].push_back(h); });
    }
  }
  /// Those that stand over some point of the cell.
  std::vector<std::uint32_t> over(const SightCell& cell) const {
    std::vector<std::uint32_t> houses;
    if (squares_.empty()) return houses;
    PlanBox box;
    for (const PlanPoint p : cell.corner) box.add(p);
    visit(box, [&](std::uint64_t square) {
      if (const auto found = squares_.find(square); found != squares_.end())
        houses.insert(houses.end(), found->second.begin(), found->second.end());
    });
    std::sort(houses.begin(), houses.end());
    houses.erase(std::unique(houses.begin(), houses.end()), houses.end());
    std::erase_if(houses, [&](std::uint32_t h) { return !touches(cell, city_.buildings[h].footprint); });
    return houses;
  }

 private:
  static constexpr std::int32_t kSquare_mm = 64'000;
  template <class Visit>
  static void visit(const PlanBox& box, Visit visit) {
    const auto square_of = [](std::int32_t v) {
      return static_cast<std::int64_t>(std::floor(static_cast<double>(v) / kSquare_mm));
    };
    for (std::int64_t y = square_of(box.min.y); y <= square_of(box.max.y); ++y)
      for (std::int64_t x = square_of(box.min.x); x <= square_of(box.max.x); ++x)
        visit(static_cast<std::uint64_t>(y) << 32 ^ static_cast<std::uint32_t>(x));
  }

  const City& city_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> squares_;
};

}  // namespace

bool stops_sight(const Building& building) { return building.base_m <= 0 && building.height_m > kStopsSight_m; }
bool stops_sight(const Obstacle& obstacle) { return obstacle.height_m > kStopsSight_m; }

SightMap make_sight_map(const City& city) {
  RingEdges edges;
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) edges.add(city.sectors[s].ground, {false, s});
  for (std::uint32_t h = 0; h < city.buildings.size(); ++h)
    if (stops_sight(city.buildings[h])) edges.add(city.buildings[h].footprint, {true, h});
  for (const auto& o : city.obstacles)
    if (stops_sight(o)) edges.add(o.area, {true, kNowhere});
  SightMap map;
  map.begin.assign(city.sectors.size() + 1, 0);
  if (city.sectors.empty()) return map;
  edges.finish();
  const Mesh mesh = edges.mesh();
  const std::vector<Cover> covers = covers_of(mesh, edges);
  map.owner = owners_of(city);
  Groups groups(map.owner);
  const LooseHouses loose(city);

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
      cell.beyond[side] = n != kNone && cell_of[n] != kNowhere
                              ? 4 * cell_of[n] + static_cast<std::uint32_t>(mesh.twin_side(t, k))
                              : wall_at(mesh, edges, t, k, cell.sector, groups);
    }
    cell.group = groups.of_others(loose.over(cell), cell.sector);
  }
  for (std::size_t s = 0; s < city.sectors.size(); ++s) map.begin[s + 1] += map.begin[s];
  map.groups = groups.lists();
  return map;
}

}  // namespace vicus
