#include "sectorgen/town/site.hpp"

/// Hard geometry, one scene per feature, side by side north of a road:
///
///   town ---+-----------+--------------+-----
namespace vicus::town {

namespace {

constexpr double kGap = 40;  // m between scenes

struct Road {
  Site& site;
  Vec at;  ///< where the next scene begins
  std::vector<NodeId> nodes;

  /// A place east of the scene's beginning and north of the road; on the road itself it becomes a node of it.
  Vec place(double east, double north) const { return at + Vec{east, north}; }
  NodeId stop(double east) {
    nodes.push_back(site.map.node(place(east, 0)));
    return nodes.back();
  }
};

Ring box(const Road& road, double west, double south, double wide, double deep) {
  return {road.place(west, south), road.place(west + wide, south), road.place(west + wide, south + deep),
          road.place(west, south + deep)};
}

void house(Road& road, const Ring& ring) { build_other(road.site, ring, house_tags(road.site, {})); }

/// Nodes of its own, even where its neighbour has some: as two surveyors would draw them.
void stranger(Road& road, const Ring& ring, int steps_east) {
  std::vector<NodeId> nodes;
  for (const Vec p : ring) nodes.push_back(road.site.map.separate_node(p, steps_east));
  ++road.site.counts.buildings;
  road.site.map.closed_way(std::move(nodes), house_tags(road.site, {}));
}

void street(Road& road, const Polyline& line, const char* kind = "residential", NodeId first = 0) {
  std::vector<NodeId> nodes = road.site.map.nodes_of(line);
  if (first) nodes.front() = first;
  draw_way(road.site, std::move(nodes), {{"highway", kind}, {"name", road.site.names.street(road.site.rng)}});
}

/// Pairs side by side: same wall twice, one step apart, one step into each other, half the wall, corner to corner,
/// and an alley of 5 cm.
double zero_width_alley(Road& road) {
  const double south = 12;
  struct Pair {
    double gap;
    int steps;
    double shift;
  };
  constexpr Pair kPairs[] = {{0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 4}, {0, 0, 11}, {0.05, 0, 0}};
  double east = 0;
  for (const Pair& p : kPairs) {
    house(road, box(road, east, south, 9, 11));
    stranger(road, box(road, east + 9 + p.gap, south + p.shift, 8, 11), p.steps);
    east += 17 + p.gap + road.site.rng.between(1.5, 5);
  }
  road.stop(0);
  return east;
}

/// Side streets left of a street, none opposite another, houses in the teeth.
double comb(Road& road) {
  const NodeId foot = road.stop(0);
  std::vector<Vec> stem{road.place(0, 0)};
  for (int i = 0; i < 6; ++i) {
    const double north = 24 + 17.0 * i + road.site.rng.between(-2, 2);
    const double side = i % 2 ? -1 : 1;
    stem.push_back(road.place(0, north));
    street(road, {stem.back(), road.place(side * 34, north + road.site.rng.between(-1, 1))});
    for (const double east : {5.0, 15.0}) house(road, box(road, side > 0 ? east : -east - 9, north + 4.5, 9, 8));
  }
  stem.push_back(road.place(0, 135));
  street(road, stem, "residential", foot);
  return 40;
}

/// Streets that meet in one point between houses as sharp as knives; every second pair of tips is one point.
double star(Road& road) {
  const int arms = 5 + static_cast<int>(road.site.rng.below(4));
  const Vec middle = road.place(0, 50);
  const double turn = 0.75;  // the first arm comes from the road
  street(road, {middle, road.place(0, 0)});
  road.stop(0);
  for (int i = 0; i < arms; ++i) {
    const double from = turn + i / static_cast<double>(arms), step = 1.0 / arms;
    const Vec a = direction_of_turn(from), b = direction_of_turn(from + step), m = direction_of_turn(from + step / 2);
    if (i > 0) street(road, {middle, middle + a * 42});
    const double half_width = i % 2 ? 1.5 : 3.0, sine = sine_of_turn(step / 2);
    const Vec tip = middle + m * (half_width / sine);
    house(road, {tip, tip + a * 24, tip + b * 24});
  }
  // two sharp houses, tips in one point: a gate on either side ends there
  const Vec point = road.place(60, 50);
  house(road, {point, point + Vec{-6, 22}, point + Vec{-14, 18}});
  house(road, {point, point + Vec{14, -18}, point + Vec{6, -22}});
  street(road, {road.place(82, 0), road.place(82, 90)});
  road.stop(82);
  return 100;
}

/// Two long streets at a degree or two, a thin row between, rows outside.
double parallel_streets(Road& road) {
  const double size = road.site.rng.between(180, 260), spread = size * road.site.rng.between(0.017, 0.035);
  const Vec a = road.place(0, 20), b = road.place(size, 20), c = road.place(0, 33), d = road.place(size, 33 + spread);
  const NodeId west = road.stop(-8);
  street(road, {road.place(-8, 0), a, b});
  street(road, {road.place(-8, 0), c, d}, "residential", west);
  const auto row = [&](Vec from, Vec to, double near, double far_west, double far_east, int count) {
    const Vec up = left_of(unit(to - from));
    for (int i = 0; i < count; ++i) {
      const double s = 0.05 + 0.9 * i / count, t = 0.05 + 0.9 * (i + 1) / count;
      const double fs = far_west + (far_east - far_west) * s, ft = far_west + (far_east - far_west) * t;
      house(road, {mix(from, to, s) + up * near, mix(from, to, t) + up * near, mix(from, to, t) + up * ft,
                   mix(from, to, s) + up * fs});
    }
  };
  row(a, b, 4, 8.5, 8.5 + spread, static_cast<int>(size / 11));
  row(c, d, 4.5, 14, 13, static_cast<int>(size / 9));
  row(b, a, 4, 11, 12, static_cast<int>(size / 10));
  return size;
}

/// A square like a U with an island in its base.
double concave_square(Road& road) {
  const Ring u = {road.place(0, 12),  road.place(60, 12), road.place(60, 58), road.place(42, 58),
                  road.place(42, 36), road.place(20, 36), road.place(20, 58), road.place(0, 58)};
  Tags tags{{"place", "square"}, {"name", "Dreiecksmarkt"}};
  if (!road.site.features.no_streets) tags.insert(tags.end(), {{"highway", "pedestrian"}, {"area", "yes"}});
  road.site.map.closed_way(road.site.map.nodes_of(u), tags);
  for (const double west : {20.0, 31.0}) {
    house(road, box(road, west, 36, 11, 11));
    house(road, box(road, west, 47, 11, 11));
  }
  for (const double south : {12.0, 27.0, 42.0}) {
    house(road, box(road, -11, south, 11, south == 42 ? 15.5 : 15));
    house(road, box(road, 60, south, 11, 14));
  }
  house(road, box(road, 24, 19, 7, 8));
  house(road, box(road, 31, 19, 7, 8));
  road.stop(12);
  street(road, {road.place(12, 0), road.place(12, 12), road.place(12, 24)});
  return 75;
}

/// Streets that end in a court, at a wall, in a field, and one that begins nowhere too.
double dead_ends(Road& road) {
  road.stop(0);
  street(road, {road.place(0, 0), road.place(0, 40)});
  house(road, {road.place(-12, 20), road.place(-4, 20), road.place(-4, 46), road.place(4, 46), road.place(4, 20),
               road.place(12, 20), road.place(12, 55), road.place(-12, 55)});
  road.stop(30);
  street(road, {road.place(30, 0), road.place(30, 25)});
  house(road, box(road, 24, 25, 12, 9));
  road.stop(60);
  street(road, {road.place(60, 0), road.place(62, 45), road.place(70, 80)});
  house(road, box(road, 47, 20, 9, 9));
  street(road, {road.place(30, 70), road.place(48, 95)});
  return 75;
}

}  // namespace

void build_scenes(Site& site) {
  const TownFeatures& f = site.features;
  const Outlet outlet = outlet_of(site, {1, 0});
  Road road{site, outlet.at + Vec{60, 0}, {outlet.node}};
  const auto add = [&](bool is_wanted, double (*scene)(Road&), double room_west) {
    if (!is_wanted) return;
    road.at.x += room_west;
    road.at.x += scene(road) + kGap;
  };
  add(f.zero_width_alley, zero_width_alley, 0);
  add(f.t_junctions, comb, 40);
  add(f.touching_gates, star, 45);
  add(f.parallel_streets, parallel_streets, 10);
  add(f.concave_square, concave_square, 12);
  add(f.dead_end, dead_ends, 15);
  draw_way(site, std::move(road.nodes),
           {{"highway", "unclassified"}, {"name", site.names.street(site.rng)}, {"width", "5.5"}});
}

}  // namespace vicus::town
