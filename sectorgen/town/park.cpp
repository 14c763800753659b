#include <algorithm>

#include "sectorgen/town/site.hpp"

/// Park: lawn, pond, winding paths, steps, trees, benches, a railing with gates towards one street.
namespace vicus::town {

namespace {

Ring blob(Rng& rng, Vec at, double radius, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(at + direction_of_turn(i / static_cast<double>(corners)) * (radius * rng.between(0.75, 1.15)));
  return ring;
}

/// A path around the pond, joined to the streets.
void draw_paths(Site& site, const Ring& lawn, const std::vector<Side>& sides, std::size_t face, Vec pond,
                double radius) {
  std::vector<NodeId> round;
  std::vector<Vec> stations;
  for (int i = 0; i < 12; ++i) {
    stations.push_back(pond + direction_of_turn(i / 12.0) * (radius * 1.5));
    round.push_back(site.map.node(stations.back()));
  }
  round.push_back(round.front());
  bool has_steps = false;
  draw_footway(site, round);
  for (const Side& side : sides) {
    const Vec gate = point_along(side.front, length_of(side.front) * site.rng.between(0.4, 0.6));
    const StreetKind kind = site.network.lines[side.line].kind;
    if (kind == StreetKind::avenue || is_walled(site.network, side) || site.features.no_streets) continue;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < stations.size(); ++i)
      if (distance(stations[i], gate) < distance(stations[nearest], gate)) nearest = i;
    const Vec to = stations[nearest];
    const Vec bow = mix(gate, to, 0.5) + left_of(unit(to - gate)) * site.rng.between(-2, 2);
    const NodeId street = join_street(site.network, site.map, face, side.line, gate);
    const NodeId entry = site.map.node(gate);
    if (!contains(lawn, bow)) continue;
    draw_footway(site, {street, entry, site.map.node(bow)});
    Tags tags{{"highway", has_steps ? "footway" : "steps"}, {"width", "2.0"}};
    if (!has_steps) tags.emplace_back("step_count", "12");
    draw_way(site, {site.map.node(bow), round[nearest]}, tags);
    has_steps = true;
  }
}

}  // namespace

void build_park(Site& site, std::size_t face) {
  const auto sides = facade_sides(site.network, face, {0, kWallSetback}, 0);
  const Ring lawn = ring_of(sides);
  if (sides.empty() || !is_simple(lawn)) return;
  site.map.closed_way(site.map.nodes_of(lawn), {{"leisure", "park"}, {"name", "Stadtpark Čapka"}});
  const Vec middle = centroid_of(lawn);
  const double radius = std::min(14.0, distance_to_ring(middle, lawn) / 2);
  if (radius > 3) {
    site.sights |= kPark;
    site.map.closed_way(site.map.nodes_of(blob(site.rng, middle, radius, 14)),
                        {{"natural", "water"}, {"water", "pond"}, {"name", "Schwanenteich"}});
    draw_paths(site, lawn, sides, face, middle, radius);
  }
  for (int i = 0; i < 60; ++i) {
    const double turn = site.rng.unit(), reach = site.rng.between(radius * 1.8, 50);
    const Vec at = middle + direction_of_turn(turn) * reach;
    if (!contains_with_margin(lawn, at, 3)) continue;
    const double height = site.rng.between(6, 22);
    if (i % 8 == 0)
      site.map.point(at, {{"amenity", "bench"}});
    else
      site.map.point(at, {{"natural", "tree"}, {"height", number_text(height)}, {"leaf_type", "broadleaved"}});
  }
  // a railing just inside the longest side, open in the middle
  const Side& longest = *std::max_element(
      sides.begin(), sides.end(), [](const Side& a, const Side& b) { return length_of(a.front) < length_of(b.front); });
  const double size = length_of(longest.front);
  for (const auto& [from, to] : {std::pair{0.08, 0.38}, std::pair{0.62, 0.92}}) {
    Polyline rail;
    for (int i = 0; i <= 4; ++i) rail.push_back(point_along(longest.front, size * (from + (to - from) * i / 4)));
    site.map.way(site.map.nodes_of(offset_left(rail, 0.8)), {{"barrier", "fence"}, {"height", "1.1"}});
  }
}

}  // namespace vicus::town
