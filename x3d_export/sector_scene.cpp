#include "x3d_export/sector_scene.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>

#include "city_db/surroundings.hpp"
#include "x3d_export/door_nodes.hpp"
#include "x3d_export/far_windows.hpp"
#include "x3d_export/ground_grain.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/impostor_nodes.hpp"
#include "x3d_export/object_nodes.hpp"
#include "x3d_export/panorama_nodes.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr int kMostParts = 1000, kMostShapes = 100'000;  // as wide as such numbers are written

struct SectorParts {
  const CityIndex& index;
  const Sector& sector;
  Detail detail;
  SceneFormat format;
  int only_level = 0;

  std::string stem() const {
    return sector.id + (detail == Detail::far ? ".far" : detail == Detail::tall ? ".tall" : "");
  }
  std::string place() const { return sector.name.empty() ? std::string(name_of(sector.kind)) : sector.name; }
};

std::string file_name(const SectorParts& parts, int part) {
  return parts.stem() + (part == 0 ? "" : "." + std::to_string(part)) + suffix_of(parts.format);
}

Scene empty_scene(const SectorParts& parts, int part) {
  Scene scene;
  scene.title = file_name(parts, part);
  scene.metas.emplace_back("description", parts.place() + ", a sector of a city" + (part ? ", in part" : ""));
  for (auto& meta : rights_of(source_of(parts.index))) scene.metas.push_back(std::move(meta));
  return scene;
}

/// The record goes where a Script can read it: X3D has metadata, VRML97's WorldInfo is closed, an Anchor's fields are
/// open.
void add_content(Scene& scene, const SectorParts& parts, std::vector<Node> content, int shapes) {
  Node info("WorldInfo");
  info.set("title", FieldValue(caption_of(parts.place())));
  if (parts.detail == Detail::near) {
    const SectorRecord record = sector_record(source_of(parts.index), parts.sector, shapes);
    if (parts.format == SceneFormat::vrml) {
      Node anchor("Anchor", "RECORD");
      anchor.set("description", "vicus record").set("parameter", std::vector<std::string>{record_json(record)});
      for (auto& node : content) anchor.add(std::move(node));
      content.assign(1, std::move(anchor));
    } else {
      info.add("metadata", record_node(record));
    }
  } else if (parts.detail == Detail::far) {
    info.add("metadata", links_node(sector_record(source_of(parts.index), parts.sector, shapes)));
  }
  scene.nodes.push_back(std::move(info));
  if (parts.detail == Detail::near)
    for (const Viewpoint* v : parts.index.viewpoints_of(parts.sector.id))
      scene.nodes.push_back(viewpoint_node(*v, parts.sector.origin, parts.place()));
  std::move(content.begin(), content.end(), std::back_inserter(scene.nodes));
}

/// A node and the bytes it takes in a file.
struct SizedNode {
  Node node;
  std::size_t size = 0;
};

SizedNode sized(Node node, SceneFormat format) {
  const std::size_t size = settled_size(node, format);
  return {std::move(node), size};
}

/// Each slice has a name of its own: of two Shapes of one name a file holds the first alone (share_equals).
Node layer_shape(const Layer& layer, std::span<const Face> faces, std::size_t slice) {
  const std::string name = slice == 0 ? layer.name : layer.name + "-" + std::to_string(slice + 1);
  if (layer.shading == Shading::backdrop) return fading_shape(name, faces);
  if (!layer.grain.empty()) return grained_shape(name, faces, texture_url(layer.grain));
  const bool has_windows = std::any_of(faces.begin(), faces.end(), [](const Face& face) { return face.bays > 0; });
  return has_windows ? windowed_shape(name, faces) : shape_of(name, layer.shading, faces);
}

