#include "x3d_export/ground_grain.hpp"

#include <gtest/gtest.h>

#include "x3d_export/frames.hpp"
#include "x3d_export/writers.hpp"

namespace vicus {
namespace {

/// A rectangle on the ground that rises by `rise_mm` to the north.
std::vector<Face> ground(std::int32_t wide_mm, std::int32_t deep_mm, std::int32_t rise_mm) {
  FaceList list({0, 0});
  list.add_ground({{{0, 0}, 0}, {{wide_mm, 0}, 0}, {{wide_mm, deep_mm}, rise_mm}, {{0, deep_mm}, rise_mm}},
                  {0, 1, 2, 0, 2, 3}, {90, 180, 240});
  return list.take();
}

std::string written(const Node& node) {
  Scene scene;
  scene.title = "t";
  scene.nodes = {node};
  return write_x3d(scene);
}

TEST(GroundGrain, IsAsWideAsItShouldBeWhicheverSideIsLonger) {
  for (const auto& faces : {ground(45'000, 12'000, 300), ground(12'000, 45'000, 300)}) {
    const std::string text = written(grained_shape("GROUND", faces, "../textures/a.png"));
    EXPECT_NE(text.find("<ImageTexture url='\"../textures/a.png\"'/>"), std::string::npos) << text;
    EXPECT_NE(text.find("<TextureTransform scale='15 15'/>"), std::string::npos) << text;
    // As light as without: colours are divided by the mean of the image; what is bright stays below white.
    EXPECT_NE(text.find("diffuseColor='0.392 0.784 1'"), std::string::npos) << text;
  }
}

/// X3D's own coordinates run along the longest and the next side of the box: upright ones would be stretched.
TEST(GroundGrain, IsLeftOutWhereTheGroundIsSteeperThanWide) {
  for (const auto& faces : {ground(1'000, 9'000, 1'500), ground(400, 300, 0)}) {
    const std::string text = written(grained_shape("GROUND", faces, "../textures/a.png"));
    EXPECT_EQ(text.find("Texture"), std::string::npos) << text;
    EXPECT_EQ(text, written(shape_of("GROUND", Shading::solid, faces)));
  }
}

TEST(GroundGrain, IsWrittenInEveryFormat) {
  Scene scene;
  scene.title = "t";
  scene.nodes = {grained_shape("GROUND", ground(30'000, 6'000, 0), "../textures/a.png")};
  EXPECT_NE(write_scene(scene, SceneFormat::vrml).find("textureTransform TextureTransform {"), std::string::npos);
  EXPECT_NE(write_scene(scene, SceneFormat::vrml).find("scale 10 10"), std::string::npos);
  EXPECT_NE(write_scene(scene, SceneFormat::x3dj).find("\"@scale\":[10,10]"), std::string::npos)
      << write_scene(scene, SceneFormat::x3dj);
}

}  // namespace
}  // namespace vicus
