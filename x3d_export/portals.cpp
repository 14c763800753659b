#include "x3d_export/portals.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

namespace vicus {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

std::int64_t orient(PlanPoint a, PlanPoint b, PlanPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

std::int64_t length2(PlanPoint a, PlanPoint b) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  return dx * dx + dy * dy;
}

using Edge = std::pair<PlanPoint, PlanPoint>;

/// The triangles of one sector as half-edges: 3i, 3i+1, 3i+2 go around triangle i.
class SectorCells {
 public:
  explicit SectorCells(const Sector& sector) {
    std::vector<PlanPoint> points = sector.ground.outer;
    for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
    const auto& t = sector.ground_triangles;
    const auto fail = [&](const char* what) {
      throw CityError("sector " + sector.id + " has " + what + "; vicus check says more, vicus build makes it anew");
    };
    if (t.empty() || t.size() % 3 != 0) fail("no ground triangles");
    for (std::size_t i = 0; i < t.size(); i += 3) {
      if (std::max({t[i], t[i + 1], t[i + 2]}) >= points.size()) fail("a triangle with a corner its ground lacks");
      if (orient(points[t[i]], points[t[i + 1]], points[t[i + 2]]) <= 0) fail("a triangle without area");
      for (std::size_t k = 0; k < 3; ++k) add_half_edge(points[t[i + k]], i + (k + 1) % 3, i + (k + 2) % 3);
    }
    find_twins(sector);
  }

  /// Joins cells over their longest common edges first, while they stay convex.
  void join() {
    std::vector<std::uint32_t> inner;
    for (std::uint32_t h = 0; h < origin_.size(); ++h)
      if (twin_[h] != kNone && h < twin_[h]) inner.push_back(h);
    std::sort(inner.begin(), inner.end(), [&](auto g, auto h) {
      const auto a = length2(origin_[g], target(g)), b = length2(origin_[h], target(h));
      return a != b ? a > b : edge(g) < edge(h);
    });
    for (const auto h : inner) try_join(h);
  }

  /// Appends the cells to the graph and the portals between them; afterwards cell_at() knows their numbers.
  void append_to(PortalGraph& graph, std::uint32_t sector) {
    cell_of_.assign(origin_.size(), kNone);
    for (std::uint32_t h = 0; h < origin_.size(); ++h) {
      if (is_gone_[h] || cell_of_[h] != kNone) continue;
      ConvexCell cell{sector, {}};
      auto at = h;
      do {
        cell_of_[at] = static_cast<std::uint32_t>(graph.cells.size());
        cell.ring.push_back(origin_[at]);
        at = next_[at];
      } while (at != h);
      graph.cells.push_back(std::move(cell));
    }
    for (std::uint32_t h = 0; h < origin_.size(); ++h)
      if (!is_gone_[h] && twin_[h] != kNone && h < twin_[h] && cell_of_[h] != cell_of_[twin_[h]])
        graph.portals.push_back({cell_of_[h], cell_of_[twin_[h]], origin_[h], target(h)});
  }

  /// The cell on the left of this edge of the ground; kNone: it is none.
  std::uint32_t cell_at(const Edge& edge) const {
    const auto at = half_edge_.find(edge);
    return at == half_edge_.end() || twin_[at->second] != kNone ? kNone : cell_of_[at->second];
  }

 private:
  void add_half_edge(PlanPoint origin, std::size_t next, std::size_t previous) {
    origin_.push_back(origin);
    next_.push_back(static_cast<std::uint32_t>(next));
    previous_.push_back(static_cast<std::uint32_t>(previous));
    twin_.push_back(kNone);
    is_gone_.push_back(false);
  }
  PlanPoint target(std::uint32_t h) const { return origin_[next_[h]]; }
  Edge edge(std::uint32_t h) const { return {origin_[h], target(h)}; }

