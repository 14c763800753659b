#include <algorithm>

#include "sectorgen/town/site.hpp"

/// A piece of the town wall between the ring street and the core, a gatehouse where a street comes out.
///
///    houses   |   | street        setback of the houses: kWallSetback
///   ---------[gate]----------     wall at kWallOff from the facade line
///   ========= ring street ===
namespace vicus::town {

namespace {

constexpr double kWallOff = 3.2;                    // m beyond the ring street's half width
constexpr double kGateLong = 2.5, kGateWide = 4.9;  // half sizes
constexpr double kTower = 3.2;                      // radius

struct Gate {
  Vec at, outwards;
};

/// The street that comes out of the core at a vertex of the ring street.
Edge* street_at(Network& n, std::size_t vertex, std::size_t ring_line) {
  for (Edge& e : n.edges) {
    if (e.line == ring_line || !e.is_kept || (e.from != vertex && e.to != vertex)) continue;
    const std::size_t other = e.from == vertex ? e.to : e.from;
    const Line& l = n.lines[ring_line];
    if (cross(l.to - l.from, n.straight[other] - n.straight[vertex]) > 1) return &e;
  }
  return nullptr;
}

Gate build_gate(Site& site, Edge& street, std::size_t vertex, double off, bool has_house) {
  const bool is_start = street.from == vertex;
  const double size = length_of(street.centre);
  Vec forward;
  const Vec at = point_along(street.centre, is_start ? off : size - off, &forward);
  const Vec outwards = is_start ? forward * -1 : forward;
  if (!has_house) return {at, outwards};
  site.sights |= kGate;
  const Vec outer = at + outwards * kGateLong, inner = at - outwards * kGateLong;
  const Vec side = left_of(outwards) * kGateWide;
  const Ring ring = {inner - side, at - side, outer - side, outer, outer + side, at + side, inner + side, inner};
  build_other(site, ring,
              {{"building", "gatehouse"},
               {"historic", "city_gate"},
               {"name", "Öltor"},
               {"height", "17"},
               {"roof:shape", "pyramidal"},
               {"roof:height", "5"}});
  for (const bool is_outer : {true, false}) {
    const double from_vertex = off + (is_outer ? -kGateLong : kGateLong);
    street.junctions.push_back(
        {is_start ? from_vertex : size - from_vertex, site.map.node(is_outer ? outer : inner), true});
  }
  return {at, outwards};
}

void build_tower(Site& site, Vec at) {
  Ring ring;
  for (int i = 0; i < 8; ++i) ring.push_back(at + direction_of_turn(i / 8.0) * kTower);
  build_other(site, ring, {{"building", "tower"}, {"historic", "citywalls"}, {"height", "11"}, {"roof:shape", "cone"}});
}

bool is_near_gate(const std::vector<Gate>& gates, Vec p) {
  return std::any_of(gates.begin(), gates.end(), [&](const Gate& g) { return distance(g.at, p) < kGateWide + 1.5; });
}

/// Pieces between the gates; the first gate is a house, and the wall joins its sides.
void draw_wall(Site& site, const Polyline& centre, double off, const std::vector<Gate>& gates) {
  const double size = length_of(centre), margin = off + kTower + 1;
  Polyline piece;
  const auto finish = [&] {
    if (piece.size() > 1)
      site.map.way(site.map.nodes_of(piece),
                   {{"barrier", "city_wall"}, {"historic", "citywalls"}, {"height", "7"}, {"width", "1.2"}});
    piece.clear();
  };
  for (double at = margin; at < size - margin; at += 3) {
    Vec forward;
    const Vec on_street = point_along(centre, at, &forward);
    const Vec p = on_street + left_of(forward) * off;
    if (!is_near_gate(gates, p)) {
      if (piece.empty() && !gates.empty()) {
        const Vec side = left_of(gates[0].outwards) * kGateWide;
        for (const Vec end : {gates[0].at + side, gates[0].at - side})
          if (distance(end, p) < 6.5) piece.push_back(end);
      }
      piece.push_back(p);
      continue;
    }
    if (!piece.empty() && !gates.empty()) {
      const Vec side = left_of(gates[0].outwards) * kGateWide, last = piece.back();
      for (const Vec end : {gates[0].at + side, gates[0].at - side})
        if (distance(end, last) < 6.5) piece.push_back(end);
    }
    finish();
  }
  finish();
  for (const double at : {margin, size - margin}) {
    Vec forward;
    const Vec on_street = point_along(centre, at, &forward);
    const Vec p = on_street + left_of(forward) * off;
    if (!is_near_gate(gates, p)) build_tower(site, p);
  }
}

}  // namespace

void build_wall(Site& site) {
  Network& n = site.network;
  for (std::size_t l = 0; l < n.lines.size(); ++l) {
    if (!n.lines[l].has_wall) continue;
    std::vector<std::size_t> edges;
    for (std::size_t e = 0; e < n.edges.size(); ++e)
      if (n.edges[e].line == l && n.faces[n.edges[e].left].zone == Zone::core) edges.push_back(e);
    const Vec from = n.lines[l].from, to = n.lines[l].to;
    const auto along = [&](std::size_t e) { return dot(n.straight[n.edges[e].from] - from, to - from); };
    std::sort(edges.begin(), edges.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
    if (edges.empty()) continue;
    const double off = n.lines[l].half_width + kWallOff;
    Polyline centre;
    std::vector<Gate> gates;
    for (const std::size_t e : edges) {
      const Polyline& c = n.edges[e].centre;
      centre.insert(centre.end(), c.begin() + (centre.empty() ? 0 : 1), c.end());
      Edge* street = e == edges.back() ? nullptr : street_at(n, n.edges[e].to, l);
      if (street) gates.push_back(build_gate(site, *street, n.edges[e].to, off, gates.empty()));
    }
    draw_wall(site, centre, off, gates);
  }
}

}  // namespace vicus::town