/// A layer as Shapes, in as many slices as it takes that none is larger than `limit`.
std::vector<SizedNode> shapes_of(const Layer& layer, SceneFormat format, std::size_t limit) {
  for (std::size_t count = 1;; ++count) {
    std::vector<SizedNode> shapes;
    bool fits = true;
    const std::size_t n = layer.faces.size();
    for (std::size_t i = 0; i < count && fits; ++i) {
      const std::span<const Face> faces(layer.faces.data() + n * i / count, layer.faces.data() + n * (i + 1) / count);
      if (faces.empty()) continue;
      shapes.push_back(sized(layer_shape(layer, faces, i), format));
      fits = faces.size() == 1 || shapes.back().size <= limit;
      if (!fits) count = std::max(count, std::min(n, shapes.back().size * count / limit));
    }
    if (fits) return shapes;
  }
}

/// Equal images and models are sent and held once in a file: the first Appearance or Shape of each is DEFined, the
/// others USE it.
void share_equals(std::vector<Node>& nodes, std::set<std::string>& known) {
  for (Node& node : nodes) {
    if ((node.type == "Appearance" || node.type == "Shape") && !node.def.empty() && !known.insert(node.def).second)
      node = use_of(node);
    for (NodeField& field : node.nodes) share_equals(field.nodes, known);
  }
}

int count_all_shapes(const std::vector<Node>& nodes) {
  return std::accumulate(nodes.begin(), nodes.end(), 0, [](int n, const Node& node) { return n + count_shapes(node); });
}

/// Nodes in order, one list for each file: the first as large as `first`, the others as `limit`, but a list of one.
std::vector<std::vector<Node>> packed(std::vector<SizedNode> nodes, SceneFormat format, std::size_t first,
                                      std::size_t limit) {
  std::vector<std::vector<Node>> files(1);
  std::size_t room = first;
  std::set<std::string> known;  // what the file has already
  const auto size_with = [&](const Node& node) {
    std::vector<Node> copy{node};
    share_equals(copy, known);
    return written_size(copy.front(), format);
  };
  for (auto& [node, alone] : nodes) {
    // A house shares next to nothing with others.
    std::size_t size = node.type == "LOD" ? alone : size_with(node);
    if (size > room) {
      files.emplace_back();
      room = limit;
      known.clear();
      size = size_with(node);
    }
    room -= std::min(room, size);
    files.back().push_back(std::move(node));
  }
  return files;
}

void collect_defs(const std::vector<Node>& nodes, std::set<std::string>& defs) {
  for (const Node& node : nodes) {
    if (!node.def.empty()) defs.insert(node.def);
    for (const NodeField& field : node.nodes) collect_defs(field.nodes, defs);
  }
}

/// Those that join nodes of this list.
std::vector<Route> routes_within(const std::vector<Route>& routes, const std::vector<Node>& nodes) {
  std::vector<Route> out;
  if (routes.empty()) return out;
  std::set<std::string> defs;
  collect_defs(nodes, defs);
  for (const Route& r : routes)
    if (defs.contains(r.from_node) && defs.contains(r.to_node)) out.push_back(r);
  return out;
}

std::vector<SizedNode> content_of(const SectorParts& parts, const std::vector<Layer>& layers, std::size_t limit,
                                  std::vector<Route>& routes) {
  std::vector<SizedNode> nodes;
  // First, so that they are in the main file, where a loader looks for them.
  if (parts.detail == Detail::near && parts.format != SceneFormat::vrml) {
    for (Node& panorama : panorama_nodes(parts.index, parts.sector))
      nodes.push_back(sized(std::move(panorama), parts.format));
    for (Node& impostor : impostor_nodes(parts.index, parts.sector))
      nodes.push_back(sized(std::move(impostor), parts.format));
  }
  if (parts.detail == Detail::near)
    for (Node& door : door_nodes(parts.index, parts.sector)) nodes.push_back(sized(std::move(door), parts.format));
  for (const Layer& layer : layers)
    for (auto& shape : shapes_of(layer, parts.format, limit)) nodes.push_back(std::move(shape));
  if (parts.detail == Detail::near)
    for (Node& house : house_nodes(parts.index, parts.sector, parts.format, parts.only_level))
      nodes.push_back(sized(std::move(house), parts.format));
  if (parts.detail == Detail::near) {
    auto objects = object_nodes(parts.index, parts.sector, parts.format);
    for (Node& object : objects.nodes) nodes.push_back(sized(std::move(object), parts.format));
    routes = std::move(objects.routes);
  }
  return nodes;
}

