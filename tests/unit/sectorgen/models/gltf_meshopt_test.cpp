#include "sectorgen/models/gltf_meshopt.hpp"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "city_db/issues.hpp"
#include "sectorgen/models/gltf_scene.hpp"
#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

/// Models coded by EXT_meshopt_compression with quantized corners, as gltfpack writes them.
namespace vicus::test {
namespace {

using Json = nlohmann::json;

struct Corner {
  std::uint16_t x = 0, y = 0, z = 0, unused = 0;
};

/// A sheet of SIDE x SIDE corners with bumps.
std::vector<Corner> sheet(int side, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Corner> out;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      out.push_back({static_cast<std::uint16_t>(100 * column), static_cast<std::uint16_t>(random() % 3000),
                     static_cast<std::uint16_t>(100 * row), 0});
  return out;
}
std::vector<std::uint16_t> sheet_indices(int side) {
  std::vector<std::uint16_t> out;
  for (int row = 0; row + 1 < side; ++row)
    for (int column = 0; column + 1 < side; ++column) {
      const int i = row * side + column;
      for (const int k : {i, i + 1, i + side, i + 1, i + side + 1, i + side})
        out.push_back(static_cast<std::uint16_t>(k));
    }
  return out;
}

std::string file_of(const Json& json, std::string bin) {
  std::string text = json.dump();
  while (text.size() % 4 != 0) text += ' ';
  while (bin.size() % 4 != 0) bin += '\0';
  std::string out = "glTF";
  const auto u32 = [&](std::size_t v) {
    for (int k = 0; k < 4; ++k) out += static_cast<char>(v >> (8 * k));
  };
  u32(2), u32(28 + text.size() + bin.size()), u32(text.size());
  out += "JSON" + text;
  u32(bin.size());
  return out + std::string("BIN\0", 4) + bin;
}

/// The sheet, coded. What is in the second buffer nobody has: it only says how long the plain bytes would be.
struct Coded {
  Json json;
  std::string bin;
};
Coded coded_sheet(int side, unsigned seed) {
  const auto corners = sheet(side, seed);
  const auto indices = sheet_indices(side);
  std::string vertex_bytes(meshopt_encodeVertexBufferBound(corners.size(), sizeof(Corner)), '\0');
  vertex_bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(vertex_bytes.data()),
                                                 vertex_bytes.size(), corners.data(), corners.size(), sizeof(Corner)));
  std::string index_bytes(meshopt_encodeIndexBufferBound(indices.size(), corners.size()), '\0');
  index_bytes.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(index_bytes.data()), index_bytes.size(),
                                               indices.data(), indices.size()));
  const std::size_t exact = vertex_bytes.size(), plain_vertices = 8 * corners.size();
  while (vertex_bytes.size() % 4 != 0) vertex_bytes += '\0';  // padding is no part of the stream
  const std::size_t vertex_length = vertex_bytes.size();
  const auto view = [](std::size_t plain_offset, std::size_t plain_length, Json coded) {
    return Json{{"buffer", 1},
                {"byteOffset", plain_offset},
                {"byteLength", plain_length},
                {"extensions", {{"EXT_meshopt_compression", std::move(coded)}}}};
  };
  Coded out;
  out.bin = vertex_bytes + index_bytes;
  out.json = {{"asset", {{"version", "2.0"}}},
              {"extensionsUsed", {"EXT_meshopt_compression", "KHR_mesh_quantization"}},
              {"extensionsRequired", {"EXT_meshopt_compression", "KHR_mesh_quantization"}},
              {"scenes", {{{"nodes", {0}}}}},
              {"nodes", {{{"mesh", 0}, {"scale", {0.001, 0.001, 0.001}}}}},
              {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
              {"buffers",
               {{{"byteLength", out.bin.size()}},
                {{"byteLength", plain_vertices + 2 * indices.size()},
                 {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}}},
              {"accessors",
               {{{"bufferView", 0}, {"componentType", 5123}, {"count", corners.size()}, {"type", "VEC3"}},
                {{"bufferView", 1}, {"componentType", 5123}, {"count", indices.size()}, {"type", "SCALAR"}}}}};
  Json vertices = view(0, plain_vertices,
                       {{"buffer", 0},
                        {"byteOffset", 0},
                        {"byteLength", exact},
                        {"byteStride", 8},
                        {"mode", "ATTRIBUTES"},
                        {"count", corners.size()}});
  vertices["byteStride"] = 8;
  out.json["bufferViews"] = {vertices, view(plain_vertices, 2 * indices.size(),
                                            {{"buffer", 0},
                                             {"byteOffset", vertex_length},
                                             {"byteLength", index_bytes.size()},
                                             {"byteStride", 2},
                                             {"mode", "TRIANGLES"},
                                             {"count", indices.size()}})};
  return out;
}

std::string failure(const std::function<void()>& run) {
  try {
    run();
  } catch (const CityError& error) {
    return error.what();
  }
  return "none";
}

TEST(GltfMeshopt, GivesTheCornersBackExactly) {
  const ScratchDirectory scratch;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const int side = 3 + 20 * static_cast<int>(seed);
    const Coded coded = coded_sheet(side, seed);
    write_bytes(scratch / "a.glb", file_of(coded.json, coded.bin));
    const auto triangles = read_gltf(scratch / "a.glb");
    const auto corners = sheet(side, seed);
    const auto indices = sheet_indices(side);
    ASSERT_EQ(triangles.size(), indices.size() / 3) << "seed " << seed;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      // The coder may turn a triangle's corners round: the sums stay.
      std::array<double, 3> want{}, got{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner& c = corners[indices[3 * t + k]];
        want[0] += 0.001 * c.x, want[1] += 0.001 * c.y, want[2] += 0.001 * c.z;
        for (std::size_t i = 0; i < 3; ++i) got[i] += triangles[t].corners[k][i];
      }
      for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(got[i], want[i], 1e-9) << "seed " << seed;
    }
  }
}

