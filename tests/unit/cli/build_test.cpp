#include <gtest/gtest.h>
#include <sqlite3.h>

#include <nlohmann/json.hpp>

#include "city_db/store.hpp"
#include "tests/unit/cli/run_program.hpp"

namespace vicus {
namespace {

using test::vicus_program;

/// A small town, built once.
struct Town {
  Town() {
    EXPECT_EQ(vicus_program(scratch, "town --houses 40 --seed 3 -o " + path("town.osm")).rc, 0);
    const auto built = build("");
    EXPECT_EQ(built.rc, 0) << built.errors;
  }
  test::Outcome build(const std::string& options) const {
    return vicus_program(scratch, "build " + path("town.osm") + " -o " + path("town.gpkg") + " --json " + options);
  }
  City city() const { return read_city(path("town.gpkg")); }
  std::string path(const char* name) const { return (scratch / name).string(); }
  test::ScratchDirectory scratch;
};

std::string authors_of(const City& city) {
  std::string ids;
  for (const auto& s : city.sectors)
    if (s.importance == Importance::author) ids += s.id + " ";
  return ids;
}

TEST(VicusBuild, ReplacesACityOfAnotherFormat) {
  const Town town;
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(town.path("town.gpkg").c_str(), &db), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(db, "UPDATE meta SET value = '1' WHERE key = 'format_version'", nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(db);
  EXPECT_THROW(town.city(), OtherVersionError);
  const auto again = town.build("");
  EXPECT_EQ(again.rc, 0) << again.errors;
  EXPECT_NE(again.errors.find("its sector ids are not kept"), std::string::npos) << again.errors;
  EXPECT_FALSE(town.city().sectors.empty());
}

TEST(VicusBuild, KeepsAPersonsMarksUntilTheyAreTakenAway) {
  const Town town;
  const std::string id = town.city().sectors[0].id;
  EXPECT_EQ(authors_of(town.city()), "");
  test::write_bytes(town.path("list.csv"), id + ",100000\nNowhere Street\n");
  const auto marked = town.build("--important " + town.path("list.csv"));
  ASSERT_EQ(marked.rc, 0) << marked.errors;
  EXPECT_EQ(nlohmann::json::parse(marked.out)["issues"]["104 unknown_place"], 1);
  const auto rows = [&] {
    std::size_t count = 0;
    for (const auto& v : town.city().visible) count += v.visible_sector_id == id && v.sector_id != id;
    return count;
  };
  EXPECT_EQ(authors_of(town.city()), id + " ");
  EXPECT_EQ(rows(), town.city().sectors.size() - 1);
  EXPECT_EQ(town.build("").rc, 0);
  EXPECT_EQ(authors_of(town.city()), id + " ");
  test::write_bytes(town.path("list.csv"), id + ",0\n");
  EXPECT_EQ(town.build("--important " + town.path("list.csv")).rc, 0);
  EXPECT_EQ(authors_of(town.city()), "");
  EXPECT_EQ(town.build("--important " + town.path("none.csv")).rc, 1);
}

TEST(VicusBuild, NamesARasterThatIsNone) {
  const Town town;
  const auto refused = town.build("--terrain " + town.path("town.osm"));
  EXPECT_EQ(refused.rc, 4);
  EXPECT_NE(refused.errors.find("cannot take heights from"), std::string::npos) << refused.errors;
}

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