Scene main_scene(const SectorParts& parts, std::vector<Node> content, int shapes, const std::vector<Route>& routes) {
  Scene scene = empty_scene(parts, 0);
  scene.routes = routes_within(routes, content);
  std::set<std::string> known;
  share_equals(content, known);
  add_content(scene, parts, std::move(content), shapes);
  return scene;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> rights_of(const RecordSource& source) {
  std::vector<std::pair<std::string, std::string>> metas;
  std::istringstream licences(source.meta("licences"));
  for (std::string line; std::getline(licences, line);)
    if (!line.empty()) metas.emplace_back("rights", line);
  return metas;
}

Node viewpoint_node(const Viewpoint& v, PlanPoint origin, const std::string& place) {
  const X3dPoint p = x3d_from_plan(v.at, height_mm(v.ground_m + v.eye_m), origin);
  Node node("Viewpoint");
  node.set("description", FieldValue(caption_of(v.name.empty() ? place : v.name)));
  node.set("position", std::vector<double>{metres(p.x), metres(p.y), metres(p.z)});
  node.set("fieldOfView", kFieldOfView);
  return node.set("orientation", std::vector<double>{0, 1, 0, x3d_yaw_from_heading(v.heading_deg)});
}

std::vector<ExportFile> sector_files(const CityIndex& index, const Sector& sector, Detail detail, SceneFormat format,
                                     std::size_t limit, int only_level) {
  const SectorParts parts{index, sector, detail, format, only_level};
  const auto layers = sector_layers(index, sector, detail);
  if (detail == Detail::tall && layers.empty()) return {};
  const std::size_t head = write_scene(main_scene(parts, {}, kMostShapes, {}), format).size();
  const std::size_t frame = write_scene(empty_scene(parts, kMostParts), format).size();
  constexpr std::size_t kRoute = 90;    // a ROUTE
  constexpr std::size_t kInline = 120;  // an Inline that draws a part in, with a long name
  const std::size_t room = limit - std::min(limit / 2, frame);
  std::vector<Route> routes;
  std::vector<SizedNode> nodes = content_of(parts, layers, room, routes);
  int shapes = 0;
  std::size_t size = 0;
  for (const SizedNode& n : nodes) {
    shapes += count_shapes(n.node);
    size += n.size;
  }
  const std::size_t inlines = kRoute * routes.size() + kInline * (size / room + 2);
  auto files = packed(std::move(nodes), format, limit - std::min(limit, head + inlines), room);

  std::vector<Node> content = std::move(files.front());
  std::vector<ExportFile> out(1);
  for (std::size_t i = 1; i < files.size(); ++i) {
    const int part = static_cast<int>(i);
    Node inline_node("Inline");
    content.push_back(inline_node.set("url", std::vector<std::string>{file_name(parts, part)}));
    Scene scene = empty_scene(parts, part);
    scene.nodes = std::move(files[i]);
    scene.routes = routes_within(routes, scene.nodes);
    const int own = count_all_shapes(scene.nodes);
    std::set<std::string> known;
    share_equals(scene.nodes, known);
    out.push_back({"sectors/" + scene.title, media_type_of(format), write_scene(scene, format), own});
  }
  const int own = count_all_shapes(content);
  const Scene scene = main_scene(parts, std::move(content), shapes, routes);
  out.front() = {"sectors/" + scene.title, media_type_of(format), write_scene(scene, format), own};
  return out;
}

}  // namespace vicus
