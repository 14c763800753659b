#include "x3d_export/sector_scene.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "x3d_export/text.hpp"

namespace vicus {
namespace {

/// rad, up and down: in a narrow street one sees the eaves and the ground at once.
constexpr double kFieldOfView = 0.95;
constexpr int kMostParts = 1000;  // a stop for the loop; 100 MB of one sector

struct SectorParts {
  const CityIndex& index;
  const Sector& sector;
  Detail detail;
  SceneFormat format;
  std::vector<Layer> layers;

  std::string stem() const {
    return sector.id + (detail == Detail::far ? ".far" : detail == Detail::tall ? ".tall" : "");
  }
  std::string place() const { return sector.name.empty() ? std::string(name_of(sector.kind)) : sector.name; }
};

std::string file_name(const SectorParts& parts, int part) {
  return parts.stem() + (part == 0 ? "" : "." + std::to_string(part)) + suffix_of(parts.format);
}

/// Shapes of slice `part` of `count` of each layer.
std::vector<Node> shapes_of(const SectorParts& parts, int part, int count) {
  std::vector<Node> shapes;
  for (const auto& layer : parts.layers) {
    const auto n = layer.faces.size(), k = static_cast<std::size_t>(count), i = static_cast<std::size_t>(part);
    const std::span<const Face> faces(layer.faces.data() + n * i / k, layer.faces.data() + n * (i + 1) / k);
    if (!faces.empty()) shapes.push_back(shape_of(layer.name, layer.surface, faces));
  }
  return shapes;
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
  }
  scene.nodes.push_back(std::move(info));
  if (parts.detail == Detail::near)
    for (const Viewpoint* v : parts.index.viewpoints_of(parts.sector.id))
      scene.nodes.push_back(viewpoint_node(*v, parts.sector.origin, parts.place()));
  std::move(content.begin(), content.end(), std::back_inserter(scene.nodes));
}

/// The sector in `count` parts, all in the main file when count is 1.
std::vector<ExportFile> write_parts(const SectorParts& parts, int count) {
  std::vector<Scene> scenes{empty_scene(parts, 0)};
  std::vector<int> shapes(static_cast<std::size_t>(count == 1 ? 1 : count + 1), 0);
  std::vector<Node> content;
  if (count == 1) {
    content = shapes_of(parts, 0, 1);
    shapes[0] = static_cast<int>(content.size());
  } else {
    for (int part = 1; part <= count; ++part) {
      Node inline_node("Inline");
      content.push_back(inline_node.set("url", std::vector<std::string>{file_name(parts, part)}));
      scenes.push_back(empty_scene(parts, part));
      scenes.back().nodes = shapes_of(parts, part - 1, count);
      shapes[static_cast<std::size_t>(part)] = static_cast<int>(scenes.back().nodes.size());
    }
  }
  add_content(scenes.front(), parts, std::move(content), std::accumulate(shapes.begin(), shapes.end(), 0));
  std::vector<ExportFile> files;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    files.push_back(
        {"sectors/" + scenes[i].title, media_type_of(parts.format), write_scene(scenes[i], parts.format), shapes[i]});
  return files;
}

std::size_t largest(const std::vector<ExportFile>& files, std::size_t first) {
  std::size_t bytes = 0;
  for (std::size_t i = first; i < files.size(); ++i) bytes = std::max(bytes, files[i].text.size());
  return bytes;
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
  const X3dPoint p = x3d_from_plan(v.at, height_mm(v.eye_m), origin);
  Node node("Viewpoint");
  node.set("description", FieldValue(caption_of(v.name.empty() ? place : v.name)));
  node.set("position", std::vector<double>{metres(p.x), metres(p.y), metres(p.z)});
  node.set("fieldOfView", kFieldOfView);
  return node.set("orientation", std::vector<double>{0, 1, 0, x3d_yaw_from_heading(v.heading_deg)});
}

std::vector<ExportFile> sector_files(const CityIndex& index, const Sector& sector, Detail detail, SceneFormat format,
                                     std::size_t limit) {
  const SectorParts parts{index, sector, detail, format, sector_layers(index, sector, detail)};
  if (detail == Detail::tall && parts.layers.empty()) return {};
  std::vector<ExportFile> files = write_parts(parts, 1);
  const std::size_t whole = files.front().text.size();
  if (whole <= limit) return files;
  for (int count = std::max(2, static_cast<int>(whole / limit)); count <= kMostParts; ++count) {
    files = write_parts(parts, count);
    if (largest(files, 1) <= limit) break;
  }
  return files;
}

}  // namespace vicus
