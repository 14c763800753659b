#include "x3d_export/root_scene.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "city_db/boxes.hpp"
#include "city_db/panorama_sides.hpp"
#include "city_db/surroundings.hpp"
#include "x3d_export/frames.hpp"
#include "x3d_export/record.hpp"
#include "x3d_export/sector_scene.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr PlanPoint kRootOrigin{0, 0};
/// The sensor holds any city the lattice can hold near its origin (DESIGN §2: 100 km) and any height.
constexpr double kSensorSide_m = 200'000, kSensorHeight_m = 4000;
constexpr double kAvatar_m[] = {0.25, 1.7, 0.4};  // radius, eye, step
constexpr double kWalk_m_per_s = 1.6;
constexpr double kTallest_m = 16;  // at least the backdrops at the city's ends

/// Crowns and trams reach over the edge of the ground, water lies below it, a slope may go on beyond the viewpoints.
constexpr double kOverhang_m = 6, kSunk_m = 1, kSlope_m = 15;

/// A house without a facade to walk along is sent by a sector near by, rarely so far from it.
constexpr double kReach_m = 150;

using Ids = std::set<std::string>;

/// Sectors behind the gates of `id`.
Ids behind_gates(const RecordSource& source, const std::string& id) {
  Ids ids;
  for (const auto& gate : source.gates_of(id))
    if (!gate.to_sector_id.empty()) ids.insert(gate.to_sector_id);
  return ids;
}

/// Ids of sectors to show, and which file: tall where some houses are enough.
using Shown = std::map<std::string, Detail>;

/// L_i of paper 004 §5.1: the start, then i times the L_vis and gate neighbours of all that are in. A sector that is
/// only seen over roofs comes as its tall houses and leads no further; VRML97 and X3D JSON have no such files.
Shown sectors_within(const RecordSource& source, const RootOptions& options, const std::string& start) {
  Shown shown{{start, Detail::near}};
  if (options.level == kEverySector) {
    for (const auto& id : source.sector_ids()) shown[id] = Detail::near;
    return shown;
  }
  if (!options.near.empty()) {
    for (const auto& id : options.near) shown[id] = Detail::near;
    for (const auto& id : options.far) shown.emplace(id, Detail::far);
    return shown;
  }
  Ids latest{start};
  for (int i = 0; i < options.level && !latest.empty(); ++i) {
    Ids found;
    for (const auto& id : latest) {
      for (const auto& v : source.visible_from(id))
        if (options.format == SceneFormat::x3d && !v.building_ids.empty())
          shown.emplace(v.visible_sector_id, Detail::tall);
        else
          found.insert(v.visible_sector_id);
      found.merge(behind_gates(source, id));
    }
    latest.clear();
    for (const auto& id : found) {
      const auto [at, is_new] = shown.emplace(id, Detail::near);
      if (is_new || at->second != Detail::near) latest.insert(id);
      at->second = Detail::near;
    }
  }
  return shown;
}

struct InitialSector {
  Sector sector;
  Detail detail = Detail::near;
};

/// The start sector first, then the others by id.
std::vector<InitialSector> initial_sectors(const RecordSource& source, const RootOptions& options,
                                           const Sector& start) {
  std::vector<InitialSector> sectors{{start}};
  Shown shown;
  if (options.is_static)
    shown = sectors_within(source, options, start.id);
  else
    for (const auto& id : behind_gates(source, start.id)) shown.emplace(id, Detail::near);
  shown.erase(start.id);
  for (const auto& [id, detail] : shown)
    if (auto sector = source.sector(id)) sectors.push_back({std::move(*sector), detail});
  return sectors;
}

/// bboxCenter and bboxSize of all that the sector's file draws, in the sector's frame.
void set_bounds(Node& node, const RecordSource& source, const Sector& sector) {
  PlanBox box = box_of(sector.ground);
  double low_m = 0, top_m = kTallest_m;
  // Facades on this ground's edge may belong to houses whose roofs other sectors send: they count for the height only.
  const PlanBox around = grown(box, lattice_mm(kReach_m));
  for (const auto& house : source.houses_in(around)) {
    low_m = std::min(low_m, house.ground_m - house.foot_m);
    top_m = std::max(top_m, house.ground_m + house.height_m);
    if (house.sector_id == sector.id)
      for (const auto& p : house.footprint.outer) box.add(p);
  }
  for (const auto& view : source.viewpoints_of(sector.id)) {
    const double slope_m = source.meta("terrain_base_m").empty() ? 0 : kSlope_m;
    low_m = std::min(low_m, view.ground_m - slope_m);
    top_m = std::max(top_m, view.ground_m + kTallest_m + slope_m);
  }
  box = grown(box, lattice_mm(kOverhang_m));
  if (const auto panorama = source.panorama_of(sector.id)) {
    low_m = std::min(low_m, panorama->bottom_m + kSunk_m);
    top_m = std::max(top_m, panorama->top_m);
    for (const PanoramaSide& side : sides_of(*panorama)) {
      box.add(side.left);
      box.add(side.right);
    }
  }
  const X3dPoint low = x3d_from_plan(box.min, height_mm(low_m - kSunk_m), sector.origin),
                 high = x3d_from_plan(box.max, height_mm(top_m), sector.origin);
  node.set("bboxCenter", std::vector<double>{(metres(low.x) + metres(high.x)) / 2, (metres(low.y) + metres(high.y)) / 2,
                                             (metres(low.z) + metres(high.z)) / 2});
  node.set("bboxSize", std::vector<double>{metres(high.x - low.x), metres(high.y - low.y), metres(low.z - high.z)});
}