TEST(GltfMeshopt, LeavesOtherFilesAlone) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "a.glb", file_of({{"asset", {{"version", "2.0"}}}}, "1234"));
  EXPECT_EQ(without_meshopt(scratch / "a.glb"), "");
  EXPECT_EQ(without_meshopt(scratch / "none.glb"), "");
}

TEST(GltfMeshopt, RefusesWhatDoesNotDecode) {
  const ScratchDirectory scratch;
  const Coded good = coded_sheet(10, 1);
  const auto told = [&](const std::function<void(Json&, std::string&)>& change, const char* part) {
    Coded bad = good;
    change(bad.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"], bad.bin);
    write_bytes(scratch / "a.glb", file_of(bad.json, bad.bin));
    const std::string what = failure([&] { read_gltf(scratch / "a.glb"); });
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_NE(what.find("a.glb"), std::string::npos) << what;
  };
  told([](Json&, std::string& bin) { bin[0] = 0; }, "does not decode");
  told([](Json& c, std::string&) { c["byteLength"] = 5; }, "does not decode");
  told([](Json& c, std::string&) { c["byteLength"] = 1'000'000; }, "beyond its bytes");
  told([](Json& c, std::string&) { c["byteStride"] = 7; }, "unknown coding");
  told([](Json& c, std::string&) { c["mode"] = "SOMEHOW"; }, "unknown coding (SOMEHOW");
  told([](Json& c, std::string&) { c["filter"] = "MAGIC"; }, "unknown filter (MAGIC)");
  told([](Json& c, std::string&) { c["count"] = 1'000'000'000; }, "256 MB");
  told([](Json& c, std::string&) { c["count"] = -1; }, "a.glb");
  told([](Json& c, std::string&) { c["buffer"] = 9; }, "expected glTF 2.0");
}

}  // namespace
}  // namespace vicus::test
