#include <gtest/gtest.h>

#include <set>

#include "tests/support/sample_city.hpp"
#include "x3d_export/object_nodes.hpp"
#include "x3d_export/prototypes.hpp"
#include "x3d_export/sector_scene.hpp"
#include "x3d_export/sign_letters.hpp"

namespace vicus {
namespace {

TEST(SignText, KeepsLettersWithoutAccentsAndGivesUpOtherScripts) {
  EXPECT_EQ(sign_text("Café Übermüller & Fils", 40), "CAFE UBERMULLER & FILS");
  EXPECT_EQ(sign_text("Žižkov  Łódź", 40), "ZIZKOV LODZ");
  EXPECT_EQ(sign_text("北京饭店", 40), "");
  EXPECT_EQ(sign_text("\xff\xfe", 40), "");
  EXPECT_EQ(sign_text("Boulangerie", 5), "BOULA");
}

TEST(SignText, EveryLetterHasStrokesWithinItsCell) {
  for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789&-.'")) {
    const auto strokes = strokes_of(c);
    EXPECT_FALSE(strokes.empty()) << c;
    for (const auto& s : strokes) {
      for (const int x : {s.x0, s.x1}) EXPECT_TRUE(x >= 0 && x <= 4) << c;
      for (const int y : {s.y0, s.y1}) EXPECT_TRUE(y >= 0 && y <= 6) << c;
      EXPECT_TRUE(s.x0 != s.x1 || s.y0 != s.y1) << c;
    }
  }
}

StandaloneObject object(const std::string& kind, double height_m = 0) {
  StandaloneObject o;
  o.id = "o";
  o.kind = kind;
  o.height_m = height_m;
  return o;
}

TEST(Models, AreFewTrianglesAndAnInstanceIsAsHighAsItsObject) {
  const City city;
  const CityIndex index(city);
  for (const char* kind : {"tree", "street_lamp", "fountain", "bench", "statue", "bollard", "waste_basket", "post_box",
                           "clock", "drinking_water", "fire_hydrant", "column"}) {
    const auto model = model_of(index, object(kind));
    std::size_t triangles = 0;
    double top = 0;
    for (const auto& face : model.faces) {
      triangles += static_cast<std::size_t>(face.count) - 2;
      for (int k = 0; k < face.count; ++k) top = std::max(top, metres(face.corners[static_cast<std::size_t>(k)].y));
    }
    EXPECT_GT(triangles, 5u) << kind;
    EXPECT_LE(triangles, 120u) << kind;
    EXPECT_NEAR(top, model.height_m, 0.6) << kind;
    EXPECT_NEAR(scale_of(model, object(kind, 2 * model.height_m)).second, 2, 1e-9) << kind;
  }
  EXPECT_TRUE(model_of(index, object("address")).faces.empty());
}

TEST(Models, AnAuthorsModelStandsForItsKind) {
  const City city = test::sample_city();
  const CityIndex index(city);
  const auto model = model_of(index, object("bench"));
  EXPECT_EQ(model.name, "MODEL-bench");
  ASSERT_EQ(model.faces.size(), 1u);
  EXPECT_EQ(model.faces[0].colour, (Colour{10, 20, 30}));
}

TEST(SectorObjects, AreDefinedOnceAFileAndUsedAgain) {
  City city = test::sample_city();
  for (int i = 0; i < 30; ++i) {
    auto tree = object("tree", 6 + i % 5);
    tree.id = "t-" + std::to_string(i);
    tree.sector_id = "s-yard";
    tree.at = {38'000 + 200 * i, 30'000};
    city.objects.push_back(tree);
  }
  const CityIndex index(city);
  for (const std::size_t limit : {kFileLimit_bytes, std::size_t{9000}})
    for (const auto& file : sector_files(index, *index.sector("s-yard"), Detail::near, SceneFormat::x3d, limit)) {
      std::set<std::string> defined;
      for (std::size_t at = 0; (at = file.text.find("Shape DEF='", at)) != std::string::npos; ++at)
        EXPECT_TRUE(defined.insert(file.text.substr(at + 11, file.text.find('\'', at + 11) - at - 11)).second);
      for (std::size_t at = 0; (at = file.text.find("Shape USE='", at)) != std::string::npos; ++at)
        EXPECT_TRUE(defined.contains(file.text.substr(at + 11, file.text.find('\'', at + 11) - at - 11))) << file.path;
    }
  const auto whole = sector_files(index, *index.sector("s-yard"), Detail::near, SceneFormat::x3d);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_NE(whole[0].text.find("Shape USE='TREE-ROUND-"), std::string::npos);
}

TEST(SectorObjects, ASignWithAnAddressOpensItAndALampCanBeSwitched) {
  const City city = test::sample_city();
  const CityIndex index(city);
  const auto text = sector_files(index, *index.sector("s-main-w"), Detail::near, SceneFormat::x3d).front().text;
  EXPECT_NE(text.find("url='\"https://example.org/?a=1&amp;b=2\"'"), std::string::npos);
  EXPECT_NE(text.find("fromNode='TOUCH-1' fromField='isActive' toNode='TOGGLE-1' toField='set_boolean'"),
            std::string::npos);
  const auto vrml = sector_files(index, *index.sector("s-main-w"), Detail::near, SceneFormat::vrml).front().text;
  EXPECT_EQ(vrml.find("TouchSensor"), std::string::npos);
  EXPECT_NE(vrml.find("https://example.org/"), std::string::npos);
}

}  // namespace
}  // namespace vicus
