#include <algorithm>

#include "sectorgen/town/site.hpp"

/// River along the embankment, its stone bridge, and the few houses beyond it.
///
///   town  ---- embankment street ----
///         ==== low wall ====[bridge]====
///          ~ ~ ~ ~ river ~ ~ ~ ~ ~ ~
namespace vicus::town {

namespace {

constexpr double kBank = 6.5;    // m from the street's centre line to the water
constexpr double kBeyond = 130;  // m of road on the far side

struct Crossing {
  std::size_t place = 0;  ///< in the embankment's polyline
  NodeId node = 0;
};

/// The embankment's centre line from west to east, and its vertex nearest to the middle of the town.
Polyline embankment(Site& site, Crossing& bridge) {
  Network& n = site.network;
  std::vector<std::size_t> edges;
  for (std::size_t e = 0; e < n.edges.size(); ++e)
    if (n.edges[e].line == 0) edges.push_back(e);
  std::sort(edges.begin(), edges.end(), [&](std::size_t a, std::size_t b) {
    return n.straight[n.edges[a].from].x < n.straight[n.edges[b].from].x;
  });
  Polyline line;
  double nearest = 1e30;
  for (const std::size_t e : edges) {
    n.edges[e].is_kept = true;
    const Polyline& c = n.edges[e].centre;
    line.insert(line.end(), c.begin() + (line.empty() ? 0 : 1), c.end());
    const double d = std::abs(line.back().x - site.origin.x - 15);
    if (e != edges.back() && d < nearest) nearest = d, bridge = {line.size() - 1, site.map.node(line.back())};
  }
  return line;
}

void build_bridge(Site& site, Vec from, NodeId street, Vec across, double width) {
  const Vec near = from + across * kBank, far = from + across * (kBank + width), end = far + across * kBeyond;
  const NodeId near_node = site.map.node(near), far_node = site.map.node(far);
  site.network.lines.emplace_back();  // its houses' street
  const std::size_t line = site.network.lines.size() - 1;
  Line& road = site.network.lines[line];
  road.kind = StreetKind::main;
  road.half_width = 4.5;
  road.name = "Über dem Fluss";
  Tags deck{{"highway", "tertiary"}, {"name", "Steinerne Brücke"}, {"bridge", "yes"}, {"layer", "1"}, {"width", "6.0"}};
  draw_way(site, {street, near_node}, street_tags(road));
  draw_way(site, {near_node, far_node}, deck);
  const Vec bow = mix(far, end, 0.5) + left_of(across) * 4;
  Tags last = street_tags(road);
  last.emplace_back("noexit", "yes");
  draw_way(site, {far_node, site.map.node(bow), site.map.node(end)}, last);
  const Ring ground = rectangle(mix(near, far, 0.5), across, width / 2, 4);
  site.map.closed_way(site.map.nodes_of(ground), {{"man_made", "bridge"},
                                                  {"layer", "1"},
                                                  {"name", "Steinerne Brücke"},
                                                  {"material", "stone"},
                                                  {"bridge:structure", "arch"}});
  build_along(site, {far + across * 8, bow, end}, line);
}

}  // namespace

void build_river(Site& site) {
  Crossing bridge;
  const Polyline street = embankment(site, bridge);
  const double width = std::clamp(length_of(street) / 12, 14.0, 60.0);
  Polyline near = offset_left(street, -kBank);
  const Vec out = unit(near.back() - near[near.size() - 2]) * 60, in = unit(near[0] - near[1]) * 60;
  near.insert(near.begin(), near[0] + in);
  near.push_back(near.back() + out);
  const Polyline far = offset_left(near, -width), middle = offset_left(near, -width / 2);
  // no way may have more than 2000 nodes
  constexpr std::size_t kPiece = 800;
  for (std::size_t from = 0; from + 1 < near.size(); from += kPiece) {
    const std::size_t to = std::min(near.size(), from + kPiece + 1);
    const auto part = [&](const Polyline& line) {
      return Polyline(line.begin() + static_cast<std::ptrdiff_t>(from), line.begin() + static_cast<std::ptrdiff_t>(to));
    };
    Ring ring = part(far);
    const Polyline back = part(near);
    ring.insert(ring.end(), back.rbegin(), back.rend());
    site.map.closed_way(site.map.nodes_of(ring), {{"natural", "water"}, {"water", "river"}, {"name", "Lauterbach"}});
    site.map.way(site.map.nodes_of(part(middle)), {{"waterway", "river"}, {"name", "Lauterbach"}});
  }
  const Vec at = street[bridge.place];
  const Vec across = unit(offset_left(street, -1)[bridge.place] - at);
  build_bridge(site, at, bridge.node, across, width);
  // the low wall on the quay, open at the bridge
  const Polyline wall = offset_left(street, -(kBank - 0.6));
  Polyline piece;
  for (std::size_t i = 0; i <= wall.size(); ++i) {
    const bool is_end = i == wall.size() || distance(wall[i], at + across * kBank) < 9 || piece.size() == 300;
    if (is_end && piece.size() > 1)
      site.map.way(site.map.nodes_of(piece), {{"barrier", "wall"}, {"height", "1"}, {"material", "stone"}});
    if (is_end) piece.clear();
    if (i < wall.size() && distance(wall[i], at + across * kBank) >= 9) piece.push_back(wall[i]);
  }
}

}  // namespace vicus::town
