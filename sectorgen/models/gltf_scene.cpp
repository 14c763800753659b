#include "sectorgen/models/gltf_scene.hpp"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_ENABLE_DRACO
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "city_db/colour.hpp"
#include "city_db/issues.hpp"
#include "sectorgen/models/gltf_meshopt.hpp"

namespace vicus {
namespace {

using Point = std::array<double, 3>;
using Matrix = std::array<double, 16>;  // column by column, as glTF has them

constexpr int kDeepest = 64;                     // nodes in nodes
constexpr std::size_t kMostTriangles = 500'000;  // what a file may hold at all

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix out{};
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
  return out;
}

Matrix matrix_of(const tinygltf::Node& node) {
  Matrix m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (node.matrix.size() == 16) {
    std::copy(node.matrix.begin(), node.matrix.end(), m.begin());
    return m;
  }
  if (node.rotation.size() == 4) {
    const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
    m = {1 - 2 * (y * y + z * z),
         2 * (x * y + z * w),
         2 * (x * z - y * w),
         0,
         2 * (x * y - z * w),
         1 - 2 * (x * x + z * z),
         2 * (y * z + x * w),
         0,
         2 * (x * z + y * w),
         2 * (y * z - x * w),
         1 - 2 * (x * x + y * y),
         0,
         0,
         0,
         0,
         1};
  }
  if (node.scale.size() == 3)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t r = 0; r < 3; ++r) m[4 * c + r] *= node.scale[c];
  if (node.translation.size() == 3)
    for (std::size_t r = 0; r < 3; ++r) m[12 + r] = node.translation[r];
  return m;
}

Point moved(const Matrix& m, const Point& p) {
  Point out;
  for (std::size_t r = 0; r < 3; ++r) out[r] = m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r];
  return out;
}

/// One accessor's numbers, each length checked against the bytes.
class Numbers {
 public:
  Numbers(const tinygltf::Model& model, int accessor, const std::string& file) {
    const auto at = [&](const auto& list, int i, const char* what) -> const auto& {
      if (i < 0 || static_cast<std::size_t>(i) >= list.size())
        throw CityError(file + ": names a " + what + " that it does not hold", 4);
      return list[static_cast<std::size_t>(i)];
    };
    const auto& a = at(model.accessors, accessor, "accessor");
    if (a.sparse.isSparse) throw CityError(file + ": has sparse accessors, which are not read", 4);
    const auto& view = at(model.bufferViews, a.bufferView, "buffer view");
    const auto& buffer = at(model.buffers, view.buffer, "buffer");
    type_ = a.componentType;
    const int width = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type)),
              bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type_)), step = a.ByteStride(view);
    if (width <= 0 || bytes <= 0 || step <= 0) throw CityError(file + ": has an accessor of an unknown type", 4);
    width_ = static_cast<std::size_t>(width);
    step_ = static_cast<std::size_t>(step);
    count = a.count;
    is_normalized_ = a.normalized;
    const std::size_t begin = view.byteOffset + a.byteOffset,
                      least = static_cast<std::size_t>(width) * static_cast<std::size_t>(bytes);
    if (begin > buffer.data.size() ||
        (count > 0 && (buffer.data.size() - begin < least || (buffer.data.size() - begin - least) / step_ < count - 1)))
      throw CityError(file + ": an accessor reaches beyond its bytes", 4);
    bytes_ = buffer.data.data() + begin;
  }

  double at(std::size_t i, std::size_t component) const {
    const unsigned char* p = bytes_ + i * step_;
    switch (type_) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return read<float>(p, component);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read<std::uint8_t>(p, component) / (is_normalized_ ? 255.0 : 1);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read<std::uint16_t>(p, component) / (is_normalized_ ? 65535.0 : 1);
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return read<std::int8_t>(p, component) / (is_normalized_ ? 127.0 : 1);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return read<std::int16_t>(p, component) / (is_normalized_ ? 32767.0 : 1);
      default:
        return read<std::uint32_t>(p, component);
    }
  }
  std::size_t width() const { return width_; }
  std::size_t count = 0;

 private:
  template <class T>
  static double read(const unsigned char* p, std::size_t component) {
    T value;
    std::memcpy(&value, p + component * sizeof(T), sizeof(T));
    return static_cast<double>(value);
  }
  const unsigned char* bytes_ = nullptr;
  std::size_t step_ = 0, width_ = 0;
  int type_ = 0;
  bool is_normalized_ = false;
};

