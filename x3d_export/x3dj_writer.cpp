#include <nlohmann/json.hpp>

#include "x3d_export/field_table.hpp"
#include "x3d_export/number_text.hpp"
#include "x3d_export/text.hpp"
#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

std::string json_string(std::string_view text) { return nlohmann::json(clean_text(text)).dump(); }

bool is_scalar(FieldType type) { return type == FieldType::sf_float; }

std::string json_value(FieldType type, const FieldValue& value) {
  if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const auto* s = std::get_if<std::string>(&value)) return json_string(*s);
  std::string out = is_scalar(type) ? "" : "[";
  if (const auto* list = std::get_if<std::vector<std::string>>(&value)) {
    for (const auto& s : *list) out += (out.size() > 1 ? "," : "") + json_string(s);
  } else {
    append_number_list(out, type, value, ',');
  }
  return is_scalar(type) ? out : out + "]";
}

/// X3D JSON: attributes are "@name", node fields "-name", a node is an object with its type as only key.
class X3djWriter {
 public:
  std::string write(const Scene& scene) {
    out_ = "{\"X3D\":{\"encoding\":\"UTF-8\",\"@profile\":\"Interchange\",\"@version\":\"4.0\",\n\"head\":{";
    const auto components = components_of(scene);
    for (const auto& [name, level] : components)
      out_ += (out_.back() == '{' ? "\"component\":[" : ",") + std::string("{\"@name\":") + json_string(name) +
              ",\"@level\":" + std::to_string(level) + "}";
    if (!components.empty()) out_ += "],\n";
    out_ += "\"meta\":[";
    meta("title", scene.title);
    meta("generator", kGenerator);
    for (const auto& [name, content] : scene.metas) meta(name, content);
    out_ += "]},\n\"Scene\":{\"-children\":[\n";
    for (const auto& node : scene.nodes) write_node(node);
    for (const auto& r : scene.routes) {
      separate('[');
      out_ += "{\"ROUTE\":{\"@fromNode\":" + json_string(r.from_node) + ",\"@fromField\":" + json_string(r.from_field) +
              ",\"@toNode\":" + json_string(r.to_node) + ",\"@toField\":" + json_string(r.to_field) + "}}";
    }
    out_ += "\n]}}}\n";
    return std::move(out_);
  }

  std::size_t size(const Node& node) {
    out_ = ",";  // so that the next one is told from it
    write_node(node);
    return out_.size();
  }

 private:
  /// A comma and a line break, but after the opening bracket.
  void separate(char opening) {
    const auto last = out_.find_last_not_of('\n');
    if (out_[last] != opening) out_ += ",\n";
  }

  void meta(std::string_view name, std::string_view content) {
    separate('[');
    out_ += "{\"@name\":" + json_string(name) + ",\"@content\":" + json_string(content) + "}";
  }

  void key(const std::string& name, const std::string& value) {
    separate('{');
    out_ += "\"" + name + "\":" + value;
  }

  void write_node(const Node& node) {
    separate('[');
    write_object(node);
  }

  void write_object(const Node& node) {
    const NodeSpec& spec = *find_node_spec(node.type);
    out_ += "{\"" + node.type + "\":{";
    if (!node.def.empty()) key("@DEF", json_string(node.def));
    if (!node.use.empty()) key("@USE", json_string(node.use));
    for (const auto& f : node.fields) key("@" + f.name, json_value(find_field_spec(spec, f.name)->type, f.value));
    if (!node.interface.empty()) {
      key("field", "[");
      for (const auto& f : node.interface) write_interface(f);
      out_ += "]";
    }
    for (const auto& f : node.nodes) write_nodes(f.name, find_field_spec(spec, f.name)->type, f.nodes);
    out_ += "}}";
  }

  void write_nodes(const std::string& name, FieldType type, const std::vector<Node>& nodes) {
    if (type == FieldType::sf_node) {
      key("-" + name, "");
      write_object(nodes.front());
      return;
    }
    key("-" + name, "[");
    for (const auto& child : nodes) write_node(child);
    out_ += "]";
  }

  void write_interface(const ScriptField& f) {
    separate('[');
    out_ += "{";
    key("@name", json_string(f.name));
    key("@type", json_string(name_of(f.type)));
    key("@accessType", json_string(name_of(f.access)));
    const bool is_node = f.type == FieldType::sf_node || f.type == FieldType::mf_node;
    if (f.access == Access::initialize_only && !is_node) key("@value", json_value(f.type, f.value));
    if (!f.nodes.empty()) write_nodes("children", FieldType::mf_node, f.nodes);
    out_ += "}";
  }

  std::string out_;
};

}  // namespace

std::string write_x3dj(const Scene& scene) { return X3djWriter().write(scene); }
std::size_t size_in_x3dj(const Node& node) { return X3djWriter().size(node); }

}  // namespace vicus
