#include "x3d_export/field_table.hpp"

#include <algorithm>
#include <map>

namespace vicus {
namespace {

using enum FieldType;

const std::vector<NodeSpec>& node_specs() {
  static const std::vector<NodeSpec> kSpecs = {
      {"Anchor",
       "Networking",
       2,
       "children",
       true,
       {{"description", sf_string}, {"url", mf_string}, {"parameter", mf_string}, {"children", mf_node}}},
      {"Appearance",
       "Shape",
       1,
       "appearance",
       true,
       {{"material", sf_node}, {"texture", sf_node}, {"textureTransform", sf_node}, {"shaders", mf_node, false}}},
      {"BooleanToggle", "EventUtilities", 1, "children", false, {{"toggle", sf_bool}}},
      {"Background",
       "EnvironmentalEffects",
       1,
       "children",
       true,
       {{"skyAngle", mf_float}, {"skyColor", mf_color}, {"groundAngle", mf_float}, {"groundColor", mf_color}}},
      {"Color", "Rendering", 1, "color", true, {{"color", mf_color}}},
      {"ColorRGBA", "Rendering", 1, "color", false, {{"color", mf_color_rgba}}},
      {"ComposedShader", "Shaders", 1, "shaders", false, {{"language", sf_string}, {"parts", mf_node}}},
      {"Coordinate", "Rendering", 1, "coord", true, {{"point", mf_vec3f}}},
      {"DirectionalLight",
       "Lighting",
       1,
       "children",
       true,
       {{"ambientIntensity", sf_float}, {"color", sf_color}, {"direction", sf_vec3f}, {"intensity", sf_float}}},
      {"Group", "Grouping", 1, "children", true, {{"visible", sf_bool, false}, {"children", mf_node}}},
      {"IndexedFaceSet",
       "Geometry3D",
       2,
       "geometry",
       true,
       {{"solid", sf_bool},
        {"creaseAngle", sf_float},
        {"colorPerVertex", sf_bool},
        {"color", sf_node},
        {"coord", sf_node},
        {"texCoord", sf_node},
        {"colorIndex", mf_int32},
        {"texCoordIndex", mf_int32},
        {"coordIndex", mf_int32}}},
      {"ImageTexture",
       "Texturing",
       1,
       "texture",
       true,
       {{"load", sf_bool, false}, {"repeatS", sf_bool}, {"repeatT", sf_bool}, {"url", mf_string}}},
      {"Inline",
       "Networking",
       3,
       "children",
       true,
       {{"load", sf_bool, false}, {"bboxCenter", sf_vec3f}, {"bboxSize", sf_vec3f}, {"url", mf_string}}},
      {"LOD", "Navigation", 2, "children", false, {{"center", sf_vec3f}, {"range", mf_float}, {"children", mf_node}}},
      {"Material",
       "Shape",
       1,
       "material",
       true,
       {{"ambientIntensity", sf_float},
        {"diffuseColor", sf_color},
        {"emissiveColor", sf_color},
        {"transparency", sf_float}}},
      {"MetadataDouble", "Core", 1, "", false, {{"name", sf_string}, {"value", mf_double}}},
      {"MetadataInteger", "Core", 1, "", false, {{"name", sf_string}, {"value", mf_int32}}},
      {"MetadataSet", "Core", 1, "", false, {{"name", sf_string}, {"reference", sf_string}, {"value", mf_node}}},
      {"MetadataString", "Core", 1, "", false, {{"name", sf_string}, {"value", mf_string}}},
      {"NavigationInfo",
       "Navigation",
       1,
       "children",
       true,
       {{"avatarSize", mf_float},
        {"headlight", sf_bool},
        {"speed", sf_float},
        {"type", mf_string},
        {"visibilityLimit", sf_float}}},
      {"OrientationInterpolator", "Interpolation", 2, "children", true, {{"key", mf_float}, {"keyValue", mf_rotation}}},
      {"PointLight",
       "Lighting",
       2,
       "children",
       true,
       {{"ambientIntensity", sf_float},
        {"color", sf_color},
        {"intensity", sf_float},
        {"location", sf_vec3f},
        {"radius", sf_float}}},
      {"PositionInterpolator", "Interpolation", 2, "children", true, {{"key", mf_float}, {"keyValue", mf_vec3f}}},
      {"PixelTexture", "Texturing", 1, "texture", true, {{"image", sf_image}, {"textureProperties", sf_node, false}}},
      {"ProximitySensor", "EnvironmentalSensor", 1, "children", true, {{"center", sf_vec3f}, {"size", sf_vec3f}}},
      {"Script", "Scripting", 1, "children", true, {{"directOutput", sf_bool}, {"url", mf_string}}},
      {"ShaderPart", "Shaders", 1, "parts", false, {{"type", sf_string}, {"url", mf_string}}},
      {"Shape", "Shape", 1, "children", true, {{"appearance", sf_node}, {"geometry", sf_node}}},
      {"TextureCoordinate", "Texturing", 1, "texCoord", true, {{"point", mf_vec2f}}},
      {"TextureProperties",
       "Texturing",
       2,
       "textureProperties",
       false,
       {{"generateMipMaps", sf_bool}, {"minificationFilter", sf_string}, {"magnificationFilter", sf_string}}},
      {"TextureTransform", "Texturing", 1, "textureTransform", true, {{"scale", sf_vec2f}}},
      {"TimeSensor",
       "Time",
       1,
       "children",
       true,
       {{"cycleInterval", sf_float}, {"enabled", sf_bool}, {"loop", sf_bool}, {"startTime", sf_float}}},
      {"TouchSensor", "PointingDeviceSensor", 1, "children", true, {{"description", sf_string, false}}},
      {"Transform",
       "Grouping",
       1,
       "children",
       true,
       {{"translation", sf_vec3f}, {"rotation", sf_rotation}, {"scale", sf_vec3f}, {"children", mf_node}}},
      {"UnlitMaterial", "Shape", 3, "material", false, {{"emissiveColor", sf_color}, {"transparency", sf_float}}},
      {"Viewpoint",
       "Navigation",
       1,
       "children",
       true,
       {{"description", sf_string}, {"position", sf_vec3f}, {"orientation", sf_rotation}, {"fieldOfView", sf_float}}},
      {"WorldInfo",
       "Core",
       1,
       "children",
       true,
       {{"title", sf_string}, {"info", mf_string}, {"metadata", sf_node, false}}},
  };
  return kSpecs;
}

struct TypeSpec {
  FieldType type;
  std::string_view name;
  int width, decimals;
};

// Colours come from 8 bits: 3 decimals give them back. Coordinates come from the lattice: millimetres.
constexpr TypeSpec kTypes[] = {{sf_bool, "SFBool", 1, 0},         {sf_string, "SFString", 1, 0},
                               {mf_string, "MFString", 1, 0},     {sf_float, "SFFloat", 1, 6},
                               {sf_vec2f, "SFVec2f", 2, 3},       {sf_vec3f, "SFVec3f", 3, 3},
                               {sf_rotation, "SFRotation", 4, 6}, {sf_color, "SFColor", 3, 3},
                               {mf_float, "MFFloat", 1, 6},       {mf_double, "MFDouble", 1, 3},
                               {mf_rotation, "MFRotation", 4, 6}, {mf_vec2f, "MFVec2f", 2, 4},
                               {mf_vec3f, "MFVec3f", 3, 3},       {mf_vec3d, "MFVec3d", 3, 3},
                               {mf_color, "MFColor", 3, 3},       {mf_color_rgba, "MFColorRGBA", 4, 3},
                               {mf_int32, "MFInt32", 1, 0},       {sf_image, "SFImage", 1, 0},
                               {sf_node, "SFNode", 1, 0},         {mf_node, "MFNode", 1, 0}};

const TypeSpec& type_spec(FieldType type) {
  return *std::find_if(std::begin(kTypes), std::end(kTypes), [type](const TypeSpec& t) { return t.type == type; });
}

void add_components(const Node& node, std::map<std::string, int>& components) {
  if (!node.use.empty()) return;
  if (const NodeSpec* spec = find_node_spec(node.type)) {
    int& level = components[std::string(spec->component)];
    level = std::max(level, spec->level);
  }
  for (const auto& field : node.nodes)
    for (const auto& child : field.nodes) add_components(child, components);
}

}  // namespace

const NodeSpec* find_node_spec(std::string_view type) {
  for (const auto& spec : node_specs())
    if (spec.name == type) return &spec;
  return nullptr;
}

const FieldSpec* find_field_spec(const NodeSpec& node, std::string_view field) {
  for (const auto& spec : node.fields)
    if (spec.name == field) return &spec;
  return nullptr;
}

std::string_view name_of(FieldType type) { return type_spec(type).name; }
int decimals_of(FieldType type) { return type_spec(type).decimals; }
int width_of(FieldType type) { return type_spec(type).width; }

std::string_view name_of(Access access) {
  constexpr std::string_view kNames[] = {"initializeOnly", "inputOnly", "outputOnly"};
  return kNames[static_cast<int>(access)];
}

std::string_view vrml97_name_of(Access access) {
  constexpr std::string_view kNames[] = {"field", "eventIn", "eventOut"};
  return kNames[static_cast<int>(access)];
}

int interchange_level(std::string_view component) {
  constexpr std::pair<std::string_view, int> kLevels[] = {
      {"Core", 1},      {"Time", 1},          {"Networking", 1}, {"Grouping", 1},
      {"Rendering", 3}, {"Shape", 1},         {"Geometry3D", 2}, {"Lighting", 1},
      {"Texturing", 2}, {"Interpolation", 2}, {"Navigation", 1}, {"EnvironmentalEffects", 1}};
  for (const auto& [name, level] : kLevels)
    if (name == component) return level;
  return 0;
}

std::vector<std::pair<std::string, int>> components_of(const Scene& scene) {
  std::map<std::string, int> needed;
  for (const auto& node : scene.nodes) add_components(node, needed);
  std::vector<std::pair<std::string, int>> beyond;
  for (const auto& [name, level] : needed)
    if (level > interchange_level(name)) beyond.emplace_back(name, level);
  return beyond;
}

}  // namespace vicus