class SceneReader {
 public:
  SceneReader(const tinygltf::Model& model, std::string file) : model_(model), file_(std::move(file)) {}

  std::vector<GltfTriangle> run() {
    std::vector<int> roots;
    if (!model_.scenes.empty()) {
      const auto scene = static_cast<std::size_t>(std::max(0, model_.defaultScene));
      if (scene < model_.scenes.size()) roots = model_.scenes[scene].nodes;
    } else {
      for (int i = 0; i < static_cast<int>(model_.nodes.size()); ++i) roots.push_back(i);
    }
    const Matrix same{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (const int root : roots) add_node(root, same, 0);
    return std::move(out_);
  }

 private:
  void add_node(int i, const Matrix& above, int depth) {
    if (depth > kDeepest || i < 0 || static_cast<std::size_t>(i) >= model_.nodes.size())
      throw CityError(file_ + ": its nodes do not form a tree", 4);
    const auto& node = model_.nodes[static_cast<std::size_t>(i)];
    const Matrix place = product(above, matrix_of(node));
    if (node.mesh >= 0 && static_cast<std::size_t>(node.mesh) < model_.meshes.size())
      for (const auto& primitive : model_.meshes[static_cast<std::size_t>(node.mesh)].primitives)
        if (primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == -1) add_primitive(primitive, place);
    for (const int child : node.children) add_node(child, place, depth + 1);
  }

  void add_primitive(const tinygltf::Primitive& primitive, const Matrix& place) {
    const auto attribute = [&](const char* name) {
      const auto at = primitive.attributes.find(name);
      return at == primitive.attributes.end() ? -1 : at->second;
    };
    if (attribute("POSITION") < 0) return;
    const Numbers positions(model_, attribute("POSITION"), file_);
    if (positions.width() < 3) throw CityError(file_ + ": has positions of fewer than three numbers", 4);
    std::optional<Numbers> indices, colours, coordinates;
    if (primitive.indices >= 0) indices.emplace(model_, primitive.indices, file_);
    if (attribute("COLOR_0") >= 0) colours.emplace(model_, attribute("COLOR_0"), file_);
    const Material material = material_of(primitive.material);
    const std::string uv = "TEXCOORD_" + std::to_string(material.set);
    if (material.image && attribute(uv.c_str()) >= 0) coordinates.emplace(model_, attribute(uv.c_str()), file_);
    const std::size_t corners = indices ? indices->count : positions.count;
    if (out_.size() + corners / 3 > kMostTriangles)
      throw CityError(file_ + ": has more than " + std::to_string(kMostTriangles) + " triangles", 4);
    for (std::size_t i = 0; i + 2 < corners; i += 3) {
      GltfTriangle triangle;
      triangle.colour = material.colour;
      Point shade{0, 0, 0};
      double u = 0, v = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = indices ? static_cast<std::size_t>(indices->at(i + k, 0)) : i + k;
        if (at >= positions.count || (colours && at >= colours->count) || (coordinates && at >= coordinates->count))
          throw CityError(file_ + ": names a corner that it does not hold", 4);
        triangle.corners[k] = moved(place, {positions.at(at, 0), positions.at(at, 1), positions.at(at, 2)});
        if (colours)
          for (std::size_t c = 0; c < 3 && c < colours->width(); ++c) shade[c] += colours->at(at, c) / 3;
        if (coordinates && coordinates->width() >= 2) u += coordinates->at(at, 0) / 3, v += coordinates->at(at, 1) / 3;
      }
      const auto [su, sv] = material.place.moved(u, v);
      const Point texel = coordinates ? sample(*material.image, su, sv) : Point{1, 1, 1};
      for (std::size_t c = 0; c < 3; ++c) triangle.colour[c] *= texel[c] * (colours ? shade[c] : 1);
      out_.push_back(triangle);
    }
  }

  /// KHR_texture_transform: quantized coordinates mean nothing without it.
  struct Placing {
    double ox = 0, oy = 0, sx = 1, sy = 1, turn = 0;
    std::pair<double, double> moved(double u, double v) const {
      const double c = std::cos(turn), s = std::sin(turn);
      return {c * sx * u + s * sy * v + ox, -s * sx * u + c * sy * v + oy};
    }
  };
  struct Material {
    Point colour{1, 1, 1};
    Placing place;
    const tinygltf::Image* image = nullptr;
    int set = 0;  // of texture coordinates
  };

