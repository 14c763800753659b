#pragma once
#include <string_view>
#include <vector>

#include "x3d_export/scene.hpp"

/// The one table of nodes and fields that our files use: types, container fields, components, and what VRML97 has.
namespace vicus {

struct FieldSpec {
  std::string_view name;
  FieldType type;
  bool in_vrml97 = true;
};

struct NodeSpec {
  std::string_view name;
  std::string_view component;
  int level;                   ///< of the component, as our fields need it
  std::string_view container;  ///< containerField when none is said; empty: readers disagree, so it is always said
  bool in_vrml97;
  std::vector<FieldSpec> fields;
};

/// nullptr: our files never contain such a node, or field.
const NodeSpec* find_node_spec(std::string_view type);
const FieldSpec* find_field_spec(const NodeSpec& node, std::string_view field);

/// "SFVec3f", ...: as X3D writes the type.
std::string_view name_of(FieldType type);
/// Decimals written for a number field: lengths to the millimetre, rotations to a micro-radian.
int decimals_of(FieldType type);
/// Numbers per value: 3 for SFVec3f and MFVec3f, 4 for SFRotation, else 1.
int width_of(FieldType type);
/// "inputOnly", ... and in VRML97 "eventIn", ...
std::string_view name_of(Access access);
std::string_view vrml97_name_of(Access access);
/// Level of a component that the Interchange profile brings by itself; 0 where it brings none.
int interchange_level(std::string_view component);
/// Components, with levels, that the scene needs beyond the Interchange profile, by name.
std::vector<std::pair<std::string, int>> components_of(const Scene& scene);

}  // namespace vicus
