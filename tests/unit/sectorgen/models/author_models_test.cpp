#include "sectorgen/models/author_models.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <functional>

#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

/// An author's glTF models as prototypes.
namespace vicus::test {
namespace {

namespace fs = std::filesystem;

/// A GLB with one triangle (0,0,0), (1,0,0), (0,2,0) below a node that is moved by (0, 1, 3); `json` in place of its
/// own.
std::string glb(std::string json = "") {
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
  const std::uint16_t indices[4] = {0, 1, 2, 0};
  std::string bytes(sizeof corners + sizeof indices, '\0');
  std::memcpy(bytes.data(), corners, sizeof corners);
  std::memcpy(bytes.data() + sizeof corners, indices, sizeof indices);
  if (json.empty())
    json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[0,1,3]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0.2158605,0,1]}}],
"buffers":[{"byteLength":44}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})";
  while (json.size() % 4 != 0) json += ' ';
  std::string out = "glTF";
  const auto u32 = [&](std::size_t v) {
    for (int k = 0; k < 4; ++k) out += static_cast<char>(v >> (8 * k));
  };
  u32(2), u32(28 + json.size() + bytes.size()), u32(json.size());
  out += "JSON" + json;
  u32(bytes.size());
  out += std::string("BIN\0", 4) + bytes;
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

TEST(AuthorModels, StandOnTheirFootWithPlanAxesAndSrgbColours) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "tree.glb", glb());
  const Prototype model = read_model(scratch / "tree.glb", "tree", 0);
  EXPECT_EQ(model.kind, "tree");
  ASSERT_EQ(model.points.size(), 3u);
  // South by 3 m, foot at 0.
  EXPECT_EQ(model.points[0], (GroundPoint{{0, -3000}, 0}));
  EXPECT_EQ(model.points[1], (GroundPoint{{1000, -3000}, 0}));
  EXPECT_EQ(model.points[2], (GroundPoint{{0, -3000}, 2000}));
  EXPECT_EQ(model.triangles, (Triangles{0, 1, 2}));
  EXPECT_EQ(model.colours, (std::vector<Colour>{{255, 128, 0}}));
}

TEST(AuthorModels, AreAsTallAsTheListSays) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "tree.glb", glb());
  write_bytes(scratch / "models.csv", "# ours\n\ntree, tree.glb, 12 m\r\nbench,tree.glb\n");
  const auto models = read_model_list(scratch / "models.csv");
  ASSERT_EQ(models.size(), 2u);
  EXPECT_EQ(models[0].points[2].up_mm, 12000);
  EXPECT_EQ(models[0].points[1].at.x, 6000);
  EXPECT_EQ(models[1].points[2].up_mm, 2000);
}

TEST(AuthorModels, AreRefusedByFileAndLine) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "tree.glb", glb());
  const auto told = [&](const std::string& list, const char* part) {
    write_bytes(scratch / "models.csv", list);
    const std::string what = failure([&] { read_model_list(scratch / "models.csv"); });
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_NE(what.find("models.csv"), std::string::npos) << what;
  };
  told("tree\n", "line 1: expected KIND,FILE");
  told("\ntree,tree.glb,tall\n", "line 2: tall is no height");
  told("tree,tree.glb,-3\n", "no height");
  told("tree,tree.glb\ntree,tree.glb\n", "a second model of tree");
  told("tree,none.glb\n", "none.glb");
  told("# nothing\n", "found none");
  write_bytes(scratch / "tree.glb", "no glTF at all");
  told("tree,tree.glb\n", "expected glTF 2.0");
}

TEST(AuthorModels, AreHostileBytes) {
  const ScratchDirectory scratch;
  const std::string good = glb();
  const std::string json = good.substr(20, good.find("BIN") - 24);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = json;
    const auto at = other.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return other.replace(at, from.size(), to);
  };
  for (const auto& [from, to] : {std::pair(R"("count":3,"type":"SCALAR")", R"("count":300,"type":"SCALAR")"),
                                 {R"("count":3,"type":"VEC3")", R"("count":4294967295,"type":"VEC3")"},
                                 {R"("count":3,"type":"VEC3")", R"("count":2,"type":"VEC3")"},
                                 {R"("byteOffset":36)", R"("byteOffset":4000000000)"},
                                 {R"("nodes":[{"mesh":0)", R"("nodes":[{"children":[0],"mesh":0)"},
                                 {R"("indices":1)", R"("indices":7)"},
                                 {R"("type":"VEC3")", R"("type":"SCALAR")"},
                                 {R"("asset")", R"("extensionsRequired":["EXT_of_nobody"],"asset")"}}) {
    write_bytes(scratch / "a.glb", glb(changed(from, to)));
    EXPECT_NE(failure([&] { read_model(scratch / "a.glb", "tree", 0); }), "none") << to;
  }
  for (std::size_t cut = 0; cut < good.size(); cut += 7) {
    write_bytes(scratch / "a.glb", good.substr(0, cut));
    EXPECT_NE(failure([&] { read_model(scratch / "a.glb", "tree", 0); }), "none") << cut;
  }
}

TEST(AuthorModels, StandForEachObjectOfTheirKindOrAreTold) {
  City city;
  city.objects.push_back({"o1", "s", "tree", "", {}, 0, 0, 0, "", {}});
  Prototype tree, lamp;
  tree.kind = "tree";
  lamp.kind = "street_lamp";
  add_author_models({tree, lamp}, city);
  EXPECT_EQ(city.prototypes.size(), 2u);
  ASSERT_EQ(city.issues.size(), 1u);
  EXPECT_EQ(city.issues[0].code, IssueCode::unused_model);
  EXPECT_EQ(city.issues[0].source_id, "street_lamp");
}

TEST(AuthorModels, OfOthersAreRead) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  int read = 0;
  for (const auto& entry : fs::directory_iterator(*data / "models-textures/kenney-city/models")) {
    if (entry.path().extension() != ".glb") continue;
    SCOPED_TRACE(entry.path().filename());
    const Prototype model = read_model(entry.path(), "tree", 5);
    ++read;
    EXPECT_GT(model.colours.size(), 1u);
    EXPECT_EQ(model.triangles.size(), 3 * model.colours.size());
    std::int32_t top = 0;
    for (const auto& p : model.points) top = std::max(top, p.up_mm);
    EXPECT_EQ(top, 5000);
  }
  EXPECT_GE(read, 15);
}

}  // namespace
}  // namespace vicus::test