std::vector<double> root_position(PlanPoint origin) {
  const X3dPoint p = x3d_from_plan(origin, 0, kRootOrigin);
  return {metres(p.x), metres(p.y), metres(p.z)};
}

Node place_node(const RecordSource& source, const RootOptions& options, const InitialSector& initial,
                std::size_t number) {
  const Sector& sector = initial.sector;
  const std::string suffix = std::to_string(number);
  Node inline_node("Inline", "S_" + suffix);
  // The start comes with the world, before the Script runs; the others when it says so.
  if (!options.is_static && options.format != SceneFormat::vrml && number > 0) inline_node.set("load", false);
  set_bounds(inline_node, source, sector);
  const char* which = initial.detail == Detail::tall ? ".tall" : initial.detail == Detail::far ? ".far" : "";
  inline_node.set("url", std::vector<std::string>{options.base + sector.id + which + suffix_of(options.format)});
  Node place("Transform", "P_" + suffix);
  place.set("translation", root_position(sector.origin));
  return place.add(std::move(inline_node));
}

std::vector<Node> viewpoint_nodes(const RecordSource& source, const Sector& start) {
  auto viewpoints = source.viewpoints_of(start.id);
  std::stable_partition(viewpoints.begin(), viewpoints.end(), [](const Viewpoint& v) { return v.kind == "start"; });
  if (viewpoints.empty()) {
    viewpoints.emplace_back();
    viewpoints.back().at = point_inside(start);
  }
  const std::string place = start.name.empty() ? name_of(start.kind) : start.name;
  std::vector<Node> nodes;
  for (const auto& v : viewpoints) nodes.push_back(viewpoint_node(v, kRootOrigin, place));
  return nodes;
}

std::vector<double> colours(std::span<const Colour> list) {
  std::vector<double> values;
  for (const auto& c : list)
    for (const auto channel : {c.r, c.g, c.b}) values.push_back(channel / 255.0);
  return values;
}

}  // namespace

std::vector<Node> surroundings(const std::vector<std::string>& navigation_types) {
  Node navigation("NavigationInfo"), sky("Background");
  navigation.set("avatarSize", std::vector<double>(std::begin(kAvatar_m), std::end(kAvatar_m)));
  navigation.set("headlight", false).set("speed", kWalk_m_per_s);
  navigation.set("type", navigation_types);
  sky.set("skyAngle", std::vector<double>(std::begin(kSkyAngles), std::end(kSkyAngles)))
      .set("skyColor", colours(kSkyColours));
  sky.set("groundAngle", std::vector<double>(std::begin(kGroundAngles), std::end(kGroundAngles)))
      .set("groundColor", colours(kGroundColours));
  std::vector<Node> nodes{navigation, sky};
  for (const SunLight& light : kLights) {
    Node node("DirectionalLight");
    node.set("direction", std::vector<double>(std::begin(light.direction), std::end(light.direction)));
    nodes.push_back(node.set("intensity", light.intensity));
  }
  return nodes;
}

