#include <algorithm>

#include "x3d_export/field_table.hpp"
#include "x3d_export/number_text.hpp"
#include "x3d_export/text.hpp"
#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

bool is_single(FieldType type) {
  using enum FieldType;
  return type == sf_bool || type == sf_string || type == sf_float || type == sf_vec2f || type == sf_vec3f ||
         type == sf_rotation || type == sf_color || type == sf_image || type == sf_node;
}

/// VRML97 has no doubles.
std::string_view vrml97_type(FieldType type) {
  if (type == FieldType::mf_vec3d) return name_of(FieldType::mf_vec3f);
  if (type == FieldType::mf_double) return name_of(FieldType::mf_float);
  return name_of(type);
}

bool is_unloaded(const Node& node) {
  return node.type == "Inline" && std::any_of(node.fields.begin(), node.fields.end(), [](const Field& f) {
           return f.name == "load" && !std::get<bool>(f.value);
         });
}

class VrmlWriter {
 public:
  std::string write(const Scene& scene) {
    out_ = "#VRML V2.0 utf8\n";
    comment("title", scene.title);
    comment("generator", kGenerator);
    for (const auto& [name, content] : scene.metas) comment(name, content);
    for (const auto& node : scene.nodes)
      if (is_written(node)) write_node(node);
    for (const auto& r : scene.routes)
      out_ += "ROUTE " + r.from_node + "." + r.from_field + " TO " + r.to_node + "." + r.to_field + "\n";
    return std::move(out_);
  }

  std::size_t size(const Node& node) {
    if (is_written(node)) write_node(node);
    return out_.size();
  }

 private:
  void comment(std::string_view name, std::string_view content) {
    out_ += "# " + clean_text(name) + ": " + clean_text(content) + "\n";
  }

  /// A USE is written only when its DEF was.
  bool is_written(const Node& node) const {
    if (!node.use.empty()) return std::find(defs_.begin(), defs_.end(), node.use) != defs_.end();
    return find_node_spec(node.type)->in_vrml97 && !is_unloaded(node);
  }

  void write_value(FieldType type, const FieldValue& value) {
    if (const auto* b = std::get_if<bool>(&value)) {
      out_ += *b ? "TRUE" : "FALSE";
      return;
    }
    if (const auto* s = std::get_if<std::string>(&value)) {
      out_ += vrml_quoted(*s);
      return;
    }
    if (!is_single(type)) out_ += "[ ";
    if (const auto* list = std::get_if<std::vector<std::string>>(&value))
      for (const auto& s : *list) out_ += vrml_quoted(s) + " ";
    else
      append_number_list(out_, type, value);
    if (!is_single(type)) out_ += " ]";
  }

  void write_nodes(FieldType type, const std::vector<Node>& nodes) {
    if (!is_single(type)) out_ += "[\n";
    for (const auto& node : nodes)
      if (is_written(node)) write_node(node);
    if (!is_single(type)) out_ += "]\n";
  }

  void write_node(const Node& node) {
    if (!node.use.empty()) {
      out_ += "USE " + node.use + "\n";
      return;
    }
    if (!node.def.empty()) {
      out_ += "DEF " + node.def + " ";
      defs_.push_back(node.def);
    }
    out_ += node.type + " {\n";
    const NodeSpec& spec = *find_node_spec(node.type);
    for (const auto& f : node.interface) write_interface(f);
    for (const auto& f : node.fields) {
      const FieldSpec& field = *find_field_spec(spec, f.name);
      if (!field.in_vrml97) continue;
      out_ += f.name + " ";
      write_value(field.type, f.value);
      out_ += "\n";
    }
    for (const auto& f : node.nodes) {
      const FieldSpec& field = *find_field_spec(spec, f.name);
      const bool is_empty = std::none_of(f.nodes.begin(), f.nodes.end(), [&](const Node& n) { return is_written(n); });
      if (!field.in_vrml97 || is_empty) continue;
      out_ += f.name + " ";
      write_nodes(field.type, f.nodes);
    }
    out_ += "}\n";
  }

  void write_interface(const ScriptField& f) {
    out_.append(vrml97_name_of(f.access)).append(" ").append(vrml97_type(f.type)).append(" ").append(f.name);
    if (f.access == Access::initialize_only) {
      out_ += " ";
      if (f.type == FieldType::sf_node || f.type == FieldType::mf_node)
        write_nodes(f.type, f.nodes);
      else
        write_value(f.type, f.value);
    }
    out_ += "\n";
  }

  std::string out_;
  std::vector<std::string> defs_;
};

}  // namespace

std::string write_vrml(const Scene& scene) { return VrmlWriter().write(scene); }
std::size_t size_in_vrml(const Node& node) { return VrmlWriter().size(node); }

}  // namespace vicus
