#include "x3d_export/writers.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/sample_city.hpp"
#include "x3d_export/field_table.hpp"

namespace vicus {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A world with one of everything that is written differently: strings, node fields, a Script, a ROUTE.
Scene small_world() {
  Node metadata("MetadataString");
  metadata.set("name", "name").set("value", std::vector<std::string>{test::kAwkwardName, "b\\c"});
  Node set("MetadataSet", "RECORD");
  set.set("name", "sector").add("value", metadata);
  Node info("WorldInfo");
  info.set("title", "O'Neill & Co").add("metadata", set);
  Node loaded("Inline", "S_0"), unloaded("Inline", "S_1");
  loaded.set("url", std::vector<std::string>{"a.x3d"});
  unloaded.set("load", false).set("url", std::vector<std::string>{"b.x3d"});
  Node world("Group", "WORLD");
  world.add(loaded).add(unloaded);
  Node sensor("ProximitySensor", "VISITOR");
  sensor.set("size", std::vector<double>{1, 2, 3.5});
  Node script("Script", "LOADER");
  script.set("directOutput", true);
  script.interface = {
      {"set_position", FieldType::sf_vec3f, Access::input_only, std::string(), {}},
      {"start", FieldType::sf_string, Access::initialize_only, std::string("r12"), {}},
      {"inlines", FieldType::mf_node, Access::initialize_only, std::string(), {use_of(loaded), use_of(unloaded)}},
      {"origins", FieldType::mf_vec3d, Access::initialize_only, std::vector<double>{1, 2, 3}, {}}};
  return {"world.x3d", {}, {info, world, sensor, script}, {{"VISITOR", "position_changed", "LOADER", "set_position"}}};
}

TEST(WriteX3d, QuotesStringsOfAnMfStringAndEscapesMarkup) {
  const std::string text = write_x3d(small_world());
  EXPECT_TRUE(has(text, "value='\"\\\"Zum &lt;Löwen&gt; &amp; Co\\\"\" \"b\\\\c\"'")) << text;
  EXPECT_TRUE(has(text, "title='O&apos;Neill &amp; Co'"));
  EXPECT_TRUE(has(text, "url='\"a.x3d\"'"));
  EXPECT_TRUE(has(text, "<meta name='title' content='world.x3d'/>"));
}

TEST(WriteX3d, NamesContainerFieldsThatAreNotTheDefault) {
  const std::string text = write_x3d(small_world());
  EXPECT_TRUE(has(text, "<MetadataSet DEF='RECORD' name='sector' containerField='metadata'>"));
  EXPECT_TRUE(has(text, "containerField='value'/>"));
  EXPECT_FALSE(has(text, "containerField='children'"));
}

TEST(WriteX3d, DeclaresTheComponentsBeyondTheProfile) {
  const std::string text = write_x3d(small_world());
  EXPECT_TRUE(has(text, "<component name='Networking' level='3'/>"));
  EXPECT_TRUE(has(text, "<component name='Scripting' level='1'/>"));
  EXPECT_FALSE(has(text, "component name='Grouping'"));
}

TEST(WriteVrml, LeavesOutWhatVrml97DoesNotHave) {
  const std::string text = write_vrml(small_world());
  EXPECT_TRUE(text.starts_with("#VRML V2.0 utf8\n"));
  EXPECT_FALSE(has(text, "Metadata")) << text;
  EXPECT_FALSE(has(text, "S_1")) << "an Inline that is not loaded is not there, nor is its USE";
  EXPECT_TRUE(has(text, "field MFNode inlines [\nUSE S_0\n]"));
  EXPECT_TRUE(has(text, "field MFVec3f origins [ 1 2 3 ]"));
  EXPECT_TRUE(has(text, "eventIn SFVec3f set_position"));
  EXPECT_TRUE(has(text, "ROUTE VISITOR.position_changed TO LOADER.set_position"));
}

TEST(WriteX3dj, IsJsonWithTheSameContent) {
  const auto json = nlohmann::json::parse(write_x3dj(small_world()));
  const auto& nodes = json.at("X3D").at("Scene").at("-children");
  ASSERT_EQ(nodes.size(), 5u);
  const auto& record = nodes[0]["WorldInfo"]["-metadata"]["MetadataSet"];
  EXPECT_EQ(record["-value"][0]["MetadataString"]["@value"][0], test::kAwkwardName);
  EXPECT_EQ(record["-value"][0]["MetadataString"]["@value"][1], "b\\c");
  EXPECT_EQ(nodes[2]["ProximitySensor"]["@size"], nlohmann::json::parse("[1, 2, 3.5]"));
  EXPECT_EQ(nodes[3]["Script"]["field"][2]["-children"][1]["Inline"]["@USE"], "S_1");
  EXPECT_EQ(nodes[4]["ROUTE"]["@toField"], "set_position");
}

TEST(Writers, WriteNumbersThatWereSpelledBeforeAsTheyWriteOthers) {
  Node coordinate("Coordinate", "POINTS"), faces("IndexedFaceSet"), shape("Shape"), group("Group");
  std::vector<double> points;
  std::vector<std::int32_t> indices;
  for (int i = 0; i < 40; ++i) {
    points.insert(points.end(), {i * 1.5, -0.001 * i, 1000.0 + i});
    indices.push_back(i % 4 == 3 ? -1 : i);
  }
  faces.set("coordIndex", indices).add("coord", coordinate.set("point", points));
  group.add(shape.add("geometry", faces));
  for (const SceneFormat format : {SceneFormat::x3d, SceneFormat::vrml, SceneFormat::x3dj}) {
    Node spelled = group;
    EXPECT_EQ(settled_size(spelled, format), written_size(group, format));
    const Node& geometry = spelled.nodes[0].nodes[0].nodes[0].nodes[0];
    EXPECT_TRUE(std::holds_alternative<NumberText>(geometry.fields[0].value));
    EXPECT_EQ(write_scene({"t", {}, {spelled}, {}}, format), write_scene({"t", {}, {group}, {}}, format));
  }
}

TEST(Writers, ReplaceBytesThatAreNoText) {
  Node info("WorldInfo");
  info.set("title", "a\xFF\x01z");
  for (const auto format : {SceneFormat::x3d, SceneFormat::vrml, SceneFormat::x3dj})
    EXPECT_TRUE(has(write_scene({"x", {}, {info}, {}}, format), "a\xEF\xBF\xBD z"));
}

TEST(FieldTable, HasATypeForEveryFieldAndAComponentForEveryNode) {
  for (const char* type : {"Shape", "Inline", "Script", "MetadataSet", "Viewpoint"}) {
    const NodeSpec* spec = find_node_spec(type);
    ASSERT_TRUE(spec);
    EXPECT_GE(spec->level, 1);
    for (const auto& field : spec->fields) EXPECT_EQ(find_field_spec(*spec, field.name)->name, field.name);
  }
  EXPECT_EQ(find_node_spec("Teapot"), nullptr);
}

}  // namespace
}  // namespace vicus
