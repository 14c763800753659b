#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// One neutral scene tree, from which every format is written: x3d_writer, vrml_writer, x3dj_writer.
///
/// Node and field names are X3D 4.0's. field_table.hpp states every node and field that may occur; writers take types,
/// container fields and components from there.
namespace vicus {

/// Numbers of a list as one format has them (number_text.hpp).
struct NumberText {
  std::string text;
};

/// Number fields of every kind are a list of doubles; field_table tells how many belong together.
using FieldValue = std::variant<bool, std::string, std::vector<std::string>, std::vector<double>,
                                std::vector<std::int32_t>, NumberText>;

enum class FieldType {
  sf_bool,
  sf_string,
  mf_string,
  sf_float,
  sf_vec2f,
  sf_vec3f,
  sf_rotation,
  sf_color,
  mf_float,
  mf_double,
  mf_rotation,
  mf_vec2f,
  mf_vec3f,
  mf_vec3d,
  mf_color,
  mf_color_rgba,
  mf_int32,
  sf_image,
  sf_node,
  mf_node
};
enum class Access { initialize_only, input_only, output_only };

struct Node;

struct Field {
  std::string name;
  FieldValue value;
};

struct NodeField {
  std::string name;
  std::vector<Node> nodes;
};

/// A field that a Script declares for itself. Input and output fields have no value.
struct ScriptField {
  std::string name;
  FieldType type = FieldType::sf_string;
  Access access = Access::initialize_only;
  FieldValue value = std::string();
  std::vector<Node> nodes;
};

struct Node {
  std::string type, def, use;  ///< `use` given: nothing else is
  std::vector<Field> fields;
  std::vector<NodeField> nodes;
  std::vector<ScriptField> interface;

  Node() = default;
  explicit Node(std::string node_type, std::string def_name = {});
  /// Adds a field; returns *this.
  /// Needs   the field table lists it for this node with a type that `value` fits (assert).
  Node& set(std::string_view field, FieldValue value);
  Node& set(std::string_view field, const char* value) { return set(field, FieldValue(std::string(value))); }
  Node& set(std::string_view field, bool value) { return set(field, FieldValue(value)); }
  Node& set(std::string_view field, double value) { return set(field, FieldValue(std::vector<double>{value})); }
  /// Appends a node to a node field (`children`, `geometry`, ...); returns *this.
  Node& add(std::string_view field, Node node);
  Node& add(Node child) { return add("children", std::move(child)); }
};

Node use_of(const Node& node);  ///< Needs  node.def.

struct Route {
  std::string from_node, from_field, to_node, to_field;
};

struct Scene {
  std::string title;                                       ///< the file's name, without folder
  std::vector<std::pair<std::string, std::string>> metas;  ///< after the title
  std::vector<Node> nodes;
  std::vector<Route> routes;
};

}  // namespace vicus
