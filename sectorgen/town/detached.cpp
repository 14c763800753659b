#include <algorithm>

#include "sectorgen/town/site.hpp"

/// Houses that stand free in their gardens, with gaps, fences and sheds.
namespace vicus::town {

namespace {

constexpr double kFromCorner = 8;  // m

struct Garden {
  Ring outline;
  std::vector<Ring> built;  ///< convex
};

bool is_free(const Garden& garden, const Ring& ring, double margin) {
  for (const Vec p : ring)
    if (!garden.outline.empty() && !contains_with_margin(garden.outline, p, margin)) return false;
  return std::none_of(garden.built.begin(), garden.built.end(),
                      [&](const Ring& other) { return convex_rings_meet(ring, other); });
}

Ring grown(Vec at, Vec along, double half_long, double half_wide) {
  return rectangle(at, along, half_long + 1.5, half_wide + 1.5);
}

/// An L: the rectangle less its rear right quarter.
Ring angle_house(Vec at, Vec along, double a, double b) {
  const Vec u = along * a, v = left_of(along) * b;
  return {at - u - v, at + u - v, at + u, at, at + v, at - u + v};
}

void build_fence(Site& site, Vec from, Vec to, Vec inward, double depth) {
  const Vec gate = mix(from, to, 0.5);
  const NodeId gate_node = site.map.node(gate);
  site.map.tag_node(gate_node, {{"barrier", "gate"}});
  std::vector<NodeId> nodes{site.map.node(from), gate_node, site.map.node(to)};
  if (depth > 0) nodes.push_back(site.map.node(to + inward * depth));
  site.map.way(std::move(nodes), {{"barrier", site.rng.chance(0.8) ? "fence" : "hedge"}, {"height", "1.2"}});
}

/// One plot: house, perhaps shed, trees, fence.
bool build_plot(Site& site, Garden& garden, Vec front, Vec forward, double wide, const Lot& lot) {
  Rng& rng = site.rng;
  const Vec inward = left_of(forward);
  const double a = rng.between(4.2, std::min(6.0, wide / 2 - 2.2)), b = rng.between(3.8, 5.8);
  const double setback = rng.between(3, 7);
  const Vec turned = unit(forward + inward * rng.between(-0.05, 0.05));
  const Vec at = front + inward * (setback + b) + forward * rng.between(-0.8, 0.8);
  const Ring block = grown(at, turned, a, b);
  if (!is_free(garden, block, 1)) return true;
  const bool is_angle = rng.chance(0.3);
  if (!build_house(site, is_angle ? angle_house(at, turned, a, b) : rectangle(at, turned, a, b), lot)) return false;
  garden.built.push_back(block);
  const Vec shed_at = at + inward * (b + 6) + forward * (a * 0.4);
  const Ring shed = rectangle(shed_at, turned, 2, 1.6);
  if (rng.chance(0.35) && is_free(garden, shed, 2)) {
    build_other(site, shed, {{"building", rng.chance(0.5) ? "shed" : "garage"}});
    garden.built.push_back(grown(shed_at, turned, 2, 1.6));
  }
  if (rng.chance(0.6)) {
    const Vec half = forward * (wide / 2 - 0.6), off = inward * 0.4;
    const double depth = rng.chance(0.5) ? setback + 2 * b : 0;
    const Vec back = front + half + off + inward * depth;
    if (garden.outline.empty() || contains_with_margin(garden.outline, back, 1.5))
      build_fence(site, front - half + off, front + half + off, inward, depth);
  }
  for (int i = 0; i < 2; ++i) {
    const double deep = b + rng.between(2, 10), aside = rng.between(-wide / 2, wide / 2);
    const Vec tree = at + inward * deep + forward * aside;
    const Ring room = rectangle(tree, {1, 0}, 1, 1);
    if (is_free(garden, room, 2))
      site.map.point(tree, {{"natural", "tree"}, {"height", number_text(rng.between(4, 14))}});
  }
  return true;
}

void build_side(Site& site, Garden& garden, const Side& side) {
  const double size = length_of(side.front);
  double at = kFromCorner;
  while (site.houses_left > 0) {
    const double wide = site.rng.between(15, 24);
    if (at + wide > size - kFromCorner) return;
    Vec forward;
    const Vec front = point_along(side.front, at + wide / 2, &forward);
    const double m = side.first_m + (side.last_m - side.first_m) * (at + wide / 2) / size;
    build_plot(site, garden, front, forward, wide,
               {side.line, 2 * static_cast<int>(m / 6) + (side.is_left ? 1 : 2), false});
    at += wide + (site.rng.chance(0.15) ? site.rng.between(5, 15) : 0);
  }
}

}  // namespace

void build_detached(Site& site, std::size_t face) {
  const auto sides = facade_sides(site.network, face, {0.8, kWallSetback}, site.rng.next());
  if (sides.empty()) return;
  Garden garden;
  garden.outline = ring_of(sides);
  if (!is_simple(garden.outline)) return;
  const bool has_dead_end = !site.features.no_streets && area_of(garden.outline) > 3'500;
  if (has_dead_end) draw_dead_end(site, face, sides, garden.outline, garden.built);
  for (const Side& side : sides)
    if (site.network.lines[side.line].kind != StreetKind::border) build_side(site, garden, side);
}

void build_along(Site& site, const Polyline& street, std::size_t line) {
  Garden garden;
  Polyline back(street.rbegin(), street.rend());
  const double half = site.network.lines[line].half_width + 1;
  for (const bool is_left : {true, false}) {
    Side side;
    side.front = offset_left(is_left ? street : back, half);
    side.line = line;
    side.is_left = is_left;
    side.last_m = length_of(street);
    if (!is_left) std::swap(side.first_m, side.last_m);
    build_side(site, garden, side);
  }
}

}  // namespace vicus::town
