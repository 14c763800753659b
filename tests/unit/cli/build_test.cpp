#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "city_db/store.hpp"
#include "tests/support/program.hpp"

namespace vicus {
namespace {

using test::vicus_program;

/// Where the city's name can be seen: the file itself, `vicus info`, the root world's title.
void expect_name(const test::ScratchDirectory& scratch, const std::string& city, const std::string& name) {
  EXPECT_EQ(read_city(city).meta["name"], name);
  const auto info = vicus_program(scratch, "info '" + city + "'");
  EXPECT_NE(info.out.find("name            " + name + "\n"), std::string::npos) << info.out;
  const std::string folder = (scratch / "x3d").string();
  EXPECT_EQ(vicus_program(scratch, "export '" + city + "' --format x3d -o '" + folder + "' --quiet").rc, 0);
  const std::string world = test::read_bytes(folder + "/city.x3d");
  EXPECT_NE(world.find("<WorldInfo title='" + name + "'"), std::string::npos) << world.substr(0, 2000);
  EXPECT_NE(world.find("<meta name='subject' content='" + name + "'"), std::string::npos) << world.substr(0, 2000);
}

TEST(VicusBuild, NamesTheCityByOptionElseByItsFile) {
  test::ScratchDirectory scratch;
  const std::string map = (scratch / "old-town.osm").string(), city = (scratch / "city.gpkg").string();
  ASSERT_EQ(vicus_program(scratch, "town --houses 50 --seed 3 -o '" + map + "'").rc, 0);
  ASSERT_EQ(vicus_program(scratch, "build '" + map + "' -o '" + city + "'").rc, 0);
  expect_name(scratch, city, "Old Town");
  ASSERT_EQ(vicus_program(scratch, "build '" + map + "' -o '" + city + "' --name 'Bad Löwen'").rc, 0);
  expect_name(scratch, city, "Bad Löwen");
}

}  // namespace
}  // namespace vicus
