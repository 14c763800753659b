#include "x3d_export/glb.hpp"

#include <draco/compression/decode.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "city_db/issues.hpp"
#include "tests/support/sample_city.hpp"
#include "x3d_export/house_nodes.hpp"
#include "x3d_export/object_nodes.hpp"
#include "x3d_export/prototypes.hpp"

namespace vicus {
namespace {

using nlohmann::json;

struct Glb {
  json gltf;
  std::string buffer;
};

std::uint32_t u32(const std::string& s, std::size_t at) {
  std::uint32_t v = 0;
  for (std::size_t i = 4; i-- > 0;) v = (v << 8) | static_cast<unsigned char>(s[at + i]);
  return v;
}

Glb opened(const std::string& file) {
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(u32(file, 4), 2u);
  EXPECT_EQ(u32(file, 8), file.size());
  const std::size_t json_size = u32(file, 12);
  Glb glb{json::parse(file.substr(20, json_size)), {}};
  if (const std::size_t at = 20 + json_size; at < file.size()) glb.buffer = file.substr(at + 8, u32(file, at));
  return glb;
}

std::string view_of(const Glb& glb, int view) {
  const json& v = glb.gltf["bufferViews"][static_cast<std::size_t>(view)];
  return glb.buffer.substr(v["byteOffset"], v["byteLength"]);
}

/// Corners of every triangle, mm, by somebody else's decoder; also checks counts and bounds that the JSON states.
std::multiset<std::array<X3dPoint, 3>> triangles_of(const Glb& glb) {
  std::multiset<std::array<X3dPoint, 3>> out;
  for (const json& primitive : glb.gltf["meshes"][0]["primitives"]) {
    const json& extension = primitive["extensions"]["KHR_draco_mesh_compression"];
    const std::string bytes = view_of(glb, extension["bufferView"]);
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    EXPECT_TRUE(decoded.ok());
    const auto mesh = std::move(decoded).value();
    const auto* positions = mesh->GetAttributeByUniqueId(extension["attributes"]["POSITION"]);
    const json& accessor = glb.gltf["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    EXPECT_EQ(accessor["count"], mesh->num_points());
    EXPECT_EQ(glb.gltf["accessors"][primitive["indices"].get<std::size_t>()]["count"], 3 * mesh->num_faces());
    for (draco::FaceIndex f(0); f < mesh->num_faces(); ++f) {
      std::array<X3dPoint, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<float, 3> p{};
        positions->GetMappedValue(mesh->face(f)[k], p.data());
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_NEAR(p[i] * 1000, std::round(p[i] * 1000), 0.1) << "off the lattice";
          EXPECT_GE(p[i], accessor["min"][i].get<double>() - 1e-4);
          EXPECT_LE(p[i], accessor["max"][i].get<double>() + 1e-4);
        }
        corners[k] = {height_mm(p[0]), height_mm(p[1]), height_mm(p[2])};
      }
      // The coder may turn a triangle's corners round.
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      out.insert(corners);
    }
  }
  return out;
}

template <class F>
void add_fan(std::multiset<std::array<X3dPoint, 3>>& out, const F& face, std::size_t count) {
  for (std::size_t k = 2; k < count; ++k) {
    std::array<X3dPoint, 3> corners{face.corners[0], face.corners[k - 1], face.corners[k]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    // Triangles that fold flat are the coder's to drop.
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2]) out.insert(corners);
  }
}

std::string some_image(const std::string& id) { return "PNG of " + id; }

TEST(SectorGlb, HoldsEveryTriangleToTheMillimetre) {
  const City city = test::sample_city_with_facades();
  const CityIndex index(city);
  for (const Sector& sector : city.sectors)
    for (const Detail detail : {Detail::near, Detail::far}) {
      std::multiset<std::array<X3dPoint, 3>> expected;
      for (const Layer& layer : sector_layers(index, sector, detail))
        for (const Face& face : layer.faces) add_fan(expected, face, static_cast<std::size_t>(face.count));
      if (detail == Detail::near) {
        for (const Face& face : object_faces(index, sector))
          add_fan(expected, face, static_cast<std::size_t>(face.count));
        const LevelFaces facades = sector_facades(index, sector, 3);
        for (const Face& face : facades.solid) add_fan(expected, face, static_cast<std::size_t>(face.count));
        for (const TexturedFace& face : facades.atlas) add_fan(expected, face, 4);
        for (const auto& [image, list] : facades.own_images)
          for (const TexturedFace& face : list) add_fan(expected, face, 4);
      }
      EXPECT_EQ(triangles_of(opened(sector_glb(index, sector, detail, some_image))), expected) << sector.id;
    }
}

