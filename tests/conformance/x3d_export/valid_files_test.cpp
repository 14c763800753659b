#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/sample_interior.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/x3d_text.hpp"
#include "x3d_export/flyover_scene.hpp"
#include "x3d_export/interior_scene.hpp"
#include "x3d_export/root_scene.hpp"
#include "x3d_export/sector_scene.hpp"

/// Every file of the sample city against the schemas of X3D 4.0, an independent parser, and what X3D's Schematron
/// rules forbid.
namespace vicus {
namespace {

namespace fs = std::filesystem;
using test::attributes_in;
using test::ScratchDirectory;

constexpr SceneFormat kFormats[] = {SceneFormat::x3d, SceneFormat::vrml, SceneFormat::x3dj};

/// All files, as they lie on a server; one sector is split into parts.
class WrittenCity {
 public:
  WrittenCity() {
    fs::create_directories(folder_ / "sectors");
    for (const auto format : kFormats) {
      for (const auto& s : city_.sectors) {
        const std::size_t limit = s.id == "s-yard" ? 2500 : kFileLimit_bytes;
        for (const auto& file : sector_files(index_, s, Detail::near, format, limit)) add(file.path, file.text);
        if (format != SceneFormat::x3d) continue;
        for (const auto detail : {Detail::far, Detail::tall})
          for (const auto& file : sector_files(index_, s, detail, format)) add(file.path, file.text);
      }
      if (format != SceneFormat::vrml)
        for (const auto& interior : city_.interiors) {
          const auto file = interior_file(index_, interior, format);
          add(file.path, file.text);
        }
      RootOptions options;
      options.format = format;
      add(std::string("city") + suffix_of(format), *root_text(source_of(index_), options));
      options.is_static = true;
      options.level = kEverySector;
      add(std::string("static") + suffix_of(format), *root_text(source_of(index_), options));
    }
    add(kFlyoverName, write_x3d(flyover_scene(source_of(index_))));
  }

  std::vector<fs::path> paths_with(const std::string& suffix) const {
    std::vector<fs::path> paths;
    for (const auto& path : paths_)
      if (path.extension() == suffix) paths.push_back(path);
    return paths;
  }
  fs::path folder() const { return folder_.path(); }

 private:
  void add(const std::string& name, const std::string& text) {
    test::write_bytes(folder_ / name, text);
    paths_.push_back(folder_ / name);
  }

