#include <algorithm>

#include "sectorgen/town/site.hpp"

/// What lies behind the rows: paths from the passages, rear houses, trees, sheds.
namespace vicus::town {

namespace {

/// A place inside the court from which the paths go out: the best of a small grid by distance to the walls.
Vec heart_of(const Ring& court, double& clearance) {
  Vec low = court[0], high = court[0];
  for (const Vec p : court) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr int kGrid = 7;
  Vec best = court[0];
  clearance = 0;
  for (int i = 1; i < kGrid; ++i)
    for (int j = 1; j < kGrid; ++j) {
      const Vec p{low.x + (high.x - low.x) * i / kGrid, low.y + (high.y - low.y) * j / kGrid};
      const double c = contains(court, p) ? distance_to_ring(p, court) : 0;
      if (c > clearance) clearance = c, best = p;
    }
  return best;
}

void draw_passage(Site& site, const Passage& p, const Ring& court, Vec heart, std::size_t face) {
  site.sights |= kPassage;
  const NodeId street = join_street(site.network, site.map, face, p.line, p.outer);
  const NodeId outer = site.map.node(p.outer), inner = site.map.node(p.inner);
  const bool is_drive = site.rng.chance(0.4);
  const Tags more = is_drive ? Tags{{"service", "driveway"}} : Tags{};
  draw_footway(site, {street, outer}, more);
  Tags tunnel = more;
  tunnel.insert(tunnel.end(), {{"tunnel", "building_passage"}, {"width", is_drive ? "3.0" : "2.5"}});
  if (site.rng.chance(0.5)) tunnel.emplace_back("maxheight", "2.8");
  draw_footway(site, {outer, inner}, tunnel);
  const Vec inside = p.inner + p.inward * 1.5;
  std::vector<NodeId> path{inner};
  if (!meets_ring(court, inside, heart)) {
    path.push_back(site.map.node(inside));
    path.push_back(site.map.node(heart));
  } else {
    path.push_back(site.map.node(p.inner + p.inward * 2.5));
  }
  draw_footway(site, path, more);
}

void build_rear_house(Site& site, const Ring& court, Vec heart, double clearance) {
  Vec along;
  width_of_convex(court, along);
  const Ring house = rectangle(heart, along, clearance * 0.55, clearance * 0.4);
  for (const Vec p : house)
    if (!contains_with_margin(court, p, 2)) return;
  build_other(site, house, {{"building", "outbuilding"}, {"building:levels", "1"}, {"roof:shape", "skillion"}});
}

}  // namespace

void lay_out_courtyard(Site& site, const Ring& court, const std::vector<Passage>& passages, std::size_t face) {
  double clearance = 0;
  const Vec heart = heart_of(court, clearance);
  const bool has_street = face != Edge::kNoFace && !passages.empty() && !site.features.no_streets;
  if (has_street)
    for (const Passage& p : passages) draw_passage(site, p, court, heart, face);
  else if (clearance > 6.5 && site.rng.chance(0.6))
    return build_rear_house(site, court, heart, clearance);
  Ring green;
  if (site.rng.chance(0.3) && clearance > 3) {
    for (int i = 0; i < 8; ++i) green.push_back(heart + direction_of_turn(i / 8.0) * (clearance * 0.7));
    site.map.closed_way(site.map.nodes_of(green), {{"landuse", "grass"}});
  }
  for (int i = 0; i < 4 && clearance > 2; ++i) {
    const double turn = site.rng.unit(), reach = clearance * site.rng.between(0.3, 1.3);
    const Vec at = heart + direction_of_turn(turn) * reach;
    if (contains_with_margin(court, at, 1.2)) site.map.point(at, {{"natural", "tree"}});
  }
}

}  // namespace vicus::town
