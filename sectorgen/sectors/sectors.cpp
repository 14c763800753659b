#include "sectorgen/sectors/sectors.hpp"

#include <algorithm>
#include <map>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/houses.hpp"
#include "sectorgen/sectors/tracing.hpp"

namespace vicus {
namespace {

using DirectedEdge = std::pair<PlanPoint, PlanPoint>;

/// Region numbers: cells first, then one for each kind of closed ground.
struct Regions {
  std::vector<std::uint32_t> of;
  std::uint32_t cells = 0;
  std::uint32_t yard() const { return cells; }
  std::uint32_t courtyard() const { return cells + 1; }
  std::uint32_t outside() const { return cells + 2; }
  std::uint32_t count() const { return cells + 3; }
};

Regions make_regions(const Ground& g, const Cells& cells) {
  Regions r{cells.of, static_cast<std::uint32_t>(cells.kind.size())};
  for (std::uint32_t t = 0; t < r.of.size(); ++t) {
    if (!g.is_free[t] || r.of[t] != kNone) continue;
    r.of[t] = cells.closed[t] == Closed::outside     ? r.outside()
              : cells.closed[t] == Closed::courtyard ? r.courtyard()
                                                     : r.yard();
  }
  return r;
}

constexpr double kFenceHeight = 1.6;

/// What a piece of a cell's boundary is; equal keys in a row make one record.
struct PieceKey {
  enum What { gate, end_of_city, border } what = border;
  std::uint32_t other = kNone;  // gate: the cell; border: the house
  BorderKind kind = BorderKind::facade;
  double height = 0;
  bool is_street = false;  // gate: a street leads through
  friend bool operator==(const PieceKey&, const PieceKey&) = default;
};

class Writer {
 public:
  Writer(const SourceMap& map, const Plan& plan, City& city)
      : map_(map),
        plan_(plan),
        city_(city),
        regions_(make_regions(plan.ground, plan.cells)),
        boundaries_(trace_regions(plan.ground, regions_.of, regions_.count())),
        bends_(plan.ground, boundaries_),
        facades_(plan, bends_),
        walls_(feature_sides(plan.noded, MapLayer::wall, bends_)) {}

  void write() {
    write_domain();
    write_obstacles();
    for (std::uint32_t c = 0; c < regions_.cells; ++c) write_cell(c);
    write_streets();
    write_houses(map_, plan_, bends_, facades_, closed_edges(), city_);
  }

 private:
  PieceKey key_of(const BoundaryPiece& p) const {
    PieceKey key;
    if (p.other != kNone) {
      if (p.other == regions_.outside()) {
        key.what = PieceKey::end_of_city;
      } else if (p.other >= regions_.cells) {
        key.kind = BorderKind::fence;
        key.height = kFenceHeight;
      } else {
        key.what = PieceKey::gate;
        key.other = p.other;
        key.is_street = plan_.routes.is_used[plan_.ground.edge_id(p.first.triangle, p.first.side)] != 0;
      }
      return key;
    }
    const GroundSide& side = plan_.ground.sides[p.ground_side];
    if (side.beyond == Beyond::city_edge) {
      key.what = PieceKey::end_of_city;
      return key;
    }
    return obstacle_key(p.a, p.b, side.beyond);
  }

  /// What stops a walker at the ground's edge ab: the house there, else the wall or fence, else water.
  PieceKey obstacle_key(PlanPoint a, PlanPoint b, Beyond beyond) const {
    PieceKey key;
    key.other = facades_.house_behind(a, b);
    if (key.other != kNone) return key;
    const auto it = std::lower_bound(walls_.begin(), walls_.end(), FeatureSide{b, a, 0});
    if (it != walls_.end() && it->a == b && it->b == a) {
      const Barrier& barrier = map_.barriers[plan_.blocks.walls[it->feature].barrier];
      key.kind = barrier.is_wall ? BorderKind::wall : BorderKind::fence;
      key.height = barrier.height_m;
      return key;
    }
    key.kind = beyond == Beyond::water ? BorderKind::bank : BorderKind::facade;
    return key;
  }

