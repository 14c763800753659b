#include "sectorgen/town/site.hpp"

namespace vicus::town {

Outlet outlet_of(const Site& site, Vec direction) {
  const Network& n = site.network;
  std::size_t best = Edge::kNoFace;
  for (const Edge& e : n.edges) {
    if (!e.is_kept || n.lines[e.line].kind == StreetKind::avenue) continue;
    for (const std::size_t v : {e.from, e.to})
      if (best == Edge::kNoFace || dot(n.vertices[v], direction) > dot(n.vertices[best], direction)) best = v;
  }
  const Vec at = best == Edge::kNoFace ? site.origin : n.vertices[best];
  return {site.map.node(at), at};
}

void draw_country_road(Site& site, const Outlet& from, const Outlet& to) {
  constexpr double kStep = 900;  // m
  const double size = distance(from.at, to.at);
  const Vec aside = left_of(unit(to.at - from.at));
  std::vector<NodeId> nodes{from.node};
  const int steps = static_cast<int>(size / kStep);
  for (int i = 1; i < steps; ++i) {
    const double t = i / static_cast<double>(steps);
    nodes.push_back(site.map.node(mix(from.at, to.at, t) + aside * (350 * sine_of_turn(2 * t) * sine_of_turn(t / 2))));
  }
  nodes.push_back(to.node);
  draw_way(site, std::move(nodes),
           {{"highway", "unclassified"}, {"name", site.names.street(site.rng)}, {"width", "6"}});
}

}  // namespace vicus::town
