#include <cassert>

#include "x3d_export/field_table.hpp"
#include "x3d_export/number_text.hpp"
#include "x3d_export/text.hpp"
#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

std::string quoted_list(const std::vector<std::string>& strings) {
  std::string out;
  for (const auto& s : strings) out += (out.empty() ? "" : " ") + vrml_quoted(s);
  return out;
}

/// Appends the value as it stands between the apostrophes of an attribute.
void append_value(std::string& out, FieldType type, const FieldValue& value) {
  if (const auto* b = std::get_if<bool>(&value))
    out += *b ? "true" : "false";
  else if (const auto* s = std::get_if<std::string>(&value))
    out += xml_escaped(*s);
  else if (const auto* list = std::get_if<std::vector<std::string>>(&value))
    out += xml_escaped(quoted_list(*list));
  else
    append_number_list(out, type, value);
}

class X3dWriter {
 public:
  std::string write(const Scene& scene) {
    out_ =
        "<?xml version='1.0' encoding='UTF-8'?>\n"
        "<X3D profile='Interchange' version='4.0' xmlns:xsd='http://www.w3.org/2001/XMLSchema-instance'\n"
        "     xsd:noNamespaceSchemaLocation='https://www.web3d.org/specifications/x3d-4.0.xsd'>\n<head>\n";
    for (const auto& [name, level] : components_of(scene))
      out_ += "<component name='" + name + "' level='" + std::to_string(level) + "'/>\n";
    meta("title", scene.title);
    meta("generator", kGenerator);
    for (const auto& [name, content] : scene.metas) meta(name, content);
    out_ += "</head>\n<Scene>\n";
    for (const auto& node : scene.nodes) write_node(node, "children");
    for (const auto& r : scene.routes)
      out_ += "<ROUTE fromNode='" + r.from_node + "' fromField='" + r.from_field + "' toNode='" + r.to_node +
              "' toField='" + r.to_field + "'/>\n";
    out_ += "</Scene>\n</X3D>\n";
    return std::move(out_);
  }

  std::size_t size(const Node& node) {
    write_node(node, "children");
    return out_.size();
  }

 private:
  void meta(std::string_view name, std::string_view content) {
    out_ += "<meta name='" + xml_escaped(name) + "' content='" + xml_escaped(content) + "'/>\n";
  }
  void attribute(std::string_view name, std::string_view value) {
    out_.append(" ").append(name).append("='").append(value).append("'");
  }
  void attribute(std::string_view name, FieldType type, const FieldValue& value) {
    out_.append(" ").append(name).append("='");
    append_value(out_, type, value);
    out_ += '\'';
  }

  void write_node(const Node& node, std::string_view container) {
    const NodeSpec& spec = *find_node_spec(node.type);
    out_ += '<' + node.type;
    if (!node.def.empty()) attribute("DEF", node.def);
    if (!node.use.empty()) attribute("USE", node.use);
    for (const auto& f : node.fields) attribute(f.name, find_field_spec(spec, f.name)->type, f.value);
    // A Script's own fields hold nodes by the field's name, which is no containerField.
    if (container != spec.container && !container.empty()) attribute("containerField", container);
    if (node.nodes.empty() && node.interface.empty()) {
      out_ += "/>\n";
      return;
    }
    out_ += ">\n";
    for (const auto& f : node.interface) write_interface(f);
    for (const auto& f : node.nodes)
      for (const auto& child : f.nodes) write_node(child, f.name);
    out_ += "</" + node.type + ">\n";
  }

  void write_interface(const ScriptField& f) {
    out_ += "<field";
    attribute("name", f.name);
    attribute("type", name_of(f.type));
    attribute("accessType", name_of(f.access));
    const bool is_node = f.type == FieldType::sf_node || f.type == FieldType::mf_node;
    if (f.access == Access::initialize_only && !is_node) attribute("value", f.type, f.value);
    if (f.nodes.empty()) {
      out_ += "/>\n";
      return;
    }
    out_ += ">\n";
    for (const auto& node : f.nodes) write_node(node, "");
    out_ += "</field>\n";
  }

  std::string out_;
};

}  // namespace

std::string write_x3d(const Scene& scene) { return X3dWriter().write(scene); }
std::size_t size_in_x3d(const Node& node) { return X3dWriter().size(node); }

std::string write_scene(const Scene& scene, SceneFormat format) {
  switch (format) {
    case SceneFormat::x3d:
      return write_x3d(scene);
    case SceneFormat::vrml:
      return write_vrml(scene);
    case SceneFormat::x3dj:
      return write_x3dj(scene);
  }
  assert(false);
  return {};
}

std::size_t written_size(const Node& node, SceneFormat format) {
  switch (format) {
    case SceneFormat::x3d:
      return size_in_x3d(node);
    case SceneFormat::vrml:
      return size_in_vrml(node);
    case SceneFormat::x3dj:
      return size_in_x3dj(node);
  }
  assert(false);
  return 0;
}

std::size_t settled_size(Node& node, SceneFormat format) {
  spell_numbers(node, format == SceneFormat::x3dj ? ',' : ' ');
  return written_size(node, format);
}

const char* suffix_of(SceneFormat format) {
  constexpr const char* kSuffixes[] = {".x3d", ".wrl", ".x3dj"};
  return kSuffixes[static_cast<int>(format)];
}

const char* media_type_of(SceneFormat format) {
  constexpr const char* kTypes[] = {"model/x3d+xml", "model/vrml", "model/x3d+json"};
  return kTypes[static_cast<int>(format)];
}

}  // namespace vicus
