#include "x3d_export/scene.hpp"

#include <algorithm>
#include <cassert>

#include "x3d_export/field_table.hpp"

namespace vicus {
namespace {

[[maybe_unused]] bool fits(FieldType type, const FieldValue& value) {
  using enum FieldType;
  switch (type) {
    case sf_bool:
      return std::holds_alternative<bool>(value);
    case sf_string:
      return std::holds_alternative<std::string>(value);
    case mf_string:
      return std::holds_alternative<std::vector<std::string>>(value);
    case mf_int32:
    case sf_image:
      return std::holds_alternative<std::vector<std::int32_t>>(value);
    case sf_node:
    case mf_node:
      return false;
    default:
      break;
  }
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (!numbers) return false;
  const auto width = static_cast<std::size_t>(width_of(type));
  const bool single =
      type == sf_float || type == sf_vec2f || type == sf_vec3f || type == sf_rotation || type == sf_color;
  return single ? numbers->size() == width : numbers->size() % width == 0;
}

}  // namespace

Node::Node(std::string node_type, std::string def_name) : type(std::move(node_type)), def(std::move(def_name)) {
  assert(find_node_spec(type));
}

Node& Node::set(std::string_view field, FieldValue value) {
  assert(find_field_spec(*find_node_spec(type), field));
  assert(fits(find_field_spec(*find_node_spec(type), field)->type, value));
  fields.push_back({std::string(field), std::move(value)});
  return *this;
}

Node& Node::add(std::string_view field, Node node) {
  assert(find_field_spec(*find_node_spec(type), field));
  const auto at = std::find_if(nodes.begin(), nodes.end(), [&](const NodeField& f) { return f.name == field; });
  if (at == nodes.end())
    nodes.push_back({std::string(field), {std::move(node)}});
  else
    at->nodes.push_back(std::move(node));
  return *this;
}

Node use_of(const Node& node) {
  assert(!node.def.empty());
  Node use(node.type);
  use.use = node.def;
  return use;
}

}  // namespace vicus
