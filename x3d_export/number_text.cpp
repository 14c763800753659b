#include "x3d_export/number_text.hpp"

#include "x3d_export/field_table.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr std::size_t kLong = 16;  // numbers: fewer are made again as quickly as found

bool is_long(const FieldValue& value) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return numbers->size() >= kLong;
  if (const auto* indices = std::get_if<std::vector<std::int32_t>>(&value)) return indices->size() >= kLong;
  return false;
}

}  // namespace

void append_number_list(std::string& out, FieldType type, const FieldValue& value, char between) {
  if (const auto* done = std::get_if<NumberText>(&value))
    out += done->text;
  else if (const auto* indices = std::get_if<std::vector<std::int32_t>>(&value))
    append_indices(out, *indices, between);
  else
    append_numbers(out, std::get<std::vector<double>>(value), decimals_of(type), width_of(type), between);
}

void spell_numbers(Node& node, char between) {
  for (Field& field : node.fields) {
    if (!is_long(field.value)) continue;
    NumberText spelled;
    append_number_list(spelled.text, find_field_spec(*find_node_spec(node.type), field.name)->type, field.value,
                       between);
    field.value = std::move(spelled);
  }
  for (NodeField& field : node.nodes)
    for (Node& child : field.nodes) spell_numbers(child, between);
}

}  // namespace vicus
