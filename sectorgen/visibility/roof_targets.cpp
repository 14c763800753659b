#include "sectorgen/visibility/roof_targets.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <unordered_map>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/visibility/ground_targets.hpp"

namespace vicus {
namespace {

struct FacadeEdge {
  PlanPoint a, b;  // house on the left
  std::uint32_t house, sector;
  auto key() const { return std::tie(a, b, house); }
};

std::vector<FacadeEdge> facade_edges(const City& city, const std::unordered_map<std::string, std::uint32_t>& sectors) {
  std::unordered_map<std::string, std::uint32_t> houses;
  for (std::uint32_t h = 0; h < city.buildings.size(); ++h) houses.emplace(city.buildings[h].id, h);
  std::vector<FacadeEdge> edges;
  for (const auto& border : city.borders) {
    if (border.kind != BorderKind::facade) continue;
    const auto house = houses.find(border.building_id);
    const auto sector = sectors.find(border.sector_id);
    if (house == houses.end() || sector == sectors.end()) continue;
    for (std::size_t i = 0; i + 1 < border.line.size(); ++i)
      edges.push_back({border.line[i + 1], border.line[i], house->second, sector->second});
  }
  std::sort(edges.begin(), edges.end(), [](const auto& x, const auto& y) { return x.key() < y.key(); });
  return edges;
}

}  // namespace

SegmentNode disc_around(const SightSegment* first, const SightSegment* last) {
  Spot low = first->a, high = first->a;
  for (const SightSegment* s = first; s != last; ++s)
    for (const Spot p : {s->a, s->b}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  SegmentNode node;
  node.centre = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  for (const SightSegment* s = first; s != last; ++s)
    for (const Spot p : {s->a, s->b})
      node.radius = std::max(node.radius, std::hypot(p.x - node.centre.x, p.y - node.centre.y));
  return node;
}

std::uint32_t add_chain(SegmentTree& tree, std::uint32_t first, std::uint32_t last, std::uint32_t house) {
  SegmentNode node = disc_around(&tree.segments[first], &tree.segments[0] + last);
  node.house = house;
  if (last - first == 1) {
    node.segment = first;
    node.top_m = std::max(tree.segments[first].up_a, tree.segments[first].up_b);
    node.low_m = std::min(tree.segments[first].up_a, tree.segments[first].up_b);
  } else {
    const std::uint32_t middle = first + (last - first) / 2;
    node.left = add_chain(tree, first, middle, house);
    node.right = add_chain(tree, middle, last, house);
    node.top_m = std::max(tree.nodes[node.left].top_m, tree.nodes[node.right].top_m);
    node.low_m = std::min(tree.nodes[node.left].low_m, tree.nodes[node.right].low_m);
  }
  tree.nodes.push_back(node);
  return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

std::uint32_t join_trees(SegmentTree& tree, std::vector<std::uint32_t>& roots) {
  const auto join = [&](const auto& self, std::size_t first, std::size_t last) -> std::uint32_t {
    if (last - first == 1) return roots[first];
    Spot low = tree.nodes[roots[first]].centre, high = low;
    for (std::size_t i = first; i < last; ++i) {
      const Spot c = tree.nodes[roots[i]].centre;
      low = {std::min(low.x, c.x), std::min(low.y, c.y)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
    const bool is_wide = high.x - low.x > high.y - low.y;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return roots.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
      const Spot p = tree.nodes[a].centre, q = tree.nodes[b].centre;
      return is_wide ? std::tie(p.x, p.y, a) < std::tie(q.x, q.y, b) : std::tie(p.y, p.x, a) < std::tie(q.y, q.x, b);
    });
    SegmentNode node;
    node.left = self(self, first, middle);
    node.right = self(self, middle, last);
    const SegmentNode &l = tree.nodes[node.left], &r = tree.nodes[node.right];
    node.top_m = std::max(l.top_m, r.top_m);
    node.low_m = std::min(l.low_m, r.low_m);
    // The smallest disc around two discs.
    const double dx = r.centre.x - l.centre.x, dy = r.centre.y - l.centre.y, apart = std::hypot(dx, dy);
    if (apart + r.radius <= l.radius) {
      node.centre = l.centre, node.radius = l.radius;
    } else if (apart + l.radius <= r.radius) {
      node.centre = r.centre, node.radius = r.radius;
    } else {
      node.radius = (apart + l.radius + r.radius) / 2;
      const double share = (node.radius - l.radius) / apart;
      node.centre = {l.centre.x + share * dx, l.centre.y + share * dy};
    }
    tree.nodes.push_back(node);
    return static_cast<std::uint32_t>(tree.nodes.size() - 1);
  };
  return roots.empty() ? kNowhere : join(join, 0, roots.size());
}

RoofTargets make_roof_targets(const City& city, const HouseWalls& walls, double least_m) {
  std::unordered_map<std::string, std::uint32_t> sectors;
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) sectors.emplace(city.sectors[s].id, s);
  const std::vector<FacadeEdge> facades = facade_edges(city, sectors);
  RoofTargets targets;
  const bool is_flat = city.terrain.height_mm.empty();
  std::vector<std::uint32_t> roots;
  for (std::uint32_t h = 0; h < city.buildings.size(); ++h) {
    const Building& building = city.buildings[h];
    if (building.height_m < least_m) continue;
    const HouseBody& body = walls.houses()[h];
    const double above_eyes_m = body.most_zero_m + kStopsSight_m;  // on flat ground
    const auto owner_sector = sectors.find(building.sector_id);
    const std::uint32_t owner = owner_sector == sectors.end() ? kNowhere : owner_sector->second;
    const auto first_showing = static_cast<std::uint32_t>(targets.showings.size());
    const auto first_segment = static_cast<std::uint32_t>(targets.tree.segments.size());
    const auto add = [&](Spot a, Spot b, double up_a, double up_b, std::uint32_t sector, bool is_wall) {
      if (sector == kNowhere) return;
      std::uint32_t i = first_showing;
      while (i < targets.showings.size() && targets.showings[i].sector != sector) ++i;
      if (i == targets.showings.size()) targets.showings.push_back({sector, h, sector == owner});
      targets.showing.push_back(i);
      targets.is_wall.push_back(is_wall);
      targets.tree.segments.push_back({a, b, std::max(up_a, above_eyes_m), std::max(up_b, above_eyes_m)});
    };
    std::uint32_t wall = body.first_wall;
    const auto add_ring = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i, ++wall) {
        const HouseWall& w = walls.walls()[wall];
        if (is_flat && w.beyond_m >= std::max(body.most_eave_m, above_eyes_m)) continue;
        const FacadeEdge key{ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], h, 0};
        const auto found = std::lower_bound(facades.begin(), facades.end(), key,
                                            [](const auto& x, const auto& y) { return x.key() < y.key(); });
        const bool is_facade = found != facades.end() && found->key() == key.key();
        add(w.a, w.b, body.most_eave_m, body.most_eave_m, is_facade ? found->sector : owner, true);
      }
    };
    add_ring(building.footprint.outer);
    for (const auto& hole : building.footprint.holes) add_ring(hole);
    const bool has_roof = body.first_triangle != body.last_triangle;
    if (!is_flat || has_roof || building.height_m > building.eave_m)
      for (const RoofEdge& e : roof_edges(building, has_roof, !is_flat))
        add(e.a, e.b, body.most_zero_m + e.up_a, body.most_zero_m + e.up_b, owner, false);
    const auto last_segment = static_cast<std::uint32_t>(targets.tree.segments.size());
    if (last_segment > first_segment) roots.push_back(add_chain(targets.tree, first_segment, last_segment, h));
  }
  targets.houses = static_cast<std::uint32_t>(city.buildings.size());
  if (least_m <= 0) add_ground_targets(city, targets.houses, targets, roots);
  targets.tree.root = join_trees(targets.tree, roots);
  return targets;
}

SegmentTree rim_of(const Sector& sector) {
  SegmentTree tree;
  std::vector<std::uint32_t> roots;
  const auto add = [&](const Ring& ring) {
    const auto first = static_cast<std::uint32_t>(tree.segments.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
      tree.segments.push_back({spot_of(ring[i]), spot_of(ring[i + 1 == ring.size() ? 0 : i + 1])});
    const auto last = static_cast<std::uint32_t>(tree.segments.size());
    roots.push_back(add_chain(tree, first, last, kNowhere));
  };
  add(sector.ground.outer);
  for (const auto& hole : sector.ground.holes) add(hole);
  tree.root = join_trees(tree, roots);
  return tree;
}

}  // namespace vicus