  /// Cuts a walk into runs of one kind; a gate also ends where its twin's line ends.
  template <class Emit>
  void runs(const BoundaryWalk& walk, Emit emit) const {
    const std::size_t n = walk.size();
    std::vector<PieceKey> keys;
    for (const auto& piece : walk) keys.push_back(key_of(piece));
    const auto breaks_after = [&](std::size_t i) {
      const std::size_t j = (i + 1) % n;
      if (!(keys[i] == keys[j])) return true;
      const HalfEdge next = walk[j].first;
      if (boundaries_.is_pinch[plan_.ground.mesh.corner(next.triangle, next.side + 1)])
        return true;  // rings part there
      return keys[i].what == PieceKey::gate && !continues(plan_.ground, regions_.of, walk[i], walk[j]);
    };
    std::size_t start = 0;
    while (start < n && !breaks_after(start)) ++start;
    if (start < n) {
      start = (start + 1) % n;
    } else {  // a closed line: it begins at its smallest point, as its twin does
      start = 0;
      for (std::size_t i = 1; i < n; ++i)
        if (walk[i].a < walk[start].a) start = i;
    }
    std::vector<PlanPoint> line;
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t i = (start + j) % n;
      if (line.empty()) line.push_back(walk[i].a);
      line.push_back(walk[i].b);
      if (j + 1 < n && !breaks_after(i)) continue;
      emit(keys[i], std::move(line));
      line.clear();
    }
  }

