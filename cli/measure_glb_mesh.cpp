#include "cli/measure_glb_mesh.hpp"

#include <draco/compression/decode.h>
#include <meshoptimizer.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "city_db/issues.hpp"
#include "cli/measure_memory.hpp"
#include "sectorgen/bake/picture/png.hpp"

namespace vicus::measure {
namespace {

using Json = nlohmann::json;

/// Positions as stored, colours or places, three corners a triangle.
struct Primitive {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 4>> extras;  // colour 0 ... 1, linear; or place in the first two
  std::vector<std::uint32_t> indices;
};

[[noreturn]] void fail(const char* what) {
  throw CityError(std::string("a GLB of ours is not as it was written: ") + what);
}

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  if (at + 4 > bytes.size()) fail("cut off");
  std::uint32_t v = 0;
  for (std::size_t i = 4; i-- > 0;) v = (v << 8) | static_cast<unsigned char>(bytes[at + i]);
  return v;
}

class GlbReader {
 public:
  explicit GlbReader(const std::string& file) {
    const std::size_t length = u32(file, 12);
    if (20 + length > file.size()) fail("cut off");
    gltf_ = Json::parse(file.begin() + 20, file.begin() + 20 + static_cast<std::ptrdiff_t>(length), nullptr, false);
    if (gltf_.is_discarded()) fail("no JSON");
    if (20 + length < file.size()) buffer_ = file.substr(28 + length);
  }

  const Json& gltf() const { return gltf_; }

  std::string bytes(const Json& place) const {
    const std::size_t at = place.at("byteOffset"), length = place.at("byteLength");
    if (at > buffer_.size() || length > buffer_.size() - at) fail("a view beyond the buffer");
    return buffer_.substr(at, length);
  }
  const Json& view(const Json& index) const { return gltf_.at("bufferViews").at(index.get<std::size_t>()); }
  const Json& accessor(const Json& index) const { return gltf_.at("accessors").at(index.get<std::size_t>()); }

  Primitive draco(const Json& primitive, const char* extra) const {
    const Json& extension = primitive.at("extensions").at("KHR_draco_mesh_compression");
    const std::string coded = bytes(view(extension.at("bufferView")));
    draco::DecoderBuffer buffer;
    buffer.Init(coded.data(), coded.size());
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) fail("Draco cannot read it");
    const auto mesh = std::move(decoded).value();
    const auto attribute = [&](const char* name) {
      const auto* found = mesh->GetAttributeByUniqueId(extension.at("attributes").at(name).get<std::uint32_t>());
      if (found == nullptr) fail("an attribute is missing");
      return found;
    };
    const auto *position = attribute("POSITION"), *more = attribute(extra);
    const bool is_colour = more->data_type() == draco::DT_UINT8;
    Primitive out;
    for (draco::PointIndex p(0); p < mesh->num_points(); ++p) {
      position->GetMappedValue(p, out.positions.emplace_back().data());
      auto& value = out.extras.emplace_back();
      if (!is_colour) {
        more->GetMappedValue(p, value.data());
        continue;
      }
      std::array<std::uint8_t, 4> rgba{};
      more->GetMappedValue(p, rgba.data());
      for (std::size_t i = 0; i < 4; ++i) value[i] = static_cast<float>(rgba[i]) / 255;
    }
    for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f)
      for (std::size_t k = 0; k < 3; ++k) out.indices.push_back(mesh->face(f)[k].value());
    return out;
  }

  Primitive meshopt(const Json& primitive, const char* extra) const {
    const Json& attributes = primitive.at("attributes");
    Primitive out;
    const auto positions = stream<std::array<std::uint16_t, 4>>(attributes.at("POSITION"));
    for (const auto& p : positions)
      out.positions.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    if (extra == std::string_view("TEXCOORD_0")) {
      for (const auto& p : stream<std::array<float, 2>>(attributes.at(extra))) out.extras.push_back({p[0], p[1], 0, 0});
    } else {
      for (const auto& c : stream<std::array<std::uint8_t, 4>>(attributes.at(extra))) {
        auto& value = out.extras.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) value[i] = static_cast<float>(c[i]) / 255;
      }
    }
    stream<std::array<std::int8_t, 4>>(attributes.at("NORMAL"));  // a client needs them: their time counts
    const Json& coded = coded_of(primitive.at("indices"));
    const std::string data = bytes(coded);
    out.indices.resize(coded.at("count").get<std::size_t>());
    if (meshopt_decodeIndexBuffer(out.indices.data(), out.indices.size(), 4,
                                  reinterpret_cast<const unsigned char*>(data.data()), data.size()) != 0)
      fail("meshoptimizer cannot read its indices");
    return out;
  }

 private:
  const Json& coded_of(const Json& index) const {
    return view(accessor(index).at("bufferView")).at("extensions").at("EXT_meshopt_compression");
  }
  template <class Value>
  std::vector<Value> stream(const Json& index) const {
    const Json& coded = coded_of(index);
    const std::string data = bytes(coded);
    std::vector<Value> out(coded.at("count").get<std::size_t>());
    if (coded.at("byteStride").get<std::size_t>() != sizeof(Value) ||
        meshopt_decodeVertexBuffer(out.data(), out.size(), sizeof(Value),
                                   reinterpret_cast<const unsigned char*>(data.data()), data.size()) != 0)
      fail("meshoptimizer cannot read a stream");
    return out;
  }

  Json gltf_;
  std::string buffer_;
};

