#include "x3d_export/root_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/support/sample_city.hpp"
#include "tests/support/x3d_text.hpp"
#include "x3d_export/flyover_scene.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus {
namespace {

using test::attributes_in;

struct Sample {
  City city = test::sample_city();
  CityIndex index{city};
  std::string text(const RootOptions& options) const { return root_text(source_of(index), options).value_or("none"); }
};

TEST(RootScene, KnowsTheStartSectorAndThoseBehindItsGatesOnly) {
  const Sample sample;
  RootOptions options;
  options.start = "s-passage";
  const auto urls = attributes_in(sample.text(options), "Inline", "url");
  EXPECT_EQ(
      (std::vector<std::string>{urls.begin(), urls.begin() + 3}),
      (std::vector<std::string>{"\"sectors/s-passage.x3d\"", "\"sectors/s-main-e.x3d\"", "\"sectors/s-yard.x3d\""}));
  for (std::size_t i = 3; i < urls.size(); ++i) EXPECT_EQ(urls[i], "") << "the rest are USEs";
}

TEST(FlyoverScene, BringsTheWorldsLightHazeAndTheShaders) {
  const Sample sample;
  const std::string text = write_x3d(flyover_scene(source_of(sample.index)));
  const std::string world = sample.text({});
  for (const char* field : {"direction", "intensity"})
    EXPECT_EQ(attributes_in(text, "DirectionalLight", field), attributes_in(world, "DirectionalLight", field));
  std::string directions;
  for (const auto& d : attributes_in(world, "DirectionalLight", "direction"))
    directions += (directions.empty() ? "" : " ") + d;
  EXPECT_NE(text.find("name='lightDirections' type='MFVec3f' accessType='initializeOnly' value='" + directions + "'"),
            std::string::npos);
  EXPECT_EQ(attributes_in(text, "ComposedShader", "language").size(), 4u) << "two nodes, and a USE of each";
  EXPECT_EQ(attributes_in(text, "ShaderPart", "type"),
            (std::vector<std::string>{"VERTEX", "FRAGMENT", "VERTEX", "FRAGMENT"}));
  EXPECT_NE(text.find("<component name='Shaders' level='1'/>"), std::string::npos);
}

TEST(FlyoverScene, SeesTheWholeTreeFromItsViewpoint) {
  const Sample sample;
  auto source = source_of(sample.index);
  const auto meta = source.meta;
  const auto position_with = [&](const char* levels) {
    source.meta = [&, levels](const std::string& key) {
      return key == "tile_levels" ? std::string(levels) : meta(key);
    };
    return attributes_in(write_x3d(flyover_scene(source)), "Viewpoint", "position").at(0);
  };
  EXPECT_EQ(position_with("5"), "0 614.4 768");  // 2048 m wide
  EXPECT_EQ(position_with("7"), "0 2457.6 3072");
  EXPECT_EQ(position_with("nonsense"), "0 300 375");
}

TEST(RootScene, StartsAtAnySectorAndRefusesOthers) {
  const Sample sample;
  for (const auto& s : sample.city.sectors) {
    RootOptions options;
    options.start = s.id;
    EXPECT_NE(
        sample.text(options).find("name='start' type='SFString' accessType='initializeOnly' value='" + s.id + "'"),
        std::string::npos);
  }
  RootOptions options;
  options.start = "nowhere";
  EXPECT_EQ(root_text(source_of(sample.index), options), std::nullopt);
}

TEST(RootScene, GivesTheLoaderItsListsInStep) {
  const Sample sample;
  RootOptions options;
  options.start = "s-cross";
  options.format = SceneFormat::x3dj;
  const auto json = nlohmann::json::parse(sample.text(options));
  nlohmann::json fields;
  for (const auto& node : json["X3D"]["Scene"]["-children"])
    if (node.contains("Script"))
      for (const auto& field : node["Script"]["field"]) fields[std::string(field["@name"])] = field;
  const auto& ids = fields["ids"]["@value"];
  ASSERT_EQ(ids.size(), 5u);
  EXPECT_EQ(ids[0], "s-cross");
  EXPECT_EQ(fields["inlines"]["-children"].size(), 5u);
  EXPECT_EQ(fields["places"]["-children"].size(), 5u);
  ASSERT_EQ(fields["origins"]["@value"].size(), 15u);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const PlanPoint origin = sample.index.sector(ids[i])->origin;
    EXPECT_EQ(fields["origins"]["@value"][3 * i], metres(origin.x));
    EXPECT_EQ(fields["origins"]["@value"][3 * i + 2], -metres(origin.y));
  }
  for (const char* name :
       {"set_position", "set_orientation", "sector_changed", "level_changed", "world", "base", "start"})
    EXPECT_TRUE(fields.contains(name)) << name;
  EXPECT_EQ(fields["level"]["@value"], "") << "the loader measures";
  EXPECT_EQ(fields["sector_test"]["@value"], "polygon");
}

TEST(RootScene, SaysThatItsScriptNeedsEval) {
  const Sample sample;
  RootOptions options;
  EXPECT_NE(sample.text(options).find("unsafe-eval"), std::string::npos) << sample.text(options);
  options.is_static = true;
  EXPECT_EQ(sample.text(options).find("eval"), std::string::npos);
}

