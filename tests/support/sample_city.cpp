#include "tests/support/sample_city.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "city_db/facade_layout.hpp"
#include "tests/support/triangulate.hpp"

namespace vicus::test {

const char* const kAwkwardName = "\"Zum <Löwen> & Co\"";

namespace {

using Line = std::vector<PlanPoint>;

PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

/// One edge of a sector's ground, from its first point to the first point of the next side.
struct Side {
  PlanPoint from;
  std::string what;     ///< "gate", or a border's kind
  std::string other;    ///< gate: the sector behind ("" out); facade: the building
  double height_m = 0;  ///< wall, fence
  GateKind gate = GateKind::street;
};

struct SectorPlan {
  std::string id;
  SectorKind kind;
  std::string name;
  std::vector<std::string> names;
  std::vector<Side> outer, hole;
};

std::vector<SectorPlan> sector_plans() {
  const std::string lion = kAwkwardName, cross = "Kreuzgasse";
  const auto P = GateKind::passage;
  const auto O = GateKind::end_of_city;
  return {{"s-cross",
           SectorKind::crossroads,
           lion,
           {lion, cross},
           {{at(-5, -5), "gate", "s-south"},
            {at(5, -5), "gate", "s-main-e"},
            {at(5, 5), "gate", "s-north"},
            {at(-5, 5), "gate", "s-main-w"}},
           {}},
          {"s-main-e",
           SectorKind::street,
           lion,
           {lion},
           {{at(5, -5), "facade", "b-8"},
            {at(30, -5), "facade", "b-9"},
            {at(60, -5), "gate", "", 0, O},
            {at(60, 5), "facade", "b-5"},
            {at(28, 5), "gate", "s-passage", 0, P},
            {at(24, 5), "facade", "b-3"},
            {at(5, 5), "gate", "s-cross"}},
           {{at(30, -1), "edge", ""}, {at(30, 1), "edge", ""}, {at(33, 1), "edge", ""}, {at(33, -1), "edge", ""}}},
          {"s-main-w",
           SectorKind::street,
           lion,
           {lion},
           {{at(-60, -5), "facade", "b-10"},
            {at(-5, -5), "gate", "s-cross"},
            {at(-5, 5), "facade", "b-2"},
            {at(-32, 5.6), "facade", "b-1"},
            {at(-60, 5), "gate", "", 0, O}},
           {}},
          {"s-north",
           SectorKind::street,
           cross,
           {cross},
           {{at(-5, 5), "gate", "s-cross"},
            {at(5, 5), "facade", "b-3"},
            {at(5, 22), "facade", "b-6"},
            {at(5, 40), "gate", "", 0, O},
            {at(-5, 40), "facade", "b-2"}},
           {}},
          {"s-passage",
           SectorKind::passage,
           "",
           {},
           {{at(24, 5), "gate", "s-main-e", 0, P},
            {at(28, 5), "facade", "b-5"},
            {at(28, 22), "gate", "s-yard", 0, P},
            {at(24, 22), "facade", "b-3"}},
           {}},
          {"s-south",
           SectorKind::street,
           cross,
           {cross},
           {{at(-5, -39.6), "wall", "", 2.5},
            {at(5, -39.6), "fence", "", 1.8},
            {at(5, -25), "facade", "b-8"},
            {at(5, -5), "gate", "s-cross"},
            {at(-5, -5), "facade", "b-10"},
            {at(-5, -20), "bank", ""}},
           {}},
          {"s-yard",
           SectorKind::yard,
           "Löwenhof",
           {"Löwenhof"},
           {{at(12, 22), "facade", "b-3"},
            {at(24, 22), "gate", "s-passage", 0, P},
            {at(28, 22), "facade", "b-5"},
            {at(52, 22), "facade", "b-7"},
            {at(52, 36), "fence", "", 1.8},
            {at(12, 36), "facade", "b-6"}},
           {}}};
}

/// Adds the ring's borders and gates, returns the ring. Twins are named when every sector is there.
Ring add_ring(City& city, const SectorPlan& plan, const std::vector<Side>& sides) {
  Ring ring;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    const Line line{side.from, sides[(i + 1) % sides.size()].from};
    ring.push_back(side.from);
    if (side.what == "gate") {
      const std::string to = side.other.empty() ? "out" : side.other;
      city.gates.push_back({plan.id + "-to-" + to, plan.id, side.other, "", side.gate, line});
    } else {
      Border border{plan.id, side.other, BorderKind::facade, side.height_m, line};
      parse_name(side.what, border.kind);
      city.borders.push_back(border);
    }
  }
  return ring;
}

void add_sectors(City& city) {
  for (const auto& plan : sector_plans()) {
    Sector sector;
    sector.id = plan.id;
    sector.kind = plan.kind;
    sector.name = plan.name;
    sector.names = plan.names;
    sector.ground.outer = add_ring(city, plan, plan.outer);
    if (!plan.hole.empty()) sector.ground.holes.push_back(add_ring(city, plan, plan.hole));
    sector.ground_triangles = triangulate(sector.ground);
    sector.origin = sector.ground.outer.front();
    sector.bytes = 1000 * sector.ground.outer.size();
    city.sectors.push_back(sector);
  }
  for (auto& gate : city.gates)
    for (const auto& other : city.gates)
      if (gate.line.front() == other.line.back() && gate.line.back() == other.line.front()) gate.twin_id = other.id;
}

Building house(const std::string& id, const std::string& sector, double eave_m, const char* roof, Ring outer) {
  Building b;
  b.id = id;
  b.source_id = "way/" + std::to_string(1000 + std::stoi(id.substr(2)));
  b.sector_id = sector;
  b.footprint.outer = std::move(outer);
  b.eave_m = eave_m;
  b.height_m = std::string(roof) == "flat" ? eave_m : eave_m + 4.5;
  b.roof_shape = roof;
  b.tags = {{"building", "yes"}, {"building:colour", "#c8b49" + id.substr(2, 1)}};
  return b;
}

/// One level facet.
Roof flat_roof(const Polygon& footprint, double up_m) {
  Roof roof;
  RoofFacet top;
  const auto add = [&](const Ring& ring) {
    top.rings.emplace_back();
    for (const PlanPoint p : ring) {
      top.rings.back().push_back(static_cast<std::uint32_t>(roof.points.size()));
      roof.points.push_back({p, static_cast<std::int32_t>(std::llround(up_m * kRoofStepsPerMetre))});
    }
  };
  add(footprint.outer);
  for (const auto& hole : footprint.holes) add(hole);
  top.triangles = triangulate(footprint);
  roof.facets.push_back(std::move(top));
  return roof;
}

void add_buildings(City& city) {
  auto& list = city.buildings;
  list.push_back(house("b-1", "s-main-w", 12, "gabled", {at(-60, 5), at(-32, 5.6), at(-32, 20), at(-60, 20)}));
  list.push_back(
      house("b-10", "s-main-w", 15, "gabled", {at(-60, -30), at(-20, -30), at(-5, -20), at(-5, -5), at(-60, -5)}));
  list.back().name = "Sankt Löwen";
  list.back().height_m = 41.25;
  list.back().height_source = HeightSource::measured;
  list.back().tags["building"] = "church";
  list.push_back(
      house("b-2", "s-north", 18, "hipped", {at(-32, 5.6), at(-5, 5), at(-5, 40), at(-32, 40), at(-32, 20)}));
  list.back().footprint.holes = {{at(-24, 16), at(-24, 28), at(-14, 28), at(-14, 16)}};
  list.push_back(house("b-3", "s-main-e", 16, "flat", {at(5, 5), at(24, 5), at(24, 22), at(12, 22), at(5, 22)}));
  list.back().name = kAwkwardName;
  list.back().tags["addr:street"] = kAwkwardName;
  list.back().tags["addr:housenumber"] = "3";
  list.back().height_source = HeightSource::levels;
  list.push_back(house("b-4", "s-passage", 16.5, "flat", {at(24, 5), at(28, 5), at(28, 22), at(24, 22)}));
  list.back().base_m = 3.2;
  list.push_back(house("b-5", "s-main-e", 14, "gabled", {at(28, 5), at(60, 5), at(60, 22), at(52, 22), at(28, 22)}));
  list.push_back(house("b-6", "s-north", 13, "flat", {at(5, 22), at(12, 22), at(12, 36), at(12, 40), at(5, 40)}));
  list.push_back(house("b-7", "s-yard", 4, "skillion", {at(52, 22), at(60, 22), at(60, 40), at(52, 40), at(52, 36)}));
  list.push_back(house("b-8", "s-main-e", 11, "mansard", {at(5, -25), at(30, -25), at(30, -5), at(5, -5)}));
  list.push_back(house("b-9", "s-main-e", 9, "gabled", {at(30, -25), at(60, -28), at(60, -5), at(30, -5)}));
  for (auto& b : list) b.roof = flat_roof(b.footprint, b.eave_m);
}

/// Side walls: every footprint edge that is no facade, where it stands above the neighbour.
void add_side_walls(City& city) {
  std::map<Line, const Building*> house_of;  // by directed edge, house on the left
  std::set<std::pair<Line, std::string>> facades;
  const auto edges_of = [](const Building& b) {
    std::vector<Line> edges;
    std::vector<Ring> rings = b.footprint.holes;
    rings.insert(rings.begin(), b.footprint.outer);
    for (const auto& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return edges;
  };
  for (const auto& b : city.buildings)
    for (const auto& edge : edges_of(b)) house_of[edge] = &b;
  for (const auto& border : city.borders) facades.insert({{border.line[1], border.line[0]}, border.building_id});
  for (auto& b : city.buildings)
    for (const auto& edge : edges_of(b)) {
      if (facades.contains({edge, b.id})) continue;
      const auto neighbour = house_of.find({edge[1], edge[0]});
      const double bottom_m = neighbour == house_of.end() ? b.base_m : neighbour->second->eave_m;
      if (bottom_m < b.eave_m) b.side_walls.push_back({edge[0], edge[1], bottom_m});
    }
}

void add_obstacles(City& city) {
  city.obstacles = {
      {ObstacleKind::courtyard, "", 0, {{at(-60, 20), at(-32, 20), at(-32, 40), at(-60, 40)}, {}}},
      {ObstacleKind::courtyard, "", 0, {{at(-24, 16), at(-14, 16), at(-14, 28), at(-24, 28)}, {}}},
      {ObstacleKind::fence, "way/2001", 1.8, {{at(12, 36), at(52, 36), at(52, 40), at(12, 40)}, {}}},
      {ObstacleKind::island, "way/2002", 0, {{at(30, -1), at(33, -1), at(33, 1), at(30, 1)}, {}}},
      {ObstacleKind::wall, "way/2003", 2.5, {{at(-5, -40), at(5, -40), at(5, -39.6), at(-5, -39.6)}, {}}},
      {ObstacleKind::water,
       "relation/2004",
       0,
       {{at(-60, -40), at(-5, -40), at(-5, -39.6), at(-5, -20), at(-20, -30), at(-60, -30)}, {}}},
      {ObstacleKind::yard, "", 0, {{at(5, -40), at(60, -40), at(60, -28), at(30, -25), at(5, -25), at(5, -39.6)}, {}}}};
  city.domain = {{{at(-60, -40), at(-5, -40), at(5, -40), at(60, -40), at(60, -28), at(60, -5), at(60, 5), at(60, 22),
                   at(60, 40), at(52, 40), at(12, 40), at(5, 40), at(-5, 40), at(-32, 40), at(-60, 40), at(-60, 20),
                   at(-60, 5), at(-60, -5), at(-60, -30)},
                  {}}};
}

void add_things(City& city) {
  city.streets = {
      {"way/1", kAwkwardName, "residential", 10, false, false, false, {at(-60, 0), at(0, 0), at(26, 0.25), at(60, 0)}},
      {"way/2", "Kreuzgasse", "living_street", 10, false, false, false, {at(0, -39.6), at(0, 0), at(0, 40)}},
      {"way/3", "", "service", 4, true, false, false, {at(26, 0.25), at(26, 22), at(26, 30)}}};
  city.objects = {
      {"o-1", "s-main-e", "fountain", "Löwenbrunnen", at(31.5, 0), 0, 2.25, 0, "", {{"amenity", "fountain"}}},
      {"o-2", "s-yard", "tree", "", at(40, 30), 0.25, 8.5, 0, "", {{"natural", "tree"}, {"leaf_type", "broadleaved"}}},
      {"o-3", "s-main-w", "street_lamp", "", at(-30, 4), 0, 4, 0, "", {}},
      {"o-4", "s-main-w", "sign", "Café \"Löwe\"", at(-40, 4.94), 0, 3, 180, "https://example.org/?a=1&b=2", {}},
      {"o-5", "s-main-w", "sign", "Bäckerei", at(-20, 4.94), 0, 3, 180, "", {}}};
  city.surfaces = {
      {"s-main-w", SurfaceKind::carriageway, {{at(-60, -3), -120}, {at(-5, -3), -120}, {at(-5, 3), -120}}, {0, 1, 2}},
      {"s-main-w", SurfaceKind::kerb, {{at(-60, -3), -120}, {at(-5, -3), -120}, {at(-5, -3), 0}}, {1, 0, 2}}};
  city.rides = {{"s-main-w", "tram", 40, {{at(-60, 1), 0, 1.5}, {at(-30, 1), 0.25, 6.5}, {at(-5, 1), 0.25, 10.625}}}};
  city.impostors = {{"s-main-w-to-s-cross", "s-main-w", at(-58, 0), 1.75, at(-5, 4), at(-5, -4), -0.25, 7.5, 53.5, 118,
                     53, 0.625, false, 128, 64, ""}};
  city.panoramas = {{"s-cross", at(0, 0), 1.75, 500, -2.5, 60, 180, 1200, (1u << 3) | (1u << 4), 256, 64, ""}};
  city.prototypes = {{"bench", {{at(0, 0), 0}, {at(1, 0), 0}, {at(0, 1), 500}}, {0, 1, 2}, {{10, 20, 30}}}};
  city.viewpoints = {{"v-cross", "s-cross", "start", kAwkwardName, at(0, 0), 0, 1.7, 90},
                     {"v-main-e", "s-main-e", "gate", kAwkwardName, at(7, 0), 0, 1.7, 90},
                     {"v-main-w", "s-main-w", "gate", kAwkwardName, at(-7, 0), 0, 1.7, 270},
                     {"v-north", "s-north", "gate", "Kreuzgasse", at(0, 7), 0, 1.7, 0},
                     {"v-passage", "s-passage", "gate", "Passage", at(26, 7), 0, 1.6, 0},
                     {"v-south", "s-south", "gate", "Kreuzgasse", at(0, -7), 0, 1.7, 180},
                     {"v-yard", "s-yard", "square", "Löwenhof", at(32, 29), 0.25, 1.7, 247.5}};
  city.issues = {
      {IssueCode::ring_self_intersection, "the ring crosses itself; the larger part was kept", "way/1009", at(45, -15)},
      {IssueCode::no_height, "no height: guessed from the neighbours", "way/1001", at(-46, 12)}};
}

void add_terrain(City& city) {
  city.terrain = {at(-60, -40), 40'000, 4, 3, {0, 250, 500, -125, 1000, 1250, 1500, 875, 2000, 2250, 2500, 1875}};
}

void mark_important(City& city) {
  for (auto& sector : city.sectors) {
    if (sector.id == "s-cross") sector.importance = Importance::author, sector.vicinity_m = 60.5;
    if (sector.id == "s-yard") sector.importance = Importance::proposed, sector.vicinity_m = 150;
  }
}

void add_visible(City& city) {
  std::set<std::pair<std::string, std::string>> seen;
  const auto add = [&](const std::string& from, const std::string& to, VisibleReason reason) {
    if (seen.insert({from, to}).second) city.visible.push_back({from, to, reason, true, {}});
  };
  for (const auto& sector : city.sectors) add(sector.id, sector.id, VisibleReason::self);
  for (const auto& gate : city.gates)
    if (!gate.to_sector_id.empty()) add(gate.sector_id, gate.to_sector_id, VisibleReason::gate);
  for (const auto& [a, b] : {std::pair{"s-main-w", "s-main-e"}, {"s-north", "s-south"}}) {
    add(a, b, VisibleReason::line_of_sight);
    add(b, a, VisibleReason::line_of_sight);
  }
  add("s-yard", "s-cross", VisibleReason::important);
  city.visible.push_back({"s-yard", "s-main-w", VisibleReason::over_roofs, true, {"b-10"}});
  city.visible.push_back({"s-yard", "s-north", VisibleReason::over_roofs, false, {"b-2"}});
  std::sort(city.visible.begin(), city.visible.end(), [](const Visible& a, const Visible& b) {
    return std::pair(a.sector_id, a.visible_sector_id) < std::pair(b.sector_id, b.visible_sector_id);
  });
}

}  // namespace

City sample_city() {
  City city;
  city.origin = {47.0707, 15.4395};
  city.meta = {{"program_version", "0.0.0-sample"},
               {"sources", "sample.osm"},
               {"licences", "drawn by hand, CC0 1.0"},
               {"options", "{\"budget_kb\":200}"}};
  add_sectors(city);
  add_buildings(city);
  add_side_walls(city);
  add_obstacles(city);
  add_things(city);
  mark_important(city);
  add_visible(city);
  add_terrain(city);
  return city;
}

City sample_city_with_facades() {
  City city = sample_city();
  city.meta["atlas"] = "a71a5";
  int count = 0;
  for (const Border& border : city.borders) {
    if (border.kind != BorderKind::facade) continue;
    const auto house = std::find_if(city.buildings.begin(), city.buildings.end(),
                                    [&](const Building& b) { return b.id == border.building_id; });
    const auto runs = straight_runs(border.line);
    for (std::size_t i = 0; house != city.buildings.end() && house->base_m == 0 && i + 1 < runs.size(); ++i) {
      Facade f;
      f.sector_id = border.sector_id;
      f.building_id = border.building_id;
      f.a = border.line[runs[i]];
      f.b = border.line[runs[i + 1]];
      if (f.a == f.b || length_m(f) < 3) continue;
      f.top_m = house->eave_m > 0 ? house->eave_m : house->height_m;
      f.style = static_cast<FacadeStyle>(count % 6);
      f.floors = f.style == FacadeStyle::church || f.style == FacadeStyle::shed ? 1 : 1 + count % 5;
      f.bays = std::clamp(static_cast<int>(length_m(f) / 3), 1, 8);
      f.repeats = 1 + static_cast<int>(length_m(f) / 3) / 9;
      f.door_bay = count % 3 == 0 ? f.bays / 2 : -1;
      f.has_shop = count % 4 == 1;
      f.texture = "f" + std::to_string(count % 7);
      ++count;
      city.facades.push_back(f);
    }
  }
  return city;
}

}  // namespace vicus::test
