#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "city_db/store.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/unit/cli/run_program.hpp"

namespace vicus {
namespace {

using nlohmann::json;
using test::vicus_program;

std::string sample_file(const test::ScratchDirectory& scratch) {
  City city = test::sample_city();
  city.meta["licences"] = "© Löwen, ODbL 1.0\nsecond";
  write_city(scratch / "city.gpkg", city,
             test::one_by_one({{"/a", "model/x3d+xml", "br", "h", "12345"}, {"/b", "model/x3d+xml", "br", "h", "67"}}));
  return "'" + (scratch / "city.gpkg").string() + "'";
}

TEST(VicusInfo, TellsCountsSourcesAndSizes) {
  test::ScratchDirectory scratch;
  const auto info = vicus_program(scratch, "info " + sample_file(scratch));
  EXPECT_EQ(info.rc, 0);
  EXPECT_EQ(info.errors, "");
  for (const char* part :
       {"origin          47.0707000, 15.4395000\n", "licences        © Löwen, ODbL 1.0\n", "licences        second\n",
        "sectors         7 (1 crossroads, 1 passage, 4 street, 1 yard)\n", "important       2 (1 author, 1 proposed)\n",
        "unresolved      1\n", "terrain nodes   12\n",
        "visible         26 (12 gate, 1 important, 4 line_of_sight, 2 over_roofs, 7 self)\n",
        "issues          2 (1 no_height, 1 ring_self_intersection)\n", "artefacts       2 model/x3d+xml, br, 7 B\n",
        "program_version 0.0.0-sample\n"})
    EXPECT_NE(info.out.find(part), std::string::npos) << part << "in\n" << info.out;
}

TEST(VicusInfo, TellsTheSameAsOneJsonObject) {
  test::ScratchDirectory scratch;
  const auto info = vicus_program(scratch, "info --json " + sample_file(scratch));
  EXPECT_EQ(info.rc, 0);
  const json object = json::parse(info.out);
  EXPECT_EQ(object["counts"]["buildings"], 10);
  EXPECT_EQ(object["kinds"]["gates"], (json{{"end_of_city", 3}, {"passage", 4}, {"street", 8}}));
  EXPECT_EQ(object["meta"]["licences"], (json{"© Löwen, ODbL 1.0", "second"}));
  EXPECT_EQ(object["meta"]["options"]["budget_kb"], 200);
  EXPECT_EQ(object["origin"], (json{{"lat", 47.0707}, {"lon", 15.4395}}));
  EXPECT_EQ(object["artefacts"],
            json::array({{{"media_type", "model/x3d+xml"}, {"coding", "br"}, {"count", 2}, {"bytes", 7}}}));
  EXPECT_EQ(object["file_bytes"], std::filesystem::file_size(scratch / "city.gpkg"));
}

TEST(VicusInfo, SaysWhatIsWrong) {
  test::ScratchDirectory scratch;
  const auto missing = vicus_program(scratch, "info '" + (scratch / "none.gpkg").string() + "'");
  EXPECT_EQ(missing.rc, 1);
  EXPECT_EQ(missing.out, "");
  EXPECT_NE(missing.errors.find("none.gpkg: no such file"), std::string::npos) << missing.errors;
  EXPECT_EQ(vicus_program(scratch, "info").rc, 2);
  EXPECT_EQ(vicus_program(scratch, "info --quiet " + sample_file(scratch)).out, "");
}

}  // namespace
}  // namespace vicus
