#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "city_db/store.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/unit/cli/run_program.hpp"

namespace vicus {
namespace {

using test::vicus_program;

struct Sample {
  Sample() { write_city(scratch / "city.gpkg", test::sample_city(), nullptr); }
  test::Outcome run(const std::string& arguments) const {
    return vicus_program(scratch, "export '" + (scratch / "city.gpkg").string() + "' " + arguments);
  }
  std::string path(const char* name) const { return (scratch / name).string(); }
  test::ScratchDirectory scratch;
};

TEST(VicusExport, DrawsTheListOfOneSector) {
  const Sample sample;
  const auto map = sample.run("--format svg --lvis s-yard -o " + sample.path("yard.svg"));
  EXPECT_EQ(map.rc, 0) << map.errors;
  EXPECT_NE(test::read_bytes(sample.path("yard.svg")).find("L_vis of s-yard"), std::string::npos);
}

TEST(VicusExport, WritesHousesAsSolids) {
  const Sample sample;
  const std::size_t houses = test::sample_city().buildings.size();
  const auto obj = sample.run("--format obj -o " + sample.path("a.obj"));
  ASSERT_EQ(obj.rc, 0) << obj.errors;
  const std::string text = "\n" + test::read_bytes(sample.path("a.obj"));
  std::size_t count = 0;
  for (auto at = text.find("\no "); at != text.npos; at = text.find("\no ", at + 1)) ++count;
  EXPECT_EQ(count, houses);
  const auto cityjson = sample.run("--format cityjson -o " + sample.path("a.city.json"));
  ASSERT_EQ(cityjson.rc, 0) << cityjson.errors;
  EXPECT_EQ(nlohmann::json::parse(test::read_bytes(sample.path("a.city.json")))["CityObjects"].size(), houses);
}

TEST(VicusExport, NamesNearIdsWhereThereIsNoSuchSector) {
  const Sample sample;
  const auto near = sample.run("--format svg --lvis S-mian-w -o " + sample.path("a.svg"));
  EXPECT_EQ(near.rc, 2);
  EXPECT_NE(near.errors.find("there is no sector S-mian-w; did you mean s-main-w or s-main-e"), std::string::npos)
      << near.errors;
  const auto name = sample.run("--format svg --lvis Kreuzgasse -o " + sample.path("a.svg"));
  EXPECT_NE(name.errors.find("sectors of that name: s-north s-south"), std::string::npos) << name.errors;
  const auto nothing = sample.run("--format svg --lvis 0123456789abcdef -o " + sample.path("a.svg"));
  EXPECT_NE(nothing.errors.find("--labels shows the ids"), std::string::npos) << nothing.errors;
  EXPECT_FALSE(std::filesystem::exists(sample.path("a.svg")));
}

TEST(VicusExport, WritesPortalsAndWhatTheyStandFor) {
  const Sample sample;
  const auto joined = sample.run("--format portals --json -o " + sample.path("a.prt"));
  ASSERT_EQ(joined.rc, 0) << joined.errors;
  EXPECT_EQ(nlohmann::json::parse(joined.out)["files"], 2);
  const auto triangles = sample.run("--format portals --triangles -o " + sample.path("b.prt"));
  ASSERT_EQ(triangles.rc, 0) << triangles.errors;
  const auto a = nlohmann::json::parse(test::read_bytes(sample.path("a.prt.json"))),
             b = nlohmann::json::parse(test::read_bytes(sample.path("b.prt.json")));
  EXPECT_LT(a["cells"], b["cells"]);
  EXPECT_EQ(test::read_bytes(sample.path("a.prt")).substr(0, 5), "PRT1\n");
}

}  // namespace
}  // namespace vicus
