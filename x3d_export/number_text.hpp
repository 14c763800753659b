#pragma once
#include <string>

#include "x3d_export/scene.hpp"

namespace vicus {

/// Appends the numbers of a list, between them `between`: a space, or the comma of JSON.
/// Needs   `value` holds numbers; NumberText was made with the same `between`.
void append_number_list(std::string& out, FieldType type, const FieldValue& value, char between = ' ');

/// Long lists of a node and of all nodes below it become NumberText, so that who measures a node, perhaps copies it,
/// and writes it makes the text of its numbers once.
void spell_numbers(Node& node, char between);

}  // namespace vicus
