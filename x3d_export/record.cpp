#include "x3d_export/record.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/seen_houses.hpp"
#include "x3d_export/objects.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

void append_plan(std::vector<double>& values, PlanPoint p) {
  values.push_back(metres(p.x));
  values.push_back(metres(p.y));
}

double rounded(double m) { return metres(lattice_mm(m)); }

std::vector<double> values_of(PlanPoint p) { return {metres(p.x), metres(p.y)}; }
std::vector<double> values_of(const PlanBox& b) {
  return {metres(b.min.x), metres(b.min.y), metres(b.max.x), metres(b.max.y)};
}
std::vector<double> values_of(const std::vector<PlanPoint>& line) {
  std::vector<double> values;
  for (const auto& p : line) append_plan(values, p);
  return values;
}

Json json_of(const std::vector<PlanPoint>& line) {
  Json out = Json::array();
  for (const auto& p : line) out.push_back(values_of(p));
  return out;
}

Json json_or_null(const std::string& id) { return id.empty() ? Json(nullptr) : Json(clean_text(id)); }

/// Where it was taken from, what depths it shows, where it stands, how far around it is true.
std::vector<double> values_of(const GateImpostor& i) {
  return {metres(i.eye.x), metres(i.eye.y), i.eye_up_m, i.near_m, i.far_m, i.plane_m, i.radius_m};
}

Json json_of(const GateImpostor& i) {
  return {{"url", "impostors/" + clean_text(i.gate_id) + ".png"},
          {"eye", {metres(i.eye.x), metres(i.eye.y), rounded(i.eye_up_m)}},
          {"near", rounded(i.near_m)},
          {"far", rounded(i.far_m)},
          {"plane", rounded(i.plane_m)},
          {"radius", rounded(i.radius_m)},
          {"solid", i.is_solid}};
}

/// Where it was taken from, what depths it shows, where it stands.
std::vector<double> values_of(const Panorama& p) {
  return {metres(p.eye.x), metres(p.eye.y), p.eye_up_m, p.near_m, p.far_m, p.radius_m};
}

Json json_of(const Panorama& p) {
  return {{"url", "panoramas/" + clean_text(p.sector_id) + ".png"},
          {"eye", {metres(p.eye.x), metres(p.eye.y), rounded(p.eye_up_m)}},
          {"near", rounded(p.near_m)},
          {"far", rounded(p.far_m)},
          {"radius", rounded(p.radius_m)}};
}

Json json_of(const Gate& g, const std::map<std::string, GateImpostor>& impostors) {
  Json json = {{"id", clean_text(g.id)},
               {"to", json_or_null(g.to_sector_id)},
               {"twin", json_or_null(g.twin_id)},
               {"kind", name_of(g.kind)},
               {"line", json_of(g.line)}};
  if (const auto at = impostors.find(g.id); at != impostors.end()) json["impostor"] = json_of(at->second);
  return json;
}

Json json_of(const RecordDoor& d) {
  return {{"id", clean_text(d.door.id)},        {"to", clean_text(d.to.id)},
          {"twin", clean_text(d.door.twin_id)}, {"line", json_of(std::vector{d.door.a, d.door.b})},
          {"origin", values_of(d.to.origin)},   {"box", values_of(d.to.box)}};
}

Json json_of(const Viewpoint& v) {
  return {{"id", clean_text(v.id)}, {"kind", clean_text(v.kind)}, {"name", clean_text(v.name)}, {"at", values_of(v.at)},
          {"eye", v.eye_m},         {"heading", v.heading_deg}};
}

std::vector<double> values_of(const Body& body) {
  return {metres(body.at.x), metres(body.at.y), metres(lattice_mm(body.radius_m))};
}

Node metadata(const char* type, const std::string& name, FieldValue value) {
  Node node(type);
  node.set("name", FieldValue(name)).set("value", std::move(value));
  return node;
}
Node texts(const std::string& name, std::vector<std::string> values) {
  return metadata("MetadataString", name, std::move(values));
}
Node numbers(const std::string& name, std::vector<double> values) {
  return metadata("MetadataDouble", name, std::move(values));
}
Node counts(const std::string& name, std::vector<std::int32_t> values) {
  return metadata("MetadataInteger", name, std::move(values));
}