  void write_cell(std::uint32_t c) {
    std::vector<Ring> rings;
    const std::string number = std::to_string(c);
    for (const auto& walk : boundaries_.walks[c]) {
      for (auto& ring : simple_rings(ring_of(walk))) rings.push_back(std::move(ring));
      runs(walk, [&](const PieceKey& key, std::vector<PlanPoint> line) { write_run(number, key, std::move(line)); });
    }
    add_islands(c, number, rings);
    auto polygons = assemble(std::move(rings));
    Sector sector;
    sector.id = number;
    sector.ground = std::move(polygons.at(0));
    PlanBox box = box_of(sector.ground);
    sector.origin = {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
    sector.ground_triangles = triangulate(sector.ground);
    city_.sectors.push_back(std::move(sector));
  }

  void write_run(const std::string& number, const PieceKey& key, std::vector<PlanPoint> line) {
    if (key.what == PieceKey::border) {
      Border border{number, key.other == kNone ? "" : std::to_string(key.other), key.kind, key.height, std::move(line)};
      city_.borders.push_back(std::move(border));
      return;
    }
    Gate gate;
    gate.sector_id = number;
    gate.kind = key.what == PieceKey::end_of_city ? GateKind::end_of_city
                : key.is_street                   ? GateKind::street
                : line.size() > 2                 ? GateKind::kerb
                                                  : GateKind::yard;
    if (key.what == PieceKey::gate) gate.to_sector_id = std::to_string(key.other);
    gate.line = std::move(line);
    city_.gates.push_back(std::move(gate));
  }

  /// Small obstacles standing free in the cell: holes of its ground, bordered like any other.
  void add_islands(std::uint32_t c, const std::string& number, std::vector<Ring>& rings) {
    for (std::uint32_t i : islands_of(c)) {
      const Island& island = plan_.ground.islands[i];
      Ring hole = island.area.outer;
      std::reverse(hole.begin(), hole.end());
      std::vector<PlanPoint> line;
      PieceKey last;
      for (std::size_t k = 0; k < hole.size(); ++k) {
        const PlanPoint a = hole[k], b = hole[(k + 1) % hole.size()];
        const PieceKey key = obstacle_key(a, b, island.kind);
        if (!line.empty() && !(key == last)) {
          write_run(number, last, std::move(line));
          line.clear();
        }
        if (line.empty()) line.push_back(a);
        line.push_back(b);
        last = key;
      }
      write_run(number, last, std::move(line));
      rings.push_back(std::move(hole));
    }
  }

  const std::vector<std::uint32_t>& islands_of(std::uint32_t c) {
    if (island_cells_.empty() && regions_.cells > 0) {
      island_cells_.resize(regions_.count());
      locate_islands(plan_.ground, regions_.of, island_cells_);
    }
    return island_cells_[c];
  }

  void write_domain() {
    // The outline less what turned out to lie outside: opposite edges cancel.
    std::map<DirectedEdge, int> edges;
    const auto add = [&](PlanPoint a, PlanPoint b) {
      const auto twin = edges.find({b, a});
      if (twin == edges.end()) {
        ++edges[{a, b}];
      } else if (--twin->second == 0) {
        edges.erase(twin);
      }
    };
    for (const auto& outline : plan_.ground.domain) {
      const Ring ring = bends_.apply(outline);
      for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
    }
    for (const auto& walk : boundaries_.walks[regions_.outside()])
      for (const auto& piece : walk) add(piece.b, piece.a);
    std::vector<Ring> rings;
    while (!edges.empty()) {
      Ring walk;
      auto e = edges.begin();
      while (e != edges.end()) {
        const PlanPoint end = e->first.second;
        walk.push_back(e->first.first);
        if (--e->second == 0) edges.erase(e);
        e = edges.lower_bound({end, {-kPlanLimit, -kPlanLimit}});
        if (e != edges.end() && e->first.first != end) e = edges.end();
      }
      for (auto& ring : simple_rings(walk)) rings.push_back(std::move(ring));
    }
    city_.domain = assemble(std::move(rings));
  }

  void write_obstacles() {
    for_features(plan_.noded, bends_, [&](MapLayer layer, std::uint32_t f, Polygon p) {
      if (layer == MapLayer::water) city_.obstacles.push_back({ObstacleKind::water, "", 0, std::move(p)});
      if (layer != MapLayer::wall) return;
      const Barrier& b = map_.barriers[plan_.blocks.walls[f].barrier];
      city_.obstacles.push_back(
          {b.is_wall ? ObstacleKind::wall : ObstacleKind::fence, b.source_id, b.height_m, std::move(p)});
    });
    for (const auto& p : plan_.ground.courtyards) {
      Polygon bent{bends_.apply(p.outer), {}};
      for (const auto& hole : p.holes) bent.holes.push_back(bends_.apply(hole));
      city_.obstacles.push_back({ObstacleKind::courtyard, "", 0, std::move(bent)});
    }
    for (const auto& island : plan_.ground.islands)  // ground shut in by a small obstacle
      for (Ring hole : island.area.holes) {
        std::reverse(hole.begin(), hole.end());
        city_.obstacles.push_back({ObstacleKind::island, "", 0, {std::move(hole), {}}});
      }
    for (const auto& [region, kind] :
         {std::pair{regions_.yard(), ObstacleKind::yard}, {regions_.courtyard(), ObstacleKind::courtyard}}) {
      std::vector<Ring> rings;
      for (const auto& walk : boundaries_.walks[region])
        for (auto& ring : simple_rings(ring_of(walk))) rings.push_back(std::move(ring));
      for (auto& p : assemble(std::move(rings))) {
        const std::string m2 = std::to_string(static_cast<int>(area_m2(p)));
        if (kind == ObstacleKind::yard && area_m2(p) > 40)
          city_.issues.push_back({IssueCode::yard_closed,
                                  "ground of " + m2 + " m2 behind gaps too narrow to walk was fenced off", "",
                                  p.outer.front()});
        city_.obstacles.push_back({kind, "", 0, std::move(p)});
      }
    }
  }

  void write_streets() {
    for (const auto& a : map_.axes)
      city_.streets.push_back({a.source_id, a.name, a.kind, a.width_m, a.is_passage, a.is_bridge, a.is_steps, a.line});
  }

  /// Sides of ground that was closed off but may be looked into over a fence.
  std::vector<DirectedEdge> closed_edges() const {
    std::vector<DirectedEdge> out;
    for (std::uint32_t region : {regions_.yard(), regions_.outside()})
      for (const auto& walk : boundaries_.walks[region])
        for (const auto& piece : walk) out.push_back({piece.a, piece.b});
    std::sort(out.begin(), out.end());
    return out;
  }

  const SourceMap& map_;
  const Plan& plan_;
  City& city_;
  Regions regions_;
  Boundaries boundaries_;
  Bends bends_;
  Facades facades_;
  std::vector<FeatureSide> walls_;
  std::vector<std::vector<std::uint32_t>> island_cells_;
};

}  // namespace

void write_sectors(const SourceMap& map, const Plan& plan, City& city) { Writer(map, plan, city).write(); }

}  // namespace vicus
