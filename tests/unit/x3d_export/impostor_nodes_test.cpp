#include "x3d_export/impostor_nodes.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/sample_city.hpp"
#include "x3d_export/record.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus {
namespace {

std::string near_text(const City& city, SceneFormat format) {
  const CityIndex index(city);
  return sector_files(index, *index.sector("s-main-w"), Detail::near, format).front().text;
}

TEST(ImpostorNodes, StandHiddenWithoutTheirImageUntilALoaderShowsThem) {
  const City city = test::sample_city();
  const CityIndex index(city);
  const auto nodes = impostor_nodes(index, *index.sector("s-main-w"));
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].def, "IMPOSTOR-s-main-w-to-s-cross");
  const std::string text = near_text(city, SceneFormat::x3d);
  const auto at = text.find("IMPOSTOR-s-main-w-to-s-cross");
  ASSERT_NE(at, text.npos);
  const std::string node = text.substr(at, text.find("</Group>", at) - at);
  EXPECT_NE(node.find("visible='false'"), node.npos) << node;
  EXPECT_NE(node.find("load='false'"), node.npos) << node;
  EXPECT_NE(node.find("\"../impostors/s-main-w-to-s-cross.png\""), node.npos) << node;
}

TEST(ImpostorNodes, AtAnEndOfTheCityShowAtOnceBeforeTheWall) {
  City city = test::sample_city();
  GateImpostor& impostor = city.impostors.front();
  impostor.is_solid = true;
  // From (0, 0) to (0, -10), seen from the west, its sector's side.
  impostor.left = {0, 0};
  impostor.right = {0, -10'000};
  const CityIndex index(city);
  Sector sector = *index.sector("s-main-w");
  sector.origin = {0, 0};
  const Node group = impostor_nodes(index, sector).front();
  EXPECT_TRUE(group.fields.empty()) << "visible";
  const std::string text = near_text(city, SceneFormat::x3d);
  const auto at = text.find("IMPOSTOR-");
  const std::string node = text.substr(at, text.find("</Group>", at) - at);
  EXPECT_EQ(node.find("false'"), node.find("repeatS='false'") + 9) << node;
  const Node& geometry = [&]() -> const Node& {
    for (const auto& field : group.nodes.front().nodes.front().nodes)
      if (field.name == "geometry") return field.nodes.front();
    throw std::runtime_error("no geometry");
  }();
  const auto& points = std::get<std::vector<double>>(geometry.nodes.front().nodes.front().fields.front().value);
  EXPECT_NEAR(points[0], -0.1, 1e-9) << "0.1 m before the wall";
  EXPECT_NEAR(points[5], 10, 1e-9) << "z is south";
}

TEST(ImpostorNodes, AreNotInVrml97) {
  EXPECT_EQ(near_text(test::sample_city(), SceneFormat::vrml).find("IMPOSTOR"), std::string::npos);
}

TEST(Records, SayWhatAGatesPictureShows) {
  const City city = test::sample_city();
  const CityIndex index(city);
  const auto record = nlohmann::json::parse(record_json(sector_record(source_of(index), *index.sector("s-main-w"), 1)));
  int count = 0;
  for (const auto& gate : record["gates"]) {
    if (!gate.contains("impostor")) continue;
    ++count;
    EXPECT_EQ(gate["id"], "s-main-w-to-s-cross");
    EXPECT_EQ(gate["impostor"]["url"], "impostors/s-main-w-to-s-cross.png");
    EXPECT_EQ(gate["impostor"]["eye"], nlohmann::json({-58, 0, 1.75}));
    EXPECT_EQ(gate["impostor"]["radius"], 0.625);
    EXPECT_EQ(gate["impostor"]["solid"], false);
  }
  EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace vicus