Node gate_node(const Gate& gate, const std::map<std::string, GateImpostor>& impostors) {
  Node node("MetadataSet");
  node.set("name", "gate").add("value", texts("id", {gate.id}));
  if (!gate.to_sector_id.empty()) node.add("value", texts("to", {gate.to_sector_id}));
  node.add("value", texts("kind", {name_of(gate.kind)})).add("value", numbers("line", values_of(gate.line)));
  if (const auto at = impostors.find(gate.id); at != impostors.end())
    node.add("value", numbers("impostor", values_of(at->second)));
  return node;
}

Node door_node(const RecordDoor& d) {
  Node node("MetadataSet");
  node.set("name", "door").add("value", texts("id", {d.door.id})).add("value", texts("to", {d.to.id}));
  node.add("value", texts("twin", {d.door.twin_id}))
      .add("value", numbers("line", values_of(std::vector{d.door.a, d.door.b})));
  return node.add("value", numbers("origin", values_of(d.to.origin))).add("value", numbers("box", values_of(d.to.box)));
}

/// Three flat lists: a park sees hundreds of sectors, and a set for each would outweigh its houses.
void add_neighbours(Node& node, const std::vector<SectorNeighbour>& neighbours) {
  std::vector<std::string> ids;
  std::vector<double> origins, boxes;
  for (const auto& n : neighbours) {
    ids.push_back(n.id);
    append_plan(origins, n.origin);
    for (const double v : values_of(n.box)) boxes.push_back(v);
  }
  node.add("value", texts("neighbour_ids", ids))
      .add("value", numbers("neighbour_origins", origins))
      .add("value", numbers("neighbour_boxes", boxes));
}

}  // namespace