Colour srgb_from_linear(const std::array<float, 4>& c) {
  const auto channel = [](float v) { return static_cast<std::uint8_t>(std::lround(255 * srgb_of_linear(double{v}))); };
  return {channel(c[0]), channel(c[1]), channel(c[2])};
}

}  // namespace

double add_glb(RenderMesh& mesh, const std::string& file, PlanPoint sector_origin, PngImages& images) {
  const GlbReader reader(file);
  const Json& gltf = reader.gltf();
  if (!gltf.contains("meshes")) return 0;
  const Json& node = gltf.at("nodes").at(0);
  Vec3 moved{}, scale{1, 1, 1};
  if (node.contains("scale"))
    for (std::size_t i = 0; i < 3; ++i) {
      scale[i] = node.at("scale").at(i).get<double>();
      moved[i] = node.at("translation").at(i).get<double>();
    }
  double decode_ms = 0;
  for (const Json& primitive : gltf.at("meshes").at(0).at("primitives")) {
    const Json& material = gltf.at("materials").at(primitive.at("material").get<std::size_t>());
    if (material.contains("extensions")) continue;  // not lit: the city's end
    const bool is_textured = primitive.at("attributes").contains("TEXCOORD_0");
    const char* const extra = is_textured ? "TEXCOORD_0" : "COLOR_0";
    const double start = cpu_ms();
    const Primitive decoded =
        primitive.contains("extensions") ? reader.draco(primitive, extra) : reader.meshopt(primitive, extra);
    decode_ms += cpu_ms() - start;
    RenderTriangle look;
    look.is_two_sided = material.value("doubleSided", false);
    if (is_textured) {
      const Json& texture =
          gltf.at("textures")
              .at(material.at("pbrMetallicRoughness").at("baseColorTexture").at("index").get<std::size_t>());
      const Json& image = gltf.at("images").at(texture.at("source").get<std::size_t>());
      const std::string png = reader.bytes(reader.view(image.at("bufferView")));
      auto& ready = images[png];
      if (!ready) ready = std::make_shared<RepeatedImage>(read_png(png));
      look.image = static_cast<std::uint32_t>(mesh.images.size());
      mesh.images.push_back(ready);
    }
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const auto& p : decoded.positions) {
      Vec3 at;
      for (std::size_t i = 0; i < 3; ++i) at[i] = moved[i] + scale[i] * double{p[i]};
      mesh.add_point({metres(sector_origin.x) + at[0], metres(sector_origin.y) - at[2], at[1]});
    }
    for (std::size_t i = 0; i + 2 < decoded.indices.size(); i += 3) {
      const std::uint32_t a = decoded.indices[i], b = decoded.indices[i + 1], c = decoded.indices[i + 2];
      if (std::max({a, b, c}) >= decoded.positions.size()) fail("an index beyond its points");
      look.corners = {first + a, first + b, first + c};
      if (is_textured) {
        look.places = static_cast<std::uint32_t>(mesh.places.size());
        const auto place = [&](std::uint32_t k) { return std::array{decoded.extras[k][0], 1 - decoded.extras[k][1]}; };
        mesh.places.push_back({place(a), place(b), place(c)});
      } else {
        look.colour = srgb_from_linear(decoded.extras[a]);
      }
      mesh.triangles.push_back(look);
    }
  }
  return decode_ms;
}

}  // namespace vicus::measure
