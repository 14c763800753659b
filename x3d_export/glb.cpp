#include "x3d_export/glb.hpp"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <set>

#include "x3d_export/draco_mesh.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/meshopt_mesh.hpp"
#include "x3d_export/object_nodes.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kByte = 5120, kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126,
              kRepeat = 10497;
constexpr int kImageLevel = 3;

/// What one file is made of: faces by colour, one list for each side that is seen, and faces by image.
struct Content {
  std::vector<Face> solid, two_sided, backdrop;
  std::map<std::string, std::vector<TexturedFace>> by_image;

  std::vector<Face>& of(Shading shading) {
    return shading == Shading::solid ? solid : shading == Shading::two_sided ? two_sided : backdrop;
  }
  LatticeBox box() const {
    LatticeBox box{{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    for (const auto* faces : {&solid, &two_sided, &backdrop})
      for (const Face& face : *faces)
        for (int k = 0; k < face.count; ++k) box.add(face.corners[static_cast<std::size_t>(k)]);
    for (const auto& [image, faces] : by_image)
      for (const TexturedFace& face : faces)
        for (const X3dPoint& p : face.corners) box.add(p);
    return box;
  }
};

Content content_of(const CityIndex& index, const Sector& sector, Detail detail) {
  assert(detail != Detail::tall);
  Content content;
  for (Layer& layer : sector_layers(index, sector, detail)) {
    auto& list = content.of(layer.shading);
    list.insert(list.end(), layer.faces.begin(), layer.faces.end());
  }
  if (detail == Detail::far) return content;
  const auto objects = object_faces(index, sector);
  content.solid.insert(content.solid.end(), objects.begin(), objects.end());
  LevelFaces facades = sector_facades(index, sector, kImageLevel);
  content.solid.insert(content.solid.end(), facades.solid.begin(), facades.solid.end());
  content.by_image = std::move(facades.own_images);
  if (!facades.atlas.empty()) {
    auto& list = content.by_image[index.city().meta.at("atlas")];
    list.insert(list.end(), facades.atlas.begin(), facades.atlas.end());
  }
  return content;
}

/// The JSON and the one buffer of a GLB under way.
class GlbWriter {
 public:
  GlbWriter(const LatticeBox& lattice, const GlbOptions& options) : lattice_(lattice), options_(options) {
    if (options.coding == GlbCoding::meshopt && !lattice.is_empty())
      options_.step_mm = meshopt_step_mm(lattice, options.step_mm);
  }

  void add_solid(std::span<const Face> faces, Json material) {
    if (!faces.empty()) add_primitive(faces, "COLOR_0", std::move(material));
  }

  void add_textured(std::span<const TexturedFace> faces, const std::string& png) {
    images_.push_back({{"bufferView", add_bytes(png)}, {"mimeType", "image/png"}});
    textures_.push_back({{"sampler", 0}, {"source", images_.size() - 1}});
    add_primitive(
        faces, "TEXCOORD_0",
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", textures_.size() - 1}}}, {"metallicFactor", 0}}}});
  }

  std::string file(Json asset, Json node) {
    Json gltf{{"asset", std::move(asset)}};
    if (!primitives_.empty()) {
      gltf["extensionsUsed"] = gltf["extensionsRequired"] =
          is_draco() ? Json::array({"KHR_draco_mesh_compression"})
                     : Json::array({"EXT_meshopt_compression", "KHR_mesh_quantization"});
      if (is_unlit_) gltf["extensionsUsed"].push_back("KHR_materials_unlit");
      gltf["meshes"] = Json::array({{{"primitives", primitives_}}});
      gltf["accessors"] = accessors_;
      gltf["materials"] = materials_;
      gltf["bufferViews"] = views_;
      gltf["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
      if (!is_draco()) {
        gltf["buffers"].push_back(
            {{"byteLength", plain_bytes_}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
        const double step = metres(options_.step_mm);
        node["translation"] = values_of(lattice_.min);
        node["scale"] = {step, step, step};
      }
      node["mesh"] = 0;
    }
    if (!images_.empty()) {
      gltf["images"] = images_;
      gltf["textures"] = textures_;
      gltf["samplers"] = Json::array({{{"wrapS", kRepeat}, {"wrapT", kRepeat}}});
    }
    gltf["nodes"] = Json::array({std::move(node)});
    gltf["scenes"] = Json::array({{{"nodes", {0}}}});
    gltf["scene"] = 0;
    return joined(gltf.dump());
  }

 private:
  static void append_u32(std::string& out, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((value >> shift) & 255u);
  }

  std::string joined(std::string json) const {
    json.append((4 - json.size() % 4) % 4, ' ');
    std::string out = "glTF";
    const std::size_t chunk = buffer_.empty() ? 0 : 8 + buffer_.size();
    append_u32(out, 2);
    append_u32(out, 12 + 8 + json.size() + chunk);
    append_u32(out, json.size());
    out += "JSON" + json;
    if (chunk == 0) return out;
    append_u32(out, buffer_.size());
    out.append("BIN\0", 4);
    return out + buffer_;
  }

  int add_bytes(const std::string& bytes) {
    views_.push_back({{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
    buffer_ += bytes;
    buffer_.append((4 - buffer_.size() % 4) % 4, '\0');
    return static_cast<int>(views_.size()) - 1;
  }

  /// Without bufferView: its values are in Draco's bytes.
  int accessor(int type, const char* shape, std::size_t count) {
    accessors_.push_back({{"componentType", type}, {"type", shape}, {"count", count}});
    return static_cast<int>(accessors_.size()) - 1;
  }

  bool is_draco() const { return options_.coding == GlbCoding::draco; }
  static Json values_of(const X3dPoint& p) { return Json::array({metres(p.x), metres(p.y), metres(p.z)}); }

  /// `extra`: the attribute beside position and normal.
  template <class AnyFace>
  void add_primitive(std::span<const AnyFace> faces, const char* extra, Json material) {
    is_unlit_ = is_unlit_ || material.contains("extensions");
    Json primitive = is_draco() ? draco_primitive(draco_mesh(faces, lattice_, options_.step_mm), extra)
                                : meshopt_primitive(meshopt_mesh(faces, lattice_, options_.step_mm), extra);
    materials_.push_back(std::move(material));
    primitive["material"] = materials_.size() - 1;
    primitives_.push_back(std::move(primitive));
  }

  int extra_accessor(const char* extra, std::size_t points) {
    if (extra == std::string_view("TEXCOORD_0")) return accessor(kFloat, "VEC2", points);
    const int colours = accessor(kUnsignedByte, "VEC4", points);
    accessors_.back()["normalized"] = true;
    return colours;
  }

  Json draco_primitive(const DracoMesh& mesh, const char* extra) {
    const int more = extra_accessor(extra, mesh.points);
    const int position = accessor(kFloat, "VEC3", mesh.points);
    accessors_.back()["min"] = values_of(mesh.box.min);
    accessors_.back()["max"] = values_of(mesh.box.max);
    const int normal = accessor(kFloat, "VEC3", mesh.points);
    const int indices = accessor(kUnsignedInt, "SCALAR", 3 * std::size_t{mesh.triangles});
    const Json draco{
        {"bufferView", add_bytes(mesh.bytes)},
        {"attributes", {{"POSITION", mesh.position_id}, {"NORMAL", mesh.normal_id}, {extra, mesh.extra_id}}}};
    return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {extra, more}}},
            {"indices", indices},
            {"extensions", {{"KHR_draco_mesh_compression", draco}}}};
  }

  Json meshopt_primitive(const MeshoptMesh& mesh, const char* extra) {
    const int more = extra_accessor(extra, mesh.points);
    accessors_.back()["bufferView"] = add_stream(mesh.extras, mesh.points, mesh.extra_stride, "ATTRIBUTES");
    const int position = accessor(kUnsignedShort, "VEC3", mesh.points);
    accessors_.back()["min"] = mesh.least;
    accessors_.back()["max"] = mesh.most;
    accessors_.back()["bufferView"] = add_stream(mesh.positions, mesh.points, 8, "ATTRIBUTES");
    const int normal = accessor(kByte, "VEC3", mesh.points);
    accessors_.back()["normalized"] = true;
    accessors_.back()["bufferView"] = add_stream(mesh.normals, mesh.points, 4, "ATTRIBUTES");
    const std::size_t corners = 3 * std::size_t{mesh.triangles};
    const int indices = accessor(kUnsignedInt, "SCALAR", corners);
    accessors_.back()["bufferView"] = add_stream(mesh.indices, corners, 4, "TRIANGLES");
    return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {extra, more}}}, {"indices", indices}};
  }

  /// A view of the second buffer, which no reader of the extension needs, with its coded bytes in the first.
  int add_stream(const std::string& bytes, std::size_t count, std::uint32_t stride, const char* mode) {
    const std::size_t at = buffer_.size();
    buffer_ += bytes;
    buffer_.append((4 - buffer_.size() % 4) % 4, '\0');
    const Json coded{{"buffer", 0},          {"byteOffset", at}, {"byteLength", bytes.size()},
                     {"byteStride", stride}, {"mode", mode},     {"count", count}};
    Json view{{"buffer", 1}, {"byteOffset", plain_bytes_}, {"byteLength", count * stride}};
    const bool is_index = mode == std::string_view("TRIANGLES");
    if (!is_index) view["byteStride"] = stride;
    view["target"] = is_index ? 34963 : 34962;
    view["extensions"] = {{"EXT_meshopt_compression", coded}};
    views_.push_back(std::move(view));
    plain_bytes_ += (count * stride + 3) / 4 * 4;
    return static_cast<int>(views_.size()) - 1;
  }

  LatticeBox lattice_;
  GlbOptions options_;
  std::size_t plain_bytes_ = 0;
  std::string buffer_;
  Json primitives_ = Json::array(), accessors_ = Json::array(), materials_ = Json::array(), views_ = Json::array(),
       images_ = Json::array(), textures_ = Json::array();
  bool is_unlit_ = false;
};

Json asset_of(const CityIndex& index) {
  Json asset{{"version", "2.0"}, {"generator", kGenerator}};
  const auto licences = index.city().meta.find("licences");
  if (licences != index.city().meta.end() && !licences->second.empty())
    asset["copyright"] = clean_text(licences->second);
  return asset;
}

Json node_of(const CityIndex& index, const Sector& sector) {
  std::set<std::string> houses;
  for (const Building* house : index.buildings_of(sector.id)) houses.insert(house->id);
  for (const Border* border : index.borders_of(sector.id))
    if (!border->building_id.empty()) houses.insert(border->building_id);
  return {
      {"name", sector.id},
      {"extras",
       {{"sector", sector.id}, {"name", clean_text(sector.name)}, {"kind", name_of(sector.kind)}, {"houses", houses}}}};
}

}  // namespace

std::string sector_glb(const CityIndex& index, const Sector& sector, Detail detail, const ImageSource& image,
                       const GlbOptions& options) {
  const Content content = content_of(index, sector, detail);
  GlbWriter writer(content.box(), options);
  const Json matt{{"metallicFactor", 0}};
  writer.add_solid(content.solid, {{"pbrMetallicRoughness", matt}});
  writer.add_solid(content.two_sided, {{"pbrMetallicRoughness", matt}, {"doubleSided", true}});
  writer.add_solid(content.backdrop,
                   {{"pbrMetallicRoughness", matt}, {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
  for (const auto& [id, faces] : content.by_image) writer.add_textured(std::span<const TexturedFace>(faces), image(id));
  return writer.file(asset_of(index), node_of(index, sector));
}

std::array<double, 6> glb_bounds(const CityIndex& index, const Sector& sector, Detail detail) {
  const LatticeBox box = content_of(index, sector, detail).box();
  if (box.is_empty()) return {};
  return {metres(box.min.x), metres(box.min.y), metres(box.min.z),
          metres(box.max.x), metres(box.max.y), metres(box.max.z)};
}

}  // namespace vicus