/// Corners of every triangle, mm, of a GLB coded by meshoptimizer, read by its decoder.
std::multiset<std::array<X3dPoint, 3>> meshopt_triangles_of(const Glb& glb, double& step_m) {
  std::multiset<std::array<X3dPoint, 3>> out;
  const json& node = glb.gltf["nodes"][0];
  step_m = node["scale"][0];
  const auto coded = [&](const json& accessor_index) {
    const json& accessor = glb.gltf["accessors"][accessor_index.get<std::size_t>()];
    const json& view = glb.gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const json& extension = view["extensions"]["EXT_meshopt_compression"];
    EXPECT_EQ(extension["count"], accessor["count"]);
    EXPECT_EQ(view["byteLength"].get<std::size_t>(),
              extension["count"].get<std::size_t>() * extension["byteStride"].get<std::size_t>());
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
              glb.gltf["buffers"][1]["byteLength"].get<std::size_t>());
    return std::pair(glb.buffer.substr(extension["byteOffset"], extension["byteLength"]),
                     extension["count"].get<std::size_t>());
  };
  const auto bytes_of = [](const std::string& text) { return reinterpret_cast<const unsigned char*>(text.data()); };
  for (const json& primitive : glb.gltf["meshes"][0]["primitives"]) {
    const auto [position_bytes, points] = coded(primitive["attributes"]["POSITION"]);
    const auto [index_bytes, corners] = coded(primitive["indices"]);
    std::vector<std::array<std::uint16_t, 4>> positions(points);
    std::vector<std::uint32_t> indices(corners);
    EXPECT_EQ(meshopt_decodeVertexBuffer(positions.data(), points, 8, bytes_of(position_bytes), position_bytes.size()),
              0);
    EXPECT_EQ(meshopt_decodeIndexBuffer(indices.data(), corners, 4, bytes_of(index_bytes), index_bytes.size()), 0);
    for (std::size_t i = 0; i + 2 < corners; i += 3) {
      std::array<X3dPoint, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& p = positions.at(indices[i + k]);
        const auto mm = [&](std::size_t axis) {
          return height_mm(node["translation"][axis].get<double>() + node["scale"][axis].get<double>() * p[axis]);
        };
        triangle[k] = {mm(0), mm(1), mm(2)};
      }
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      out.insert(triangle);
    }
  }
  return out;
}

TEST(SectorGlb, MeshoptHoldsEveryTriangleOfDracoToHalfAStep) {
  const City city = test::sample_city_with_facades();
  const CityIndex index(city);
  for (const Sector& sector : city.sectors)
    for (const std::uint32_t step_mm : {1u, 100u}) {
      double step_m = 0;
      const auto shown = meshopt_triangles_of(
          opened(sector_glb(index, sector, Detail::far, some_image, {GlbCoding::meshopt, step_mm})), step_m);
      EXPECT_GE(step_m, step_mm / 1000.0 - 1e-9);
      EXPECT_LE(step_m, std::max(step_mm / 1000.0, 0.004));
      const auto exact = triangles_of(opened(sector_glb(index, sector, Detail::far, some_image)));
      const auto most = static_cast<std::int32_t>(std::ceil(step_m * 500)) + 1;
      const auto is_near = [&](const X3dPoint& a, const X3dPoint& b) {
        return std::abs(a.x - b.x) <= most && std::abs(a.y - b.y) <= most && std::abs(a.z - b.z) <= most;
      };
      for (const auto& triangle : exact)
        EXPECT_TRUE(std::any_of(shown.begin(), shown.end(), [&](const auto& other) {
          for (std::size_t turn = 0; turn < 3; ++turn)
            if (is_near(triangle[0], other[turn]) && is_near(triangle[1], other[(turn + 1) % 3]) &&
                is_near(triangle[2], other[(turn + 2) % 3]))
              return true;
          return false;
        })) << sector.id;
    }
}

/// Where an X3D file places instances, a GLB has the faces themselves: as high as the object, about its foot.
TEST(SectorGlb, NearHasWhatStandsInTheStreet) {
  const City city = test::sample_city_with_facades();
  const CityIndex index(city);
  std::size_t count = 0;
  for (const StandaloneObject& object : city.objects) {
    const ObjectModel model = model_of(index, object);
    if (model.faces.empty()) continue;
    const Sector& sector = *index.sector(object.sector_id);
    const X3dPoint foot = x3d_from_plan(object.at, height_mm(object.ground_m), sector.origin);
    std::int32_t top = 0;
    for (const auto& triangle : triangles_of(opened(sector_glb(index, sector, Detail::near, some_image))))
      for (const X3dPoint& p : triangle)
        if (std::hypot(p.x - foot.x, p.z - foot.z) < 1500) top = std::max(top, p.y - foot.y);
    const double expected_m = model.height_m * scale_of(model, object).second;
    EXPECT_GE(metres(top), 0.7 * expected_m) << object.id << ", a " << object.kind;
    ++count;
  }
  EXPECT_GE(count, 2u);
}

TEST(SectorGlb, CarriesImagesIdsAndLicences) {
  City city = test::sample_city_with_facades();
  city.meta["licences"] = "© somebody";
  const CityIndex index(city);
  std::size_t images = 0;
  for (const Sector& sector : city.sectors) {
    const Glb glb = opened(sector_glb(index, sector, Detail::near, some_image));
    EXPECT_EQ(glb.gltf["asset"]["copyright"], "© somebody");
    const json& extras = glb.gltf["nodes"][0]["extras"];
    EXPECT_EQ(extras["sector"], sector.id);
    for (const Building* house : index.buildings_of(sector.id))
      EXPECT_NE(std::find(extras["houses"].begin(), extras["houses"].end(), house->id), extras["houses"].end());
    if (!glb.gltf.contains("images")) continue;
    for (const json& image : glb.gltf["images"]) {
      EXPECT_EQ(view_of(glb, image["bufferView"]).substr(0, 7), "PNG of ");
      ++images;
    }
  }
  EXPECT_GT(images, 3u);
}

TEST(SectorGlb, NamesAMissingImage) {
  const City city = test::sample_city_with_facades();
  const CityIndex index(city);
  const auto none = [](const std::string& id) -> std::string { throw CityError("no image " + id); };
  EXPECT_THROW(
      {
        for (const Sector& sector : city.sectors) sector_glb(index, sector, Detail::near, none);
      },
      CityError);
}

}  // namespace
}  // namespace vicus