SectorRecord sector_record(const RecordSource& source, const Sector& sector, int shapes) {
  SectorRecord record{
      sector, box_of(sector.ground), shapes, source.gates_of(sector.id), {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  for (auto& impostor : source.impostors_of(sector.id)) {
    impostor.png.clear();
    record.impostors.emplace(impostor.gate_id, std::move(impostor));
  }
  if (auto panorama = source.panorama_of(sector.id)) {
    panorama->png.clear();
    record.panorama = std::move(panorama);
  }
  std::set<std::string> behind;
  for (const auto& g : record.gates)
    if (!g.to_sector_id.empty()) behind.insert(g.to_sector_id);
  record.reasons[sector.id] = VisibleReason::self;
  for (const auto& id : behind) record.reasons.emplace(id, VisibleReason::gate);
  for (const auto& v : source.visible_from(sector.id)) {
    if (!record.reasons.emplace(v.visible_sector_id, v.reason).second) continue;
    if (is_of_houses_alone(v)) record.over_roofs.push_back(v.visible_sector_id);
    if (!v.is_proven) record.unresolved.push_back(v.visible_sector_id);
  }
  std::sort(record.over_roofs.begin(), record.over_roofs.end());
  std::sort(record.unresolved.begin(), record.unresolved.end());
  for (const auto& [id, reason] : record.reasons) record.visible.push_back(id);
  for (const auto& id : record.visible)
    if (const auto other = id == sector.id ? std::nullopt : source.sector(id))
      record.neighbours.push_back({id, other->origin, box_of(other->ground)});
  for (auto& door : source.doors_of(sector.id))
    if (const auto other = source.sector(door.to_sector_id))
      record.doors.push_back({std::move(door), {other->id, other->origin, box_of(other->ground)}});
  record.viewpoints = source.viewpoints_of(sector.id);
  for (const auto& object : source.objects_of(sector.id))
    if (const double radius_m = body_radius_m(object); radius_m > 0) record.bodies.push_back({object.at, radius_m});
  for (const auto& object : source.objects_of(sector.id))
    // A sign bears the name of the shop behind it, which is a place itself.
    if (!object.name.empty() && object.kind != "sign") record.places.push_back({object.kind, object.name, object.at});
  return record;
}

std::string record_json(const SectorRecord& record) {
  const Sector& s = record.sector;
  Json names = Json::array(), ground = Json::array(), gates = Json::array(), neighbours = Json::array(),
       doors = Json::array(), viewpoints = Json::array(), bodies = Json::array(), places = Json::array(),
       reasons = Json::object();
  for (const auto& name : s.names) names.push_back(clean_text(name));
  ground.push_back(json_of(s.ground.outer));
  for (const auto& hole : s.ground.holes) ground.push_back(json_of(hole));
  for (const auto& g : record.gates) gates.push_back(json_of(g, record.impostors));
  for (const auto& n : record.neighbours)
    neighbours.push_back({{"id", n.id}, {"origin", values_of(n.origin)}, {"box", values_of(n.box)}});
  for (const auto& d : record.doors) doors.push_back(json_of(d));
  for (const auto& v : record.viewpoints) viewpoints.push_back(json_of(v));
  for (const auto& [id, reason] : record.reasons) reasons[id] = name_of(reason);
  for (const auto& b : record.bodies) bodies.push_back(values_of(b));
  for (const auto& p : record.places)
    places.push_back({{"kind", clean_text(p.kind)}, {"name", clean_text(p.name)}, {"at", values_of(p.at)}});
  Json json = {{"id", s.id},
               {"kind", name_of(s.kind)},
               {"name", clean_text(s.name)},
               {"names", names},
               {"origin", values_of(s.origin)},
               {"box", values_of(record.box)},
               {"shapes", record.shapes},
               {"ground", ground},
               {"gates", gates},
               {"doors", doors},
               {"neighbours", neighbours},
               {"bodies", bodies},
               {"visible", record.visible},
               {"over_roofs", record.over_roofs},
               {"unresolved", record.unresolved},
               {"visible_reasons", reasons},
               {"viewpoints", viewpoints},
               {"places", places}};
  if (record.panorama) json["panorama"] = json_of(*record.panorama);
  return json.dump();
}

Node links_node(const SectorRecord& record) {
  const Sector& s = record.sector;
  Node node("MetadataSet", "RECORD");
  node.set("name", "sector").set("reference", "vicus 1");
  node.add("value", texts("id", {s.id}));
  node.add("value", numbers("origin", values_of(s.origin))).add("value", numbers("box", values_of(record.box)));
  if (!record.neighbours.empty()) add_neighbours(node, record.neighbours);
  if (!record.over_roofs.empty()) node.add("value", texts("over_roofs", record.over_roofs));
  return node;
}

Node record_node(const SectorRecord& record) {
  const Sector& s = record.sector;
  Node node("MetadataSet", "RECORD");
  node.set("name", "sector").set("reference", "vicus 1");
  node.add("value", texts("id", {s.id})).add("value", texts("kind", {name_of(s.kind)}));
  if (!s.name.empty()) node.add("value", texts("name", {s.name}));
  if (!s.names.empty()) node.add("value", texts("names", s.names));
  node.add("value", numbers("origin", values_of(s.origin))).add("value", numbers("box", values_of(record.box)));
  node.add("value", counts("shapes", {record.shapes}));
  std::vector<std::int32_t> ring_sizes{static_cast<std::int32_t>(s.ground.outer.size())};
  std::vector<double> points = values_of(s.ground.outer);
  for (const auto& hole : s.ground.holes) {
    ring_sizes.push_back(static_cast<std::int32_t>(hole.size()));
    for (const auto& p : hole) append_plan(points, p);
  }
  node.add("value", counts("ground_counts", ring_sizes)).add("value", numbers("ground", points));
  std::vector<double> bodies;
  for (const auto& b : record.bodies)
    for (const double v : values_of(b)) bodies.push_back(v);
  if (!bodies.empty()) node.add("value", numbers("bodies", std::move(bodies)));
  for (const auto& g : record.gates) node.add("value", gate_node(g, record.impostors));
  for (const auto& d : record.doors) node.add("value", door_node(d));
  if (record.panorama) node.add("value", numbers("panorama", values_of(*record.panorama)));
  if (!record.neighbours.empty()) add_neighbours(node, record.neighbours);
  node.add("value", texts("visible", record.visible));
  if (!record.over_roofs.empty()) node.add("value", texts("over_roofs", record.over_roofs));
  std::vector<std::string> important;
  for (const auto& [id, reason] : record.reasons)
    if (reason == VisibleReason::important) important.push_back(id);
  if (!important.empty()) node.add("value", texts("important", std::move(important)));
  return node;
}

}  // namespace vicus