namespace {

ScriptField field(const char* name, FieldType type, FieldValue value) {
  return {name, type, Access::initialize_only, std::move(value), {}};
}
ScriptField node_field(const char* name, FieldType type, std::vector<Node> nodes) {
  return {name, type, Access::initialize_only, std::string(), std::move(nodes)};
}

Node loader_node(const RootOptions& options, const std::vector<InitialSector>& sectors, const Node& world) {
  std::vector<std::string> ids;
  std::vector<double> origins;
  std::vector<Node> inlines, places;
  for (const auto& [s, detail] : sectors) {
    ids.push_back(s.id);
    for (const double v : root_position(s.origin)) origins.push_back(v);
  }
  for (const auto& place : world.nodes.front().nodes) {
    places.push_back(use_of(place));
    if (options.format != SceneFormat::vrml) inlines.push_back(use_of(place.nodes.front().nodes.front()));
  }
  Node script("Script", "LOADER");
  script.set("directOutput", true).set("url", std::vector<std::string>{options.loader_url});
  script.interface = {{"set_position", FieldType::sf_vec3f, Access::input_only, std::string(), {}},
                      {"set_orientation", FieldType::sf_rotation, Access::input_only, std::string(), {}},
                      field("start", FieldType::sf_string, sectors.front().sector.id),
                      field("base", FieldType::sf_string, options.base),
                      field("level", FieldType::sf_string, options.loader_level),
                      field("sector_test", FieldType::sf_string, options.loader_test),
                      field("ids", FieldType::mf_string, ids),
                      node_field("inlines", FieldType::mf_node, inlines),
                      node_field("places", FieldType::mf_node, places),
                      node_field("world", FieldType::sf_node, {use_of(world)}),
                      field("origins", FieldType::mf_vec3d, origins),
                      {"sector_changed", FieldType::sf_string, Access::output_only, std::string(), {}},
                      {"level_changed", FieldType::sf_string, Access::output_only, std::string(), {}}};
  return script;
}

}  // namespace

std::string start_sector(const RecordSource& source) {
  if (const auto named = source.meta("start"); !named.empty() && source.sector(named)) return named;
  const auto ids = source.sector_ids();
  assert(!ids.empty());
  std::string nearest;
  double least_mm = std::numeric_limits<double>::max();
  for (const auto& id : ids)
    for (const auto& v : source.viewpoints_of(id))
      if (const double mm = std::hypot(v.at.x, v.at.y); v.kind == "start" && mm < least_mm) {
        nearest = id;
        least_mm = mm;
      }
  if (!nearest.empty()) return nearest;
  for (const auto& id : ids)
    if (source.sector(id)->kind == SectorKind::square) return id;
  return ids.front();
}

std::optional<Scene> root_scene(const RecordSource& source, const RootOptions& options) {
  const auto start = source.sector(options.start.empty() ? start_sector(source) : options.start);
  if (!start) return std::nullopt;
  const auto sectors = initial_sectors(source, options, *start);
  const std::string name = source.meta("name").empty() ? "A city" : source.meta("name");

  Scene scene;
  scene.title = std::string("city") + suffix_of(options.format);
  scene.metas.emplace_back("description", name + ": walk through it street by street");
  if (!source.meta("name").empty()) scene.metas.emplace_back("subject", source.meta("name"));
  for (auto& meta : rights_of(source)) scene.metas.push_back(std::move(meta));
  if (const auto lat = source.meta("origin_lat"), lon = source.meta("origin_lon"); !lat.empty() && !lon.empty())
    scene.metas.emplace_back("origin", lat + " " + lon);
  if (!options.is_static) scene.metas.emplace_back("warning", kNeedsEval);
  if (!options.is_static && !options.parcels.empty() && options.format != SceneFormat::vrml)
    scene.metas.emplace_back("parcels", options.parcels);
  Node info("WorldInfo");
  std::vector<std::string> lines;
  for (const auto& [key, text] : rights_of(source)) lines.push_back(text);
  info.set("title", FieldValue(caption_of(name)));
  if (!lines.empty()) info.set("info", lines);
  scene.nodes.push_back(std::move(info));
  for (auto& node : surroundings({"WALK", "ANY"})) scene.nodes.push_back(std::move(node));
  for (auto& node : viewpoint_nodes(source, *start)) scene.nodes.push_back(std::move(node));

  Node world("Group", "WORLD");
  for (std::size_t i = 0; i < sectors.size(); ++i) world.add(place_node(source, options, sectors[i], i));
  scene.nodes.push_back(world);
  if (options.is_static) return scene;
  Node visitor("ProximitySensor", "VISITOR");
  visitor.set("center", root_position(start->origin));
  visitor.set("size", std::vector<double>{kSensorSide_m, kSensorHeight_m, kSensorSide_m});
  scene.nodes.push_back(std::move(visitor));
  scene.nodes.push_back(loader_node(options, sectors, world));
  scene.routes = {{"VISITOR", "position_changed", "LOADER", "set_position"},
                  {"VISITOR", "orientation_changed", "LOADER", "set_orientation"}};
  return scene;
}

std::optional<std::string> root_text(const RecordSource& source, const RootOptions& options) {
  const auto scene = root_scene(source, options);
  if (!scene) return std::nullopt;
  return write_scene(*scene, options.format);
}

}  // namespace vicus
