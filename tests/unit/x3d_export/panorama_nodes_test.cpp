#include "x3d_export/panorama_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/sample_city.hpp"
#include "x3d_export/record.hpp"
#include "x3d_export/sector_scene.hpp"

namespace vicus {
namespace {

std::string near_text(const City& city, const char* id, SceneFormat format) {
  const CityIndex index(city);
  return sector_files(index, *index.sector(id), Detail::near, format).front().text;
}

TEST(PanoramaNodes, StandHiddenWithoutTheirImageInTheirSectorAlone) {
  const City city = test::sample_city();
  const std::string text = near_text(city, "s-cross", SceneFormat::x3d);
  const auto at = text.find("DEF='PANORAMA'");
  ASSERT_NE(at, text.npos);
  const std::string node = text.substr(at, text.find("</Group>", at) - at);
  EXPECT_NE(node.find("visible='false'"), node.npos) << node;
  EXPECT_NE(node.find("load='false'"), node.npos) << node;
  EXPECT_NE(node.find("\"../panoramas/s-cross.png\""), node.npos) << node;
  EXPECT_NE(text.find("name='panorama'"), text.npos) << "the record tells of it";
  EXPECT_EQ(near_text(city, "s-main-w", SceneFormat::x3d).find("panorama"), std::string::npos);
  EXPECT_EQ(near_text(city, "s-cross", SceneFormat::vrml).find("PANORAMA"), std::string::npos);
}

TEST(PanoramaNodes, StandOnThePrismAndFaceTheEye) {
  const City city = test::sample_city();
  const CityIndex index(city);
  const Sector& sector = *index.sector("s-cross");
  const Node group = panorama_nodes(index, sector).front();
  const Node& shape = group.nodes.front().nodes.front();
  const Node* geometry = nullptr;
  for (const auto& field : shape.nodes)
    if (field.name == "geometry") geometry = &field.nodes.front();
  ASSERT_NE(geometry, nullptr);
  const auto values = [&](const char* name) {
    for (const auto& field : geometry->nodes)
      if (field.name == name) return std::get<std::vector<double>>(field.nodes.front().fields.front().value);
    return std::vector<double>();
  };
  const auto points = values("coord"), places = values("texCoord");
  ASSERT_EQ(points.size(), 2u * 4 * 3) << "two sides";
  ASSERT_EQ(places.size(), 2u * 4 * 2);
  const Panorama& p = city.panoramas.front();
  for (std::size_t i = 0; i < 8; ++i) {
    const double east = points[3 * i] + metres(sector.origin.x) - metres(p.eye.x),
                 north = -points[3 * i + 2] + metres(sector.origin.y) - metres(p.eye.y);
    EXPECT_NEAR(std::hypot(east, north), p.radius_m, 2e-3);
    EXPECT_NEAR(points[3 * i + 1], i % 4 < 2 ? p.bottom_m : p.top_m, 1e-3);
  }
  // Sides 3 and 4 meet in the east; the second half of the image is side 4.
  EXPECT_NEAR(points[3], p.radius_m - metres(sector.origin.x), 2e-3);
  EXPECT_EQ(places[0], 0);
  EXPECT_EQ(places[2], 0.5);
  EXPECT_EQ(places[8], 0.5);
  EXPECT_EQ(places[10], 1);
}

TEST(Records, TellOfAPanorama) {
  const City city = test::sample_city();
  const CityIndex index(city);
  const auto record = [&](const char* id) {
    return nlohmann::json::parse(record_json(sector_record(source_of(index), *index.sector(id), 1)));
  };
  EXPECT_EQ(record("s-cross")["panorama"]["url"], "panoramas/s-cross.png");
  EXPECT_EQ(record("s-cross")["panorama"]["radius"], 500);
  EXPECT_FALSE(record("s-main-w").contains("panorama"));
}

}  // namespace
}  // namespace vicus
