#include <algorithm>

#include "sectorgen/town/site.hpp"

/// Which streets a town has, and which of its blocks are squares, parks, rows and gardens.
namespace vicus::town {

namespace {

constexpr double kCorePerHouse = 185, kRimPerHouse = 800;  // m2 of ground, streets included; measured
constexpr double kCoreShare = 0.8;                         // of the houses stand in rows
constexpr int kWholeTown = 200;                            // houses from which a town has a core of its own

double core_radius(int houses) {
  constexpr double extra = 21'000;  // squares, park, palace
  return std::sqrt((kCoreShare * houses * kCorePerHouse + extra) / 2.75);
}

double radius_for(int houses, bool is_whole) {
  if (!is_whole) return std::sqrt((houses * 165.0 + 3'000) / 2.4);
  const double core = core_radius(houses);
  return std::sqrt(core * core * 1.25 + houses * 0.3 * kRimPerHouse / 2.6) + 20;
}

Line make_line(Site& site, StreetKind kind) {
  Line line;
  line.kind = kind;
  Rng& r = site.rng;
  switch (kind) {
    case StreetKind::border:
      line.half_width = 1;
      break;
    case StreetKind::lane:
      line.half_width = r.between(1.05, 1.45);
      break;
    case StreetKind::street:
      line.half_width = r.between(3.2, 4.6);
      break;
    case StreetKind::main:
      line.half_width = r.between(4.8, 6.2);
      break;
    case StreetKind::ring:
      line.half_width = 6;
      break;
    case StreetKind::avenue:
      line.half_width = 13;
      break;
    case StreetKind::embankment:
      line.half_width = 6;
      break;
  }
  if (kind != StreetKind::border) line.name = kind == StreetKind::lane ? site.names.lane(r) : site.names.street(r);
  line.is_steps = kind == StreetKind::lane && r.chance(0.25);
  return line;
}

/// A circle cut off by the river in the south; small towns stand on their own ring street.
void found(Site& site, double radius) {
  const bool whole = site.is_whole_town;
  Ring ring;
  std::vector<Line> lines;
  if (whole) {
    const double half = std::sqrt(radius * radius - site.river_north * site.river_north);
    ring = {{-half, site.river_north}, {half, site.river_north}};
    lines.push_back(make_line(site, StreetKind::embankment));
    for (int i = 0; i <= 8; ++i) ring.push_back(direction_of_turn(i / 16.0) * radius);
  } else if (site.features.collinear_fronts) {
    ring = rectangle({}, {1, 0}, radius, radius * 0.8);
  } else {
    const double turn = site.rng.unit();
    for (int i = 0; i < 5; ++i)
      ring.push_back(direction_of_turn(turn + (i + site.rng.between(-0.12, 0.12)) / 5.0) * radius);
  }
  for (Vec& p : ring) p = p + site.origin;
  while (lines.size() < ring.size()) lines.push_back(make_line(site, whole ? StreetKind::border : StreetKind::street));
  site.network = make_network(ring, lines);
  if (whole) site.network.faces[0].zone = Zone::rim;
}

/// Ring streets around the core, tangents to it: each cuts off one rim piece.
void carve_core(Site& site, double radius) {
  for (int i = 0; i < 5; ++i) {
    const double jitter = site.features.collinear_fronts ? 0 : site.rng.between(-0.018, 0.018);
    const Vec normal = direction_of_turn(i / 8.0 + jitter);
    const double reach = radius * site.rng.between(0.94, 1.05);
    Line line = make_line(site, i == 1 ? StreetKind::avenue : StreetKind::ring);
    cut_face(site.network, 0, site.origin + normal * reach, left_of(normal), line, {});
  }
  site.network.faces[0].zone = Zone::core;
}

/// Streets touch the market square like the arms of a windmill: each enters at a corner and passes along a side.
void carve_market(Site& site, double radius) {
  const double jitter = site.features.collinear_fronts ? 0 : site.rng.between(-0.03, 0.03);
  const Vec u = direction_of_turn(jitter), v = left_of(u);
  const double hx = std::clamp(radius * 0.27, 15.0, site.rng.between(33, 38));
  const double hy = hx * site.rng.between(0.78, 0.95);
  const Vec c = site.origin + Vec{0, radius * 0.1};
  Network& n = site.network;
  bool is_cut = cut_face(n, 0, c + v * hy, u * -1, make_line(site, StreetKind::main), {});
  is_cut = cut_face(n, 0, c + u * hx, v, make_line(site, StreetKind::main), {}) && is_cut;
  is_cut = cut_face(n, 0, c - v * hy, u, make_line(site, StreetKind::street), {}) && is_cut;
  is_cut = cut_face(n, 0, c - u * hx, v * -1, make_line(site, StreetKind::street), {}) && is_cut;
  if (!is_cut) return;
  n.faces[0].use = Use::market;
  n.faces[0].is_final = true;
}

StreetKind kind_of_cut(Site& site, double area, Zone zone) {
  if (area > 60'000) return StreetKind::main;
  if (zone == Zone::core && area < 6'500 && site.rng.chance(0.45)) return StreetKind::lane;
  return StreetKind::street;
}

/// Cuts a face across its longer extent, or leaves it when no cut suits.
bool cut_across(Site& site, std::size_t face, double area) {
  Network& n = site.network;
  const Zone zone = n.faces[face].zone;
  const Ring ring = n.ring_of(face);
  Vec along;
  width_of_convex(ring, along);
  double low = 1e30, high = -1e30;
  for (const Vec p : ring) low = std::min(low, dot(p, along)), high = std::max(high, dot(p, along));
  const Vec middle = centroid_of(ring);
  const bool is_straight = site.features.collinear_fronts;
  const Line line = make_line(site, kind_of_cut(site, area, zone));
  CutRules rules;
  rules.snap = site.features.t_junctions ? 0 : 13;
  rules.clear = 17;
  rules.min_sine = 0.8;
  rules.min_width = zone == Zone::core ? 33 : 44;
  for (int i = 0; i < 12; ++i) {
    const double share = 0.5 + site.rng.between(-0.14, 0.14);
    const Vec at = middle + along * ((low + (high - low) * share) - dot(middle, along));
    const Vec tilt = direction_of_turn(0.25 + (is_straight ? 0 : site.rng.between(-0.035, 0.035)));
    if (cut_face(n, face, at, {along.x * tilt.x - along.y * tilt.y, along.x * tilt.y + along.y * tilt.x}, line, rules))
      return true;
  }
  return false;
}

/// How many faces got a use so far: in a large town every some hundred blocks there is a square or park again.
struct Reserved {
  int seen = 0, second_squares = 0, parks = 0, palaces = 0;
};

/// Blocks that become something else than houses; the first fit is taken.
Use use_for(const Site& site, Reserved& reserved, double area, double width, Zone zone) {
  if (zone != Zone::core) return Use::open;
  const bool wants_square = site.is_whole_town || site.features.concave_square;
  const int round = reserved.seen / 300;
  if (wants_square && area < 8'000 && area > 4'000 && width > 56 && reserved.second_squares <= round)
    return ++reserved.second_squares, Use::second_square;
  if (!site.is_whole_town) return Use::open;
  if (area < 10'000 && area > 4'500 && width > 55 && reserved.parks <= round) return ++reserved.parks, Use::park;
  if (area < 3'800 && area > 1'700 && width > 38 && reserved.palaces <= round) return ++reserved.palaces, Use::palace;
  return Use::open;
}

/// The best block that has no use yet: as large as possible, but for `most` square metres.
bool give_block(Site& site, Use use, double most) {
  Face* best = nullptr;
  double best_area = 900;
  for (std::size_t f = 0; f < site.network.faces.size(); ++f) {
    Face& face = site.network.faces[f];
    if (face.zone != Zone::core || face.use != Use::open) continue;
    const Ring ring = site.network.ring_of(f);
    Vec along;
    const double area = area_of(ring);
    if (area > best_area && area < most && width_of_convex(ring, along) > 33) best_area = area, best = &face;
  }
  if (best) best->use = use;
  return best != nullptr;
}

/// The town wall stands on the ring street that most streets of the core lead to; the avenue has none.
void place_wall(Network& n) {
  std::vector<std::size_t> streets(n.lines.size());
  for (const Edge& e : n.edges) {
    const Line& ring = n.lines[e.line];
    if (ring.kind != StreetKind::ring || e.left == Edge::kNoFace || n.faces[e.left].zone != Zone::core) continue;
    for (const Edge& other : n.edges) {
      if (other.line == e.line || (other.from != e.to && other.to != e.to)) continue;
      const Vec end = n.vertices[other.from == e.to ? other.to : other.from];
      const bool has_core = other.left != Edge::kNoFace && other.right != Edge::kNoFace &&
                            n.faces[other.left].zone == Zone::core && n.faces[other.right].zone == Zone::core;
      streets[e.line] += has_core && cross(ring.to - ring.from, end - n.vertices[e.to]) > 1;
    }
  }
  const auto best = std::max_element(streets.begin(), streets.end());
  if (*best > 0) n.lines[static_cast<std::size_t>(best - streets.begin())].has_wall = true;
}

void cut_blocks(Site& site) {
  Network& n = site.network;
  Reserved reserved;
  for (std::size_t face = 0; face < n.faces.size(); ++face) {
    while (!n.faces[face].is_final) {  // the part to the right waits at the end of the list
      const Ring ring = n.ring_of(face);
      const Zone zone = n.faces[face].zone;
      const double area = area_of(ring);
      Vec along;
      const double width = width_of_convex(ring, along);
      const Use use = use_for(site, reserved, area, width, zone);
      const double most = zone == Zone::core ? site.rng.between(2'700, 4'300) : site.rng.between(5'000, 8'000);
      n.faces[face].use = use;
      if (use != Use::open || area < most || !cut_across(site, face, area)) n.faces[face].is_final = true;
      ++reserved.seen;
    }
  }
  if (!site.is_whole_town) return;
  if (reserved.second_squares == 0) give_block(site, Use::second_square, 1e9);
  if (reserved.parks == 0) give_block(site, Use::park, 1e9);
  if (reserved.palaces == 0 && !give_block(site, Use::palace, 3'300)) give_block(site, Use::palace, 1e9);
  place_wall(n);
}

}  // namespace

void lay_out(Site& site) {
  const int houses = static_cast<int>(site.houses_left * site.scale * site.scale);
  site.is_whole_town = site.houses_left >= kWholeTown;
  const double core = core_radius(houses);
  site.river_north = -0.62 * core;
  found(site, radius_for(houses, site.is_whole_town));
  if (site.is_whole_town) {
    carve_core(site, core);
    carve_market(site, core);
  } else if (houses >= 60) {
    carve_market(site, radius_for(houses, site.is_whole_town));
  }
  cut_blocks(site);
  const bool is_straight = site.features.collinear_fronts;
  bend_network(site.network, Bend(is_straight ? 0 : site.is_whole_town ? 9 : 4, site.rng.next()));
}

}  // namespace vicus::town