  /// Twins across the ground's own edges are none: there a wall without width stands.
  void find_twins(const Sector& sector) {
    std::set<Edge> rim;
    const auto add_ring = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) rim.insert({ring[i], ring[(i + 1) % ring.size()]});
    };
    add_ring(sector.ground.outer);
    for (const auto& hole : sector.ground.holes) add_ring(hole);
    for (std::uint32_t h = 0; h < origin_.size(); ++h) half_edge_.emplace(edge(h), h);
    for (std::uint32_t h = 0; h < origin_.size(); ++h) {
      if (rim.contains(edge(h))) continue;
      const auto at = half_edge_.find({target(h), origin_[h]});
      if (at != half_edge_.end() && !rim.contains(at->first)) twin_[h] = at->second;
    }
  }

  /// Does the corner a-b-c turn left, or go straight on?
  static bool is_convex(PlanPoint a, PlanPoint b, PlanPoint c) {
    const auto turn = orient(a, b, c);
    return turn > 0 || (turn == 0 && length2(a, c) > std::max(length2(a, b), length2(b, c)));
  }

  bool is_same_cell(std::uint32_t g, std::uint32_t h) const {
    for (auto at = next_[g];; at = next_[at]) {
      if (at == h) return true;
      if (at == g) return false;
    }
  }

  void try_join(std::uint32_t h) {
    if (is_gone_[h] || is_same_cell(h, twin_[h])) return;
    // The whole chain of edges common to both cells: vertices inside of it would dangle.
    auto first = h, last = h;
    while (previous_[first] != last && twin_[previous_[first]] != kNone &&
           twin_[previous_[first]] == next_[twin_[first]])
      first = previous_[first];
    while (next_[last] != first && twin_[next_[last]] != kNone && twin_[next_[last]] == previous_[twin_[last]])
      last = next_[last];
    const auto before = previous_[first], after = next_[last];
    const auto other_before = previous_[twin_[last]], other_after = next_[twin_[first]];
    if (!is_convex(origin_[before], origin_[first], target(other_after)) ||
        !is_convex(origin_[other_before], target(last), target(after)))
      return;
    for (auto at = first;; at = next_[at]) {
      is_gone_[at] = is_gone_[twin_[at]] = true;
      if (at == last) break;
    }
    link(before, other_after);
    link(other_before, after);
  }
  void link(std::uint32_t h, std::uint32_t next) {
    next_[h] = next;
    previous_[next] = h;
  }

  std::vector<PlanPoint> origin_;
  std::vector<std::uint32_t> next_, previous_, twin_, cell_of_;
  std::vector<bool> is_gone_;
  std::map<Edge, std::uint32_t> half_edge_;
};

void append_gate_portals(const City& city, const std::map<std::string, std::uint32_t>& number_of,
                         const std::vector<SectorCells>& cells, PortalGraph& graph) {
  for (const auto& gate : city.gates) {
    // Of two twins one makes the portals; a gate without its twin is its own fault, found below.
    if (gate.to_sector_id.empty() || (!gate.twin_id.empty() && gate.twin_id < gate.id)) continue;
    const auto a = number_of.find(gate.sector_id), b = number_of.find(gate.to_sector_id);
    for (std::size_t i = 1; i < gate.line.size(); ++i) {
      const PlanPoint from = gate.line[i - 1], to = gate.line[i];
      const auto left = a == number_of.end() ? kNone : cells[a->second].cell_at({from, to});
      const auto right = b == number_of.end() ? kNone : cells[b->second].cell_at({to, from});
      if (left == kNone || right == kNone)
        throw CityError("gate " + gate.id + " is not made of ground edges of " + gate.sector_id + " and " +
                        gate.to_sector_id + "; vicus check says more");
      graph.portals.push_back({left, right, from, to});
    }
  }
}

}  // namespace

PortalGraph portal_graph(const City& city, bool keeps_triangles) {
  PortalGraph graph;
  std::map<std::string, std::uint32_t> number_of;
  std::vector<SectorCells> cells;
  cells.reserve(city.sectors.size());
  for (std::uint32_t i = 0; i < city.sectors.size(); ++i) {
    number_of.emplace(city.sectors[i].id, i);
    cells.emplace_back(city.sectors[i]);
    if (!keeps_triangles) cells.back().join();
    cells.back().append_to(graph, i);
  }
  append_gate_portals(city, number_of, cells, graph);
  return graph;
}

std::string prt_text(const PortalGraph& graph) {
  static_assert(kPortalUnits_per_m == 1000, "coordinates are written as millimetres");
  std::string out = "PRT1\n" + std::to_string(graph.cells.size()) + "\n" + std::to_string(graph.portals.size()) + "\n";
  const auto corner = [&](PlanPoint p, int z) {
    out += '(' + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(z) + " ) ";
  };
  for (const auto& portal : graph.portals) {
    out += "4 " + std::to_string(portal.a) + ' ' + std::to_string(portal.b) + ' ';
    corner(portal.from, 0);
    corner(portal.to, 0);
    corner(portal.to, kPortalHeight_m * kPortalUnits_per_m);
    corner(portal.from, kPortalHeight_m * kPortalUnits_per_m);
    out.back() = '\n';
  }
  return out;
}

std::string prt_json(const PortalGraph& graph, const City& city) {
  nlohmann::ordered_json sectors = nlohmann::ordered_json::array();
  for (const auto& cell : graph.cells) sectors.push_back(city.sectors[cell.sector].id);
  return nlohmann::ordered_json{{"units_per_metre", kPortalUnits_per_m}, {"height_m", kPortalHeight_m},
                                {"cells", graph.cells.size()},           {"portals", graph.portals.size()},
                                {"sectors", city.sectors.size()},        {"sector_of_cell", std::move(sectors)}}
             .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

}  // namespace vicus
