#include "x3d_export/flyover_scene.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "city_db/surroundings.hpp"
#include "city_db/tile_tree.hpp"
#include "x3d_export/root_scene.hpp"
#include "x3d_export/sector_scene.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr double kSensorSide_m = 200'000, kSensorHeight_m = 20'000;
constexpr double kUnknownHalf_m = 500;
/// Where two thirds of a colour are haze: the city is seen to its rim, and where the ground ends it is as the sky.
constexpr double kLeastHaze_m = 5'000, kMostHaze_m = 15'000, kHazePerHalf = 0.75;
constexpr double kBack = 0.75, kUp = 0.6;  // of the city's half side: a view over all of it

ScriptField field(const char* name, FieldType type, FieldValue value) {
  return {name, type, Access::initialize_only, std::move(value), {}};
}
ScriptField node_field(const char* name, std::vector<Node> nodes) {
  return {name, FieldType::sf_node, Access::initialize_only, std::string(), std::move(nodes)};
}

double half_side_m(const RecordSource& source) {
  const std::string text = source.meta("tile_levels");
  int levels = 0;
  std::from_chars(text.data(), text.data() + text.size(), levels);
  if (levels < 1 || levels > kMostTileLevels) return kUnknownHalf_m;
  return metres(tile_side_mm(levels, 0)) / 2;
}

Node shader_part(const char* type, const std::string& url) {
  Node part("ShaderPart");
  return part.set("type", type).set("url", std::vector<std::string>{url});
}

/// `name`: of its two parts' files. `is_lit`: its colours have the light in them.
Node shader_node(const char* def, const std::string& name, double half_m, bool is_lit) {
  std::vector<double> directions, intensities;
  for (const SunLight& light : kLights) {
    directions.insert(directions.end(), std::begin(light.direction), std::end(light.direction));
    intensities.push_back(light.intensity);
  }
  Node shader("ComposedShader", def);
  shader.set("language", "GLSL");
  if (!is_lit)
    shader.interface = {field("lightDirections", FieldType::mf_vec3f, directions),
                        field("lightIntensities", FieldType::mf_float, intensities)};
  const ScriptField haze[] = {
      field("hazeColour", FieldType::sf_color,
            std::vector<double>{kSkyColour.r / 255.0, kSkyColour.g / 255.0, kSkyColour.b / 255.0}),
      field("hazeDistance", FieldType::sf_float,
            std::vector<double>{std::clamp(kHazePerHalf * half_m, kLeastHaze_m, kMostHaze_m)})};
  shader.interface.insert(shader.interface.end(), std::begin(haze), std::end(haze));
  shader.add("parts", shader_part("VERTEX", "client/x3d/" + name + ".vert"));
  return shader.add("parts", shader_part("FRAGMENT", "client/x3d/" + name + ".frag"));
}

}  // namespace

Scene flyover_scene(const RecordSource& source) {
  const double half_m = half_side_m(source);
  const std::string name = source.meta("name").empty() ? "The city" : source.meta("name");
  Scene scene;
  scene.title = kFlyoverName;
  scene.metas.emplace_back("description", name + " from above: fly over it");
  for (auto& meta : rights_of(source)) scene.metas.push_back(std::move(meta));
  scene.metas.emplace_back("warning", kNeedsEval);
  Node info("WorldInfo");
  scene.nodes.push_back(info.set("title", FieldValue(name + " from above")));
  for (auto& node : surroundings({"FLY", "ANY"})) scene.nodes.push_back(std::move(node));
  Node view("Viewpoint", "OVERVIEW");
  view.set("description", "The city from above");
  view.set("position", std::vector<double>{0, kUp * half_m, kBack * half_m});
  view.set("orientation", std::vector<double>{1, 0, 0, -std::atan2(kUp, kBack)});
  scene.nodes.push_back(view.set("fieldOfView", kFieldOfView));
  // Shapes that draw nothing bring the shaders; each tile's Appearance uses one: one program for all of a kind.
  const Node shaders[] = {shader_node("TILE_SHADER", "flyover", half_m, false),
                          shader_node("BLOCKMAP_SHADER", "blockmap", half_m, true)};
  for (const Node& shader : shaders) {
    Node look("Appearance"), sample("Shape");
    scene.nodes.push_back(sample.add("appearance", look.add("shaders", shader)));
  }
  Node tiles("Group", "TILES"), sensor("ProximitySensor", "VISITOR"), clock("TimeSensor", "CLOCK"),
      flyer("Script", "FLYER");
  scene.nodes.push_back(tiles);
  scene.nodes.push_back(sensor.set("size", std::vector<double>{kSensorSide_m, kSensorHeight_m, kSensorSide_m}));
  scene.nodes.push_back(clock.set("loop", true));
  flyer.set("directOutput", true).set("url", std::vector<std::string>{"client/flyer.js"});
  flyer.interface = {
      {"set_position", FieldType::sf_vec3f, Access::input_only, std::string(), {}},
      {"set_orientation", FieldType::sf_rotation, Access::input_only, std::string(), {}},
      {"set_fraction", FieldType::sf_float, Access::input_only, std::string(), {}},
      field("base", FieldType::sf_string, std::string("blockmaps/")),
      field("layouts", FieldType::sf_string, std::string("client/layout/")),
      {"shaders", FieldType::mf_node, Access::initialize_only, std::string(), {use_of(shaders[0]), use_of(shaders[1])}},
      node_field("world", {use_of(tiles)}),
      node_field("clock", {use_of(clock)})};
  scene.nodes.push_back(std::move(flyer));
  scene.routes = {{"VISITOR", "position_changed", "FLYER", "set_position"},
                  {"VISITOR", "orientation_changed", "FLYER", "set_orientation"},
                  {"CLOCK", "fraction_changed", "FLYER", "set_fraction"}};
  return scene;
}

}  // namespace vicus
