#include "sectorgen/town/town.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "sectorgen/town/site.hpp"

namespace vicus {

namespace town {
namespace {

/// Blocks from the middle outwards, so that a town that runs out of houses ends at its rim.
std::vector<std::size_t> faces_from_middle(const Network& n, Vec origin) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t f = 0; f < n.faces.size(); ++f) {
    const double rank = distance(centroid_of(n.ring_of(f)), origin);
    order.emplace_back(n.faces[f].use == Use::open ? rank + (n.faces[f].zone == Zone::rim ? 1e6 : 0) : -1, f);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> faces;
  for (const auto& [rank, face] : order) faces.push_back(face);
  return faces;
}

void build_face(Site& site, std::size_t face) {
  Face& f = site.network.faces[face];
  const bool is_row = f.use == Use::open && f.zone == Zone::core && !site.features.detached;
  if (site.features.detached && (f.use == Use::second_square || f.use == Use::palace)) f.use = Use::open;
  switch (f.use) {
    case Use::market:
      return build_market(site, face);
    case Use::second_square:
      return build_second_square(site, face);
    case Use::park:
      return build_park(site, face);
    case Use::palace:
      return build_palace(site, face);
    default:
      break;
  }
  if (site.houses_left <= 0) return;
  f.use = is_row ? Use::rows : Use::detached;
  const double jitter = site.features.collinear_fronts ? 0 : 0.9;
  if (is_row && build_rows(site, facade_sides(site.network, face, {jitter, kWallSetback}, site.rng.next()), face))
    return;
  if (is_row && build_narrow_block(site, face)) return;
  build_detached(site, face);
}

void keep_streets(Network& n) {
  for (Edge& e : n.edges) {
    const StreetKind kind = n.lines[e.line].kind;
    const auto is_used = [&](std::size_t f) { return f != Edge::kNoFace && n.faces[f].use != Use::open; };
    if (kind == StreetKind::border) continue;
    const bool is_trunk = kind != StreetKind::lane && kind != StreetKind::street;
    if (is_trunk || is_used(e.left) || is_used(e.right)) e.is_kept = true;
  }
}

/// One town around site.origin.
void build_site(Site& site) {
  lay_out(site);
  if (site.is_whole_town) build_river(site);
  for (const std::size_t face : faces_from_middle(site.network, site.origin)) build_face(site, face);
  keep_streets(site.network);
  if (site.is_whole_town) build_wall(site);
  draw_streets(site);
}

enum class Outcome { whole, lacks_ground, lacks_sights };

/// One town, or villages far apart.
Outcome build_villages(const TownOptions& options, double scale, Rng& rng, OsmMap& map, TownCounts& counts) {
  Names names;
  constexpr int kVillages = 4;
  constexpr double kFarEast = 29'000, kFarNorth = 9'000;
  const int villages = options.features.huge ? kVillages : 1;
  std::optional<Site> before;
  Outcome outcome = Outcome::whole;
  for (int i = 0; i < villages; ++i) {
    Site site{map, names, counts, options.features, rng.fork(), {}, 0, scale, false, {}, 0, 0};
    if (villages > 1) site.origin = {kFarEast * (2.0 * i / (villages - 1) - 1), rng.between(-kFarNorth, kFarNorth)};
    site.houses_left = options.houses * (i + 1) / villages - options.houses * i / villages;
    build_site(site);
    if (site.houses_left > 0) return Outcome::lacks_ground;
    const unsigned dispensable =
        (site.features.t_junctions ? kCrossroads : 0) |
        (site.features.detached || site.features.no_streets ? kPassage | kIsland | kPalace : 0);
    if (site.is_whole_town && (site.sights | dispensable) != kAllSights) outcome = Outcome::lacks_sights;
    if (before) {
      const Vec east = unit(site.origin - before->origin);
      const Outlet from = outlet_of(*before, east), to = outlet_of(site, east * -1);
      draw_country_road(site, from, to);
    }
    if (i + 1 == villages) build_scenes(site);
    before.emplace(std::move(site));
  }
  return outcome;
}

}  // namespace
}  // namespace town

namespace {

/// The n-th variant of the town, on ground of the given scale.
town::Outcome try_town(const TownOptions& options, std::uint64_t variant, double scale, Town& result) {
  town::Rng rng(options.seed + variant * 0x632BE59BD9B4E019ull);
  double lat = options.lat_deg, lon = options.lon_deg;
  if (options.features.arctic) lat = 85;
  if (options.features.antimeridian) lon = 180;
  town::OsmMap map(lat, lon);
  result = {};
  const town::Outcome outcome = town::build_villages(options, scale, rng, map, result.counts);
  if (outcome == town::Outcome::lacks_ground) return outcome;
  result.counts.nodes = map.node_count();
  result.counts.ways = map.way_count();
  result.counts.relations = map.relation_count();
  result.osm = map.xml();
  return outcome;
}

}  // namespace

Town make_town(const TownOptions& options) {
  assert(options.houses >= kMinHouses && options.houses <= kMaxHouses);
  constexpr int kLarge = 1000;  // from here on the outskirts thin out: measured
  constexpr std::uint64_t kMostVariants = 40;
  double scale = options.features.detached ? 1.7 : options.houses >= kLarge ? 1.12 : 1;
  std::uint64_t variant = 0;
  for (Town town;;) {
    const town::Outcome outcome = try_town(options, variant, scale, town);
    if (outcome == town::Outcome::whole) return town;
    if (outcome == town::Outcome::lacks_ground)
      scale *= 1.12;
    else if (++variant == kMostVariants)
      return town;
  }
}

std::string make_town_osm(const TownOptions& options) { return make_town(options).osm; }

}  // namespace vicus
