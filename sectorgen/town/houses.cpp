#include <algorithm>

#include "sectorgen/town/site.hpp"

/// What is written on houses: their kind, heights, roofs, colours, numbers, doors, shops, rooms.
namespace vicus::town {

namespace {

constexpr const char* kRoofs[] = {"gabled", "gabled", "gabled", "hipped", "mansard", "half-hipped", "skillion", "flat"};
constexpr const char* kWallColours[] = {"#e8d8b0", "#f1e3c6", "#d9a66c", "#c8d5b9", "#e6b8a2",
                                        "#b7c9d8", "#f4f0e6", "#d8c27a", "beige",   "#cc7755"};
constexpr const char* kRoofColours[] = {"#a0442c", "#8c3b2a", "#b5533c", "#6e6e70", "#99503a", "brown"};
constexpr const char* kShops[] = {"bakery", "butcher", "books", "clothes", "shoes", "greengrocer", "florist", "tailor"};
constexpr const char* kShopNames[] = {"Bäckerei Mohn",  "U Zlatého klíče", "Papier & Feder", "Wollstube",
                                      "Am <alten> Eck", "Žlutý dům",       "Kräuter-Kammer", "Zum \"Blauen Hecht\""};

template <class List>
const char* pick(Rng& rng, const List& list) {
  return list[rng.below(std::size(list))];
}

void add_roof(Rng& rng, bool is_core, int levels, Tags& tags) {
  if (rng.chance(0.75)) tags.emplace_back("roof:shape", pick(rng, kRoofs));
  if (rng.chance(0.3)) tags.emplace_back("roof:levels", rng.chance(0.3) ? "2" : "1");
  if (rng.chance(0.5)) tags.emplace_back("roof:colour", pick(rng, kRoofColours));
  if (rng.chance(0.25)) tags.emplace_back("roof:material", "roof_tiles");
  const double storey = rng.between(3.0, 3.6), roof = rng.between(2.5, 5);
  if (rng.chance(is_core ? 0.45 : 0.25)) tags.emplace_back("height", number_text(levels * storey + roof));
}

}  // namespace

std::string number_text(double value) {
  const auto tenths = static_cast<long long>(value * 10 + 0.5);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

Tags house_tags(Site& site, const Lot& lot) {
  Rng& rng = site.rng;
  Tags tags;
  if (!lot.is_long && rng.chance(0.12)) {  // a map knows nothing of some houses
    tags.emplace_back("building", "yes");
    return tags;
  }
  const int levels = lot.is_core ? 2 + static_cast<int>(rng.below(4)) : 1 + static_cast<int>(rng.below(2));
  const double kind = rng.unit();
  tags.emplace_back("building", lot.is_long    ? "palace"
                                : !lot.is_core ? (kind < 0.8 ? "detached" : "house")
                                : kind < 0.45  ? "house"
                                : kind < 0.75  ? "apartments"
                                : kind < 0.85  ? "residential"
                                               : "yes");
  if (rng.chance(0.8)) tags.emplace_back("building:levels", std::to_string(levels));
  add_roof(rng, lot.is_core, levels, tags);
  if (rng.chance(0.55)) tags.emplace_back("building:colour", pick(rng, kWallColours));
  if (rng.chance(0.15)) tags.emplace_back("building:material", rng.chance(0.5) ? "plaster" : "brick");
  if (lot.number > 0 && lot.line < site.network.lines.size()) {
    const std::string& street = site.network.lines[lot.line].name;
    tags.emplace_back("addr:housenumber", std::to_string(lot.number));
    if (!street.empty()) tags.emplace_back("addr:street", street);
  }
  return tags;
}

bool build_house(Site& site, const Ring& ring, const Lot& lot, const Ring& light_well) {
  if (site.houses_left <= 0) return false;
  --site.houses_left;
  ++site.counts.houses;
  ++site.counts.buildings;
  std::vector<NodeId> nodes = site.map.nodes_of(ring);
  if (site.rng.chance(0.3)) {  // a door in the front
    const NodeId door = site.map.node(mix(ring[0], ring[1], 0.4));
    if (nodes[1] != door && nodes[0] != door) {
      site.map.tag_node(door, {{"entrance", site.rng.chance(0.6) ? "main" : "yes"}, {"door", "hinged"}});
      nodes.insert(nodes.begin() + 1, door);
    }
  }
  Tags tags = house_tags(site, lot);
  if (site.counts.houses == 7) tags.emplace_back("name", "Zum <Löwen> & Co");
  if (light_well.empty()) {
    site.map.closed_way(std::move(nodes), std::move(tags));
    return true;
  }
  const std::uint32_t outer = site.map.closed_way(std::move(nodes), {});
  Ring inner = light_well;
  std::reverse(inner.begin(), inner.end());
  const std::uint32_t hole = site.map.closed_way(site.map.nodes_of(inner), {});
  tags.insert(tags.begin(), {"type", "multipolygon"});
  site.map.relation({{'w', outer, "outer"}, {'w', hole, "inner"}}, std::move(tags));
  return true;
}

std::uint32_t build_other(Site& site, const Ring& ring, Tags tags) {
  ++site.counts.buildings;
  return site.map.closed_way(site.map.nodes_of(ring), std::move(tags));
}

void open_shop(Site& site, Vec at) {
  const bool is_special = site.special_shops++ % 20 == 0;
  const char* name = is_special ? "\"Zum <Löwen> & Co\"" : pick(site.rng, kShopNames);
  Tags tags{{"name", name}};
  if (site.rng.chance(0.25))
    tags.emplace_back("amenity", site.rng.chance(0.5) ? "restaurant" : "cafe");
  else
    tags.emplace_back("shop", is_special ? "tailor" : pick(site.rng, kShops));
  if (site.rng.chance(0.3)) tags.emplace_back("opening_hours", "Mo-Fr 09:00-18:00");
  site.map.point(at, std::move(tags));
}

/// A corridor from the street to the yard, two rooms left and one right, doors between.
void furnish_house(Site& site, const Ring& quad, const Lot&) {
  if (distance(quad[0], quad[1]) < 8.5 || distance(quad[1], quad[2]) < 9) return;
  ++site.interiors;
  const auto at = [&](double across, double deep) {
    return mix(mix(quad[0], quad[1], across), mix(quad[3], quad[2], across), deep);
  };
  const auto room = [&](double x0, double x1, double y0, double y1, const char* kind, const char* name) {
    Tags tags{{"indoor", kind}, {"level", "0"}};
    if (*name) tags.emplace_back("name", name);
    std::vector<NodeId> nodes = site.map.nodes_of({at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)});
    site.map.closed_way(std::move(nodes), std::move(tags));
  };
  const auto door = [&](double x, double y) {
    site.map.tag_node(site.map.node(at(x, y)), {{"indoor", "door"}, {"door", "hinged"}, {"level", "0"}});
  };
  room(0.40, 0.58, 0.04, 0.96, "corridor", "");
  room(0.05, 0.38, 0.04, 0.50, "room", "Werkstatt");
  room(0.05, 0.38, 0.54, 0.96, "room", "Küche");
  room(0.60, 0.95, 0.04, 0.96, "room", "Gewölbe");
  door(0.49, 0.04);
  door(0.49, 0.96);
  door(0.40, 0.3);
  door(0.40, 0.7);
  door(0.58, 0.5);
}

}  // namespace vicus::town