  City city_ = test::sample_city_with_interior();
  CityIndex index_{city_};
  ScratchDirectory folder_;
  std::vector<fs::path> paths_;
};

struct Outcome {
  int code = 0;
  std::string errors;
};

/// Runs a shell command with stdout thrown away.
Outcome run(const WrittenCity& city, const std::string& command) {
  const fs::path errors = city.folder() / "errors.txt";
  const int status = std::system((command + " >/dev/null 2>'" + errors.string() + "'").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, test::read_bytes(errors)};
}

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

fs::path schema_folder() {
  const char* data = std::getenv("VICUS_DATA");
  const fs::path root = data ? fs::path(data) : fs::path(VICUS_TESTS) / ".." / ".." / "shared" / "data";
  return root / "x3d-schemas" / "web3d";
}

std::string quoted(const std::vector<fs::path>& paths) {
  std::string list;
  for (const auto& path : paths) list += " '" + path.string() + "'";
  return list;
}

TEST(X3dFiles, AreValidByTheSchemaOfX3d4) {
  const auto schema = schema_folder() / "x3d-4.0.xsd";
  if (!fs::exists(schema) || !is_installed("xmllint")) GTEST_SKIP() << "needs xmllint and " << schema;
  const WrittenCity city;
  const auto outcome =
      run(city, "xmllint --noout --nonet --schema '" + schema.string() + "'" + quoted(city.paths_with(".x3d")));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

TEST(X3dFiles, AreValidByTheDtdOfX3d4) {
  const auto dtd = schema_folder() / "x3d-4.0.dtd";
  if (!fs::exists(dtd) || !is_installed("xmllint")) GTEST_SKIP() << "needs xmllint and " << dtd;
  const WrittenCity city;
  const auto outcome =
      run(city, "xmllint --noout --nonet --dtdvalid '" + dtd.string() + "'" + quoted(city.paths_with(".x3d")));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

/// What view3dscene 4.2 says of a field that X3D 4.0 has and it does not know: pictures in gates are fetched when
/// shown.
std::string without_known_gap(std::string errors) {
  const std::string gap =
      "tovrmlx3d: Warning: X3D: Unknown X3D field name (unhandled X3D XML attribute) \"load\" in node "
      "\"ImageTexture\"\n";
  for (auto at = errors.find(gap); at != errors.npos; at = errors.find(gap)) errors.erase(at, gap.size());
  return errors;
}

TEST(X3dAndVrmlFiles, AreReadBySomebodyElseWithoutAWord) {
  if (!is_installed("tovrmlx3d")) GTEST_SKIP() << "needs tovrmlx3d (Debian package view3dscene)";
  const WrittenCity city;
  for (const char* suffix : {".x3d", ".wrl"})
    for (const auto& path : city.paths_with(suffix)) {
      const auto outcome = run(city, "HOME='" + city.folder().string() + "' tovrmlx3d '" + path.string() + "'");
      EXPECT_EQ(outcome.code, 0) << path;
      EXPECT_EQ(without_known_gap(outcome.errors), "") << path;
    }
}

/// view3dscene's picture of a file. Its exit code says nothing of what it could load: the picture does.
std::string picture_of(const WrittenCity& city, const std::string& file) {
  const fs::path picture = city.folder() / "picture.png";
  fs::remove(picture);
  const std::string show = std::getenv("DISPLAY") ? "" : "xvfb-run -a -s '-screen 0 800x600x24' ";
  run(city, "HOME='" + city.folder().string() + "' " + show +
                "timeout 60 view3dscene --geometry 640x480 --screenshot 0.5 '" + picture.string() + "' '" +
                (city.folder() / file).string() + "'");
  return fs::exists(picture) ? test::read_bytes(picture) : "";
}

TEST(StaticRoots, ShowTheirSectorsInView3dscene) {
  if (!is_installed("view3dscene") || (!std::getenv("DISPLAY") && !is_installed("xvfb-run")))
    GTEST_SKIP() << "needs view3dscene and a display, or xvfb-run";
  const WrittenCity city;
  const auto whole = picture_of(city, "static.x3d"), in_vrml = picture_of(city, "static.wrl");
  fs::rename(city.folder() / "sectors", city.folder() / "away");
  const auto bare = picture_of(city, "static.x3d");
  ASSERT_FALSE(bare.empty());
  ASSERT_FALSE(whole.empty());
  EXPECT_EQ(bare, picture_of(city, "static.x3d")) << "equal worlds have equal pictures";
  EXPECT_NE(whole, bare) << "the Inlines show nothing";
  EXPECT_NE(in_vrml, bare) << "the Inlines show nothing";
}

TEST(X3djFiles, AreJsonWithAScene) {
  const WrittenCity city;
  for (const auto& path : city.paths_with(".x3dj")) {
    const auto json = nlohmann::json::parse(test::read_bytes(path), nullptr, false);
    ASSERT_FALSE(json.is_discarded()) << path;
    EXPECT_TRUE(json.at("X3D").at("Scene").at("-children").is_array()) << path;
    EXPECT_EQ(json["X3D"]["head"]["meta"][0]["@content"],
              path.filename().string().starts_with("static") ? "city.x3dj" : path.filename().string());
  }
}

/// "a" "b": every string of the list between quotation marks, those inside escaped.
bool is_quoted_list(const std::string& value) {
  bool is_in = false;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (is_in && value[i] == '\\')
      ++i;
    else if (value[i] == '"')
      is_in = !is_in;
    else if (!is_in && value[i] != ' ')
      return false;
  }
  return !is_in;
}

TEST(X3dFiles, QuoteEachStringOfAnMfString) {
  const WrittenCity city;
  std::size_t lists = 0;
  for (const auto& path : city.paths_with(".x3d")) {
    const std::string text = test::read_bytes(path);
    for (const auto& [element, attribute] : {std::pair{"Inline", "url"},
                                             {"Script", "url"},
                                             {"WorldInfo", "info"},
                                             {"NavigationInfo", "type"},
                                             {"MetadataString", "value"}})
      for (const auto& value : attributes_in(text, element, attribute)) {
        EXPECT_TRUE(is_quoted_list(value)) << path << element << value;
        ++lists;
      }
  }
  EXPECT_GT(lists, 100u);
  EXPECT_FALSE(is_quoted_list("sectors/a.x3d"));
  EXPECT_FALSE(is_quoted_list("\"a\" b"));
}

TEST(X3dFiles, NeverPutAnSfStringBetweenQuotationMarks) {
  const WrittenCity city;
  for (const auto& path : city.paths_with(".x3d")) {
    const std::string text = test::read_bytes(path);
    for (const auto& [element, attribute] : {std::pair{"WorldInfo", "title"}, {"Viewpoint", "description"}})
      for (const auto& value : attributes_in(text, element, attribute)) {
        EXPECT_FALSE(value.empty()) << path << element;
        EXPECT_FALSE(value.starts_with('"') || value.ends_with('"')) << path << value;
      }
  }
}

TEST(X3dFiles, HaveATitleAnAppearanceForEachShapeAndRoutesThatEnd) {
  const WrittenCity city;
  std::size_t routes = 0;
  for (const auto& path : city.paths_with(".x3d")) {
    const std::string text = test::read_bytes(path);
    EXPECT_EQ(attributes_in(text, "meta", "name").front(), "title") << path;
    EXPECT_FALSE(attributes_in(text, "meta", "content").front().empty()) << path;
    for (std::size_t at = 0; (at = text.find("<Shape", at)) != std::string::npos; ++at)
      EXPECT_LT(text.find("<Appearance", at), text.find("</Shape>", at)) << path;
    std::set<std::string> defs;
    for (const char* element :
         {"ProximitySensor", "Script", "Group", "Transform", "Inline", "Shape", "MetadataSet", "TouchSensor",
          "TimeSensor", "BooleanToggle", "PositionInterpolator", "OrientationInterpolator"})
      for (const auto& def : attributes_in(text, element, "DEF"))
        EXPECT_TRUE(def.empty() || defs.insert(def).second) << path << " has two " << def;
    for (const char* end : {"fromNode", "toNode"})
      for (const auto& node : attributes_in(text, "ROUTE", end)) {
        EXPECT_TRUE(defs.contains(node)) << path << " routes to " << node;
        ++routes;
      }
    for (const char* element : {"Inline", "Transform", "Group", "Shape"})
      for (const auto& use : attributes_in(text, element, "USE"))
        EXPECT_TRUE(use.empty() || text.find("DEF='" + use + "'") < text.find("USE='" + use + "'")) << path;
  }
  EXPECT_EQ(routes, 30u);  // two ends each: 2 of the root, 3 of the flyover, 2 of a lamp, 3 of a fountain, 5 of a tram
}

TEST(X3dFiles, NeverInlineThemselves) {
  const WrittenCity city;
  for (const auto& path : city.paths_with(".x3d")) {
    const std::string text = test::read_bytes(path);
    const auto title = attributes_in(text, "meta", "content").front();
    for (const auto& url : attributes_in(text, "Inline", "url")) EXPECT_EQ(url.find(title), std::string::npos) << path;
  }
}

}  // namespace
}  // namespace vicus