TEST(RootScene, LoadsTheStartByItselfAndNothingElseButInVrml97) {
  const Sample sample;
  RootOptions options;
  options.start = "s-cross";
  const auto text = sample.text(options);
  EXPECT_NE(text.find("<Inline DEF='S_0' "), std::string::npos);
  EXPECT_EQ(text.find("<Inline DEF='S_0' load="), std::string::npos);
  const auto loads = attributes_in(text, "Inline", "load");
  EXPECT_EQ(std::count(loads.begin(), loads.end(), "false"), 4);
  options.format = SceneFormat::vrml;
  const auto vrml = sample.text(options);
  EXPECT_NE(vrml.find("DEF S_0 Inline"), std::string::npos);
  EXPECT_EQ(vrml.find("load"), vrml.find("loader.js")) << "VRML97 has no Inline.load";
  EXPECT_NE(vrml.find("field MFNode inlines [\n]"), std::string::npos) << vrml;
}

TEST(RootScene, IsStaticWithoutScriptWhenAsked) {
  const Sample sample;
  RootOptions options;
  options.start = "s-yard";
  options.is_static = true;
  options.level = 1;
  const auto text = sample.text(options);
  EXPECT_EQ(text.find("Script"), std::string::npos);
  EXPECT_EQ(text.find("ProximitySensor"), std::string::npos);
  EXPECT_EQ(text.find("load="), std::string::npos);
  options.level = kEverySector;
  EXPECT_EQ(attributes_in(sample.text(options), "Inline", "url").size(), sample.city.sectors.size());
  options.level = 0;
  EXPECT_EQ(attributes_in(sample.text(options), "Inline", "url").size(), 1u);
}

TEST(RootScene, TakesTallHousesOfWhatIsSeenOverRoofsOnly) {
  const Sample sample;
  RootOptions options;
  options.start = "s-yard";
  options.is_static = true;
  using Urls = std::vector<std::string>;
  EXPECT_EQ(attributes_in(sample.text(options), "Inline", "url"),
            (Urls{"\"sectors/s-yard.x3d\"", "\"sectors/s-cross.x3d\"", "\"sectors/s-main-w.tall.x3d\"",
                  "\"sectors/s-north.tall.x3d\"", "\"sectors/s-passage.x3d\""}));
  options.level = 2;  // s-cross leads to both, so they come whole
  EXPECT_EQ(sample.text(options).find("tall"), std::string::npos);
}

TEST(RootScene, BoundsHoldAllThatASectorFileDraws) {
  const Sample sample;
  RootOptions options;
  options.is_static = true;
  options.level = kEverySector;
  const auto text = sample.text(options);
  const auto urls = attributes_in(text, "Inline", "url"), centres = attributes_in(text, "Inline", "bboxCenter"),
             sizes = attributes_in(text, "Inline", "bboxSize");
  ASSERT_EQ(urls.size(), sample.city.sectors.size());
  for (std::size_t i = 0; i < urls.size(); ++i) {
    const std::string id = urls[i].substr(9, urls[i].size() - 14);
    double centre[3], size[3];
    std::istringstream(centres[i]) >> centre[0] >> centre[1] >> centre[2];
    std::istringstream(sizes[i]) >> size[0] >> size[1] >> size[2];
    const auto file = sector_files(sample.index, *sample.index.sector(id), Detail::near, SceneFormat::x3d).front();
    for (const auto& face : test::faces_in(file.text))
      for (const auto& c : face.corners) {
        constexpr double kObjects_m = 5;  // crowns of trees may stand over the edge
        const double slack = face.shape == "OBJECTS" ? kObjects_m : 0.002;
        EXPECT_LE(std::abs(c.x - centre[0]), size[0] / 2 + slack) << id << face.shape;
        EXPECT_LE(std::abs(c.y - centre[1]), size[1] / 2 + slack) << id << face.shape;
        EXPECT_LE(std::abs(c.z - centre[2]), size[2] / 2 + slack) << id << face.shape;
      }
  }
}

TEST(StartSector, IsTheNamedOneElseOneWithAStartViewpoint) {
  Sample sample;
  sample.city.meta["start"] = "s-yard";
  EXPECT_EQ(start_sector(source_of(sample.index)), "s-yard");
  sample.city.meta["start"] = "gone";
  const auto id = start_sector(source_of(sample.index));
  const auto viewpoints = source_of(sample.index).viewpoints_of(id);
  EXPECT_TRUE(std::any_of(viewpoints.begin(), viewpoints.end(), [](const Viewpoint& v) { return v.kind == "start"; }));
  sample.city.meta.clear();
  sample.city.viewpoints.clear();
  const CityIndex without(sample.city);
  EXPECT_FALSE(start_sector(source_of(without)).empty());
  RootOptions options;
  EXPECT_NE(root_text(source_of(without), options)->find("<Viewpoint "), std::string::npos) << "there is always one";
}

}  // namespace
}  // namespace vicus