  Material material_of(int i) const {
    Material out;
    if (i < 0 || static_cast<std::size_t>(i) >= model_.materials.size()) return out;
    const auto& pbr = model_.materials[static_cast<std::size_t>(i)].pbrMetallicRoughness;
    for (std::size_t c = 0; c < 3 && c < pbr.baseColorFactor.size(); ++c) out.colour[c] = pbr.baseColorFactor[c];
    const int texture = pbr.baseColorTexture.index;
    if (texture < 0 || static_cast<std::size_t>(texture) >= model_.textures.size()) return out;
    const int image = model_.textures[static_cast<std::size_t>(texture)].source;
    if (image < 0 || static_cast<std::size_t>(image) >= model_.images.size()) return out;
    out.image = &model_.images[static_cast<std::size_t>(image)];
    out.set = pbr.baseColorTexture.texCoord;
    if (const auto at = pbr.baseColorTexture.extensions.find("KHR_texture_transform");
        at != pbr.baseColorTexture.extensions.end()) {
      const tinygltf::Value& t = at->second;
      const auto pair_of = [&](const char* name, double& x, double& y) {
        if (!t.Has(name) || t.Get(name).ArrayLen() != 2) return;
        x = t.Get(name).Get(0).GetNumberAsDouble();
        y = t.Get(name).Get(1).GetNumberAsDouble();
      };
      pair_of("offset", out.place.ox, out.place.oy);
      pair_of("scale", out.place.sx, out.place.sy);
      if (t.Has("rotation")) out.place.turn = t.Get("rotation").GetNumberAsDouble();
      if (t.Has("texCoord")) out.set = t.Get("texCoord").GetNumberAsInt();
    }
    return out;
  }

  /// The nearest pixel: models of few colours keep them pure.
  static Point sample(const tinygltf::Image& image, double u, double v) {
    const auto size = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                      static_cast<std::size_t>(image.component);
    if (image.width <= 0 || image.height <= 0 || image.component < 1 || image.bits != 8 || image.image.size() < size ||
        !std::isfinite(u) || !std::isfinite(v))
      return {1, 1, 1};
    const auto pixel = [](double t, int n) { return std::min(n - 1, static_cast<int>((t - std::floor(t)) * n)); };
    const std::size_t at = (static_cast<std::size_t>(pixel(v, image.height)) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(pixel(u, image.width))) *
                           static_cast<std::size_t>(image.component);
    Point out;
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = linear_of_srgb(image.image[at + (image.component >= 3 ? c : 0)] / 255.0);
    return out;
  }

  const tinygltf::Model& model_;
  std::string file_;
  std::vector<GltfTriangle> out_;
};

}  // namespace

std::vector<GltfTriangle> read_gltf(const std::filesystem::path& path) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error, warning;
  const bool is_binary = path.extension() == ".glb" || path.extension() == ".GLB";
  bool is_read = false;
  const std::string plain = without_meshopt(path);
  try {
    is_read = !plain.empty() ? loader.LoadBinaryFromMemory(
                                   &model, &error, &warning, reinterpret_cast<const unsigned char*>(plain.data()),
                                   static_cast<unsigned>(plain.size()), path.parent_path().string())
              : is_binary ? loader.LoadBinaryFromFile(&model, &error, &warning, path.string())
                          : loader.LoadASCIIFromFile(&model, &error, &warning, path.string());
  } catch (const std::exception& what) {
    error = what.what();
  }
  if (!is_read) {
    if (const auto end = error.find('\n'); end != std::string::npos) error.resize(end);
    throw CityError(path.string() + ": expected glTF 2.0: " + (error.empty() ? "cannot be read" : error), 4);
  }
  static const std::set<std::string> kKnown = {"KHR_draco_mesh_compression", "KHR_mesh_quantization",
                                               "KHR_texture_transform", "KHR_materials_unlit"};
  for (const auto& name : model.extensionsRequired)
    if (!kKnown.contains(name)) throw CityError(path.string() + ": needs " + name + ", which is not read here", 4);
  return SceneReader(model, path.string()).run();
}

}  // namespace vicus
