#include "tests/support/city_equal.hpp"

#include <tuple>

namespace vicus {
namespace {

auto fields(const LatLon& p) { return std::tie(p.lat_deg, p.lon_deg); }
auto fields(const Polygon& p) { return std::tie(p.outer, p.holes); }
auto fields(const Sector& s) {
  return std::tie(s.id, s.kind, s.name, s.names, s.ground, s.ground_triangles, s.origin, s.bytes, s.importance,
                  s.vicinity_m);
}
auto fields(const Gate& g) { return std::tie(g.id, g.sector_id, g.to_sector_id, g.twin_id, g.kind, g.line); }
auto fields(const Border& b) { return std::tie(b.sector_id, b.building_id, b.kind, b.height_m, b.line); }
auto fields(const SideWall& w) { return std::tie(w.a, w.b, w.bottom_m); }
auto fields(const Building& b) {
  return std::tie(b.id, b.source_id, b.name, b.sector_id, b.footprint, b.ground_m, b.foot_m, b.base_m, b.height_m,
                  b.eave_m, b.roof_shape, b.roof_source, b.height_source, b.roof, b.side_walls, b.wall_colour,
                  b.roof_colour, b.tags);
}
auto fields(const Facade& f) {
  return std::tie(f.sector_id, f.building_id, f.a, f.b, f.bottom_m, f.top_m, f.style, f.floors, f.bays, f.repeats,
                  f.door_bay, f.has_shop, f.texture, f.openings);
}
auto fields(const Obstacle& o) { return std::tie(o.kind, o.source_id, o.height_m, o.area); }
auto fields(const Street& s) {
  return std::tie(s.source_id, s.name, s.kind, s.width_m, s.is_passage, s.is_bridge, s.is_steps, s.line);
}
auto fields(const StandaloneObject& o) {
  return std::tie(o.id, o.sector_id, o.kind, o.name, o.at, o.ground_m, o.height_m, o.heading_deg, o.url, o.tags);
}
auto fields(const Surface& s) { return std::tie(s.sector_id, s.kind, s.points, s.triangles); }
auto fields(const RidePoint& p) { return std::tie(p.at, p.ground_m, p.time_s); }
auto fields(const Ride& r) { return std::tie(r.sector_id, r.kind, r.cycle_s, r.points); }
auto fields(const Prototype& p) { return std::tie(p.kind, p.points, p.triangles, p.colours); }
auto fields(const Viewpoint& v) {
  return std::tie(v.id, v.sector_id, v.kind, v.name, v.at, v.ground_m, v.eye_m, v.heading_deg);
}
auto fields(const Interior& i) { return std::tie(i.sector, i.building_id, i.source_id, i.floor_m, i.height_m); }
auto fields(const Door& d) {
  return std::tie(d.id, d.twin_id, d.sector_id, d.to_sector_id, d.building_id, d.a, d.b, d.sill_m, d.height_m,
                  d.recess_m);
}
auto fields(const Visible& v) {
  return std::tie(v.sector_id, v.visible_sector_id, v.reason, v.is_proven, v.building_ids);
}
auto fields(const Panorama& p) {
  return std::tie(p.sector_id, p.eye, p.eye_up_m, p.radius_m, p.bottom_m, p.top_m, p.near_m, p.far_m, p.sides,
                  p.width_px, p.height_px);
}
auto fields(const GateImpostor& i) {
  return std::tie(i.gate_id, i.sector_id, i.eye, i.eye_up_m, i.left, i.right, i.bottom_m, i.top_m, i.near_m, i.far_m,
                  i.plane_m, i.radius_m, i.is_solid, i.width_px, i.height_px);
}
auto fields(const Terrain& t) { return std::tie(t.corner, t.step_mm, t.columns, t.rows, t.height_mm); }
auto fields(const Artefact& a) { return std::tie(a.path, a.media_type, a.coding, a.hash, a.body); }
auto fields(const Issue& i) { return std::tie(i.code, i.message, i.source_id, i.at); }

}  // namespace

bool operator==(const LatLon& a, const LatLon& b) { return fields(a) == fields(b); }
bool operator==(const Polygon& a, const Polygon& b) { return fields(a) == fields(b); }
bool operator==(const Sector& a, const Sector& b) { return fields(a) == fields(b); }
bool operator==(const Gate& a, const Gate& b) { return fields(a) == fields(b); }
bool operator==(const Border& a, const Border& b) { return fields(a) == fields(b); }
bool operator==(const SideWall& a, const SideWall& b) { return fields(a) == fields(b); }
bool operator==(const Building& a, const Building& b) { return fields(a) == fields(b); }
bool operator==(const Facade& a, const Facade& b) { return fields(a) == fields(b); }
bool operator==(const Obstacle& a, const Obstacle& b) { return fields(a) == fields(b); }
bool operator==(const Street& a, const Street& b) { return fields(a) == fields(b); }
bool operator==(const StandaloneObject& a, const StandaloneObject& b) { return fields(a) == fields(b); }
bool operator==(const Surface& a, const Surface& b) { return fields(a) == fields(b); }
bool operator==(const RidePoint& a, const RidePoint& b) { return fields(a) == fields(b); }
bool operator==(const Ride& a, const Ride& b) { return fields(a) == fields(b); }
bool operator==(const Prototype& a, const Prototype& b) { return fields(a) == fields(b); }
bool operator==(const Viewpoint& a, const Viewpoint& b) { return fields(a) == fields(b); }
bool operator==(const Interior& a, const Interior& b) { return fields(a) == fields(b); }
bool operator==(const Door& a, const Door& b) { return fields(a) == fields(b); }
bool operator==(const Visible& a, const Visible& b) { return fields(a) == fields(b); }
bool operator==(const GateImpostor& a, const GateImpostor& b) { return fields(a) == fields(b); }
bool operator==(const Panorama& a, const Panorama& b) { return fields(a) == fields(b); }
bool operator==(const Terrain& a, const Terrain& b) { return fields(a) == fields(b); }
bool operator==(const Artefact& a, const Artefact& b) { return fields(a) == fields(b); }
bool operator==(const Issue& a, const Issue& b) { return fields(a) == fields(b); }

namespace test {
namespace {

template <class Record>
void compare(const char* name, const std::vector<Record>& a, const std::vector<Record>& b, std::string& difference) {
  if (!difference.empty()) return;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    if (!(a[i] == b[i])) {
      difference = std::string(name) + "[" + std::to_string(i) + "]";
      return;
    }
  if (a.size() != b.size())
    difference = std::string(name) + ": " + std::to_string(a.size()) + " and " + std::to_string(b.size()) + " rows";
}

}  // namespace

std::string difference(const City& a, const City& b) {
  if (!(a.origin == b.origin)) return "origin";
  if (a.meta != b.meta) return "meta";
  if (!(a.terrain == b.terrain)) return "terrain";
  std::string found;
  compare("sectors", a.sectors, b.sectors, found);
  compare("gates", a.gates, b.gates, found);
  compare("borders", a.borders, b.borders, found);
  compare("buildings", a.buildings, b.buildings, found);
  compare("facades", a.facades, b.facades, found);
  compare("obstacles", a.obstacles, b.obstacles, found);
  compare("domain", a.domain, b.domain, found);
  compare("streets", a.streets, b.streets, found);
  compare("objects", a.objects, b.objects, found);
  compare("surfaces", a.surfaces, b.surfaces, found);
  compare("rides", a.rides, b.rides, found);
  compare("prototypes", a.prototypes, b.prototypes, found);
  compare("viewpoints", a.viewpoints, b.viewpoints, found);
  compare("interiors", a.interiors, b.interiors, found);
  compare("doors", a.doors, b.doors, found);
  compare("visible", a.visible, b.visible, found);
  compare("impostors", a.impostors, b.impostors, found);
  compare("panoramas", a.panoramas, b.panoramas, found);
  compare("issues", a.issues, b.issues, found);
  return found;
}

}  // namespace test
}  // namespace vicus
