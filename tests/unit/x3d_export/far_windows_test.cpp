#include "x3d_export/far_windows.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "x3d_export/frames.hpp"
#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

std::string written(const Node& node, SceneFormat format = SceneFormat::x3d) {
  Scene scene;
  scene.title = "t";
  scene.nodes = {node};
  return write_scene(scene, format);
}

std::string attribute(const std::string& text, const std::string& name) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(name + "='([^']*)'")) ? match[1].str() : "none";
}

/// A wall of 4 bays and 3 storeys, a plain one and a roof.
std::vector<Face> house() {
  FaceList list({0, 0});
  list.add_wall({10'000, 0}, {0, 0}, 0, 9, {180, 160, 140}, 4, 3);
  list.add_wall({10'000, 8'000}, {10'000, 0}, 0, 9, {180, 160, 140});
  list.add_triangle({{0, 0}, 90'000}, {{10'000, 0}, 90'000}, {{10'000, 8'000}, 120'000}, {90, 80, 70});
  return list.take();
}

TEST(FarWindows, RepeatAsOftenAsTheWallHasBaysAndStoreys) {
  const std::string text = written(windowed_shape("HOUSES", house()));
  EXPECT_EQ(attribute(text, "texCoordIndex"), "0 1 2 3 -1 0 0 0 0 -1 0 0 0 -1");
  EXPECT_NE(text.find("<TextureCoordinate point='0 0 4 0 4 3 0 3'/>"), std::string::npos) << text;
  // The wall's first corner is its left one seen from outside.
  EXPECT_EQ(attribute(text, "coordIndex").substr(0, 10), "0 1 2 3 -1");
  EXPECT_EQ(attribute(text, "<Coordinate point").substr(0, 5), "0 0 0");
}

/// What is plain keeps its colour: the pattern is white where its places are; walls are as light as before in the mean.
TEST(FarWindows, LeaveTheMeanOfAWallAndWhatIsPlainAsTheyWere) {
  const std::string text = written(windowed_shape("HOUSES", house()));
  std::istringstream image(attribute(text, "image"));
  int width = 0, height = 0, components = 0;
  image >> width >> height >> components;
  ASSERT_EQ(components, 1) << "colours in it would replace those of the walls in VRML97";
  std::vector<int> texels;
  for (int v = 0; image >> v;) texels.push_back(v);
  ASSERT_EQ(texels.size(), static_cast<std::size_t>(width * height));
  double mean = 0;
  for (const int v : texels) mean += v / 255.0 / double(texels.size());
  for (int i = 0; i < width; ++i) {  // the rim: what a filter sees at places (0, 0)
    EXPECT_EQ(texels.at(static_cast<std::size_t>(i)), 255);
    EXPECT_EQ(texels.at(static_cast<std::size_t>(i * width)), 255);
  }
  std::istringstream colours(attribute(text, "<Color color"));
  double windowed = 0, plain = 0, skip = 0;
  colours >> windowed >> skip >> skip >> plain;
  EXPECT_NEAR(windowed * mean, 180 / 255.0, 0.006);
  EXPECT_NEAR(plain, 180 / 255.0, 0.001);
}

TEST(FarWindows, AreNoneInWallsTooShortForOne) {
  EXPECT_EQ(window_grid(2.0, 2.5, 4).bays, 0);
  EXPECT_EQ(window_grid(2.3, 4.5, 4).bays, 1);
  EXPECT_EQ(window_grid(25, 2.5, 6).bays, 10);
  EXPECT_EQ(window_grid(25, 2.5, 6).floors, 6);
  EXPECT_EQ(window_grid(25, 2.5, 0).bays, 0);
  EXPECT_EQ(window_grid(5000, 2.5, 6).bays, 250);
}

TEST(FarWindows, AreWrittenInEveryFormat) {
  const Node shape = windowed_shape("HOUSES", house());
  EXPECT_NE(written(shape, SceneFormat::vrml).find("image 16 16 1 255"), std::string::npos);
  EXPECT_EQ(written(shape, SceneFormat::vrml).find("TextureProperties"), std::string::npos) << "VRML97 has none";
  EXPECT_NE(written(shape).find("magnificationFilter='NEAREST_PIXEL'/>"), std::string::npos) << "sharp from near";
  EXPECT_NE(written(shape, SceneFormat::x3dj).find("\"@image\":[16,16,1,255"), std::string::npos);
}

}  // namespace
}  // namespace vicus
