#include <gtest/gtest.h>
#include <sqlite3.h>

#include <random>

#include "city_db/store.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"

/// Files that are no city, or were one before somebody changed them.
namespace vicus {
namespace {

using test::ScratchDirectory;
namespace fs = std::filesystem;

/// What reading says; both ways of opening must refuse, or the test fails.
std::string refusal(const fs::path& path) {
  std::string read, opened;
  try {
    read_city(path);
  } catch (const CityError& error) {
    read = error.what();
  }
  try {
    CityReader reader(path);
  } catch (const CityError& error) {
    opened = error.what();
  }
  EXPECT_EQ(read, opened);
  return read;
}

std::string read_error(const fs::path& path) {
  try {
    read_city(path);
  } catch (const CityError& error) {
    return error.what();
  }
  return "";
}

void run_sql(const fs::path& path, const std::string& sql) {
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &db), SQLITE_OK);
  char* error = nullptr;
  EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK) << error << " in " << sql;
  sqlite3_free(error);
  sqlite3_close(db);
}

/// The R-tree triggers call functions only a GeoPackage editor has.
std::string without_triggers(const std::string& sql) {
  std::string drops = "PRAGMA synchronous=OFF;";
  for (const char* layer : {"sector", "gate", "building", "object", "impostor", "panorama", "issue"})
    for (const char* event : {"update1", "update2", "update3", "update4"})
      drops += std::string("DROP TRIGGER rtree_") + layer + "_geom_" + event + ";";
  return drops + sql;
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(ReadCity, NamesWhatIsNoGeoPackage) {
  ScratchDirectory scratch;
  EXPECT_SAYS(refusal(scratch / "none.gpkg"), "none.gpkg: no such file");
  EXPECT_SAYS(refusal(scratch.path()), "it is a directory; expected a city file");
  test::write_bytes(scratch / "empty", "");
  EXPECT_SAYS(refusal(scratch / "empty"), "expected a GeoPackage made by vicus build, found a file of another kind");
  test::write_bytes(scratch / "text", std::string(5000, 'x'));
  EXPECT_SAYS(refusal(scratch / "text"), "found a file of another kind");
  run_sql(scratch / "other.sqlite", "CREATE TABLE t(x)");
  EXPECT_SAYS(refusal(scratch / "other.sqlite"), "found another SQLite database");
}

TEST(ReadCity, NamesAGeoPackageThatIsNoCity) {
  ScratchDirectory scratch;
  const fs::path path = scratch / "map.gpkg";
  run_sql(path, "PRAGMA application_id=0x47504B47; CREATE TABLE roads(fid INTEGER PRIMARY KEY)");
  EXPECT_SAYS(refusal(path), "is a GeoPackage but no Vicus city: expected a table meta");
  run_sql(path, "CREATE TABLE meta(key, value)");
  EXPECT_SAYS(refusal(path), "expected format_version 8 in its table meta, found none");
  run_sql(path, "INSERT INTO meta VALUES('format_version', '1x')");
  EXPECT_SAYS(refusal(path), "found 1x");
}

TEST(ReadCity, RefusesOtherVersionsByName) {
  ScratchDirectory scratch;
  const fs::path path = scratch / "city.gpkg";
  write_city(path, test::sample_city(), nullptr);
  run_sql(path, "UPDATE meta SET value = '9' WHERE key = 'format_version'");
  EXPECT_SAYS(refusal(path), "newer vicus: expected format version 8, found 9");
  run_sql(path, "UPDATE meta SET value = '1' WHERE key = 'format_version'");
  EXPECT_SAYS(refusal(path), "older vicus: expected format version 8, found 1; build the city again");
}

TEST(ReadCity, RefusesTablesThatAreNotOurs) {
  ScratchDirectory scratch;
  const City city = test::sample_city();
  const std::pair<const char*, const char*> cases[] = {
      {"DROP TABLE visible", "no table visible"},
      {"ALTER TABLE visible RENAME TO v; CREATE VIEW visible AS SELECT * FROM v", "no table visible"},
      {"DROP TABLE meta; CREATE VIEW meta AS SELECT 'format_version' AS key, '6' AS value", "expected a table meta"},
      {"DROP TABLE visible; CREATE VIRTUAL TABLE visible USING rtree(fid, sector_id, visible_sector_id)",
       "no table visible"},
      {"ALTER TABLE visible DROP COLUMN reason", "no such column: t.reason"}};
  for (const auto& [sql, message] : cases) {
    SCOPED_TRACE(sql);
    write_city(scratch / "city.gpkg", city, nullptr);
    run_sql(scratch / "city.gpkg", sql);
    EXPECT_SAYS(refusal(scratch / "city.gpkg"), message);
  }
}

TEST(ReadCity, RefusesDamagedRecords) {
  ScratchDirectory scratch;
  const fs::path path = scratch / "city.gpkg";
  const City city = test::sample_city();
  const std::pair<const char*, const char*> cases[] = {
      {"UPDATE sector SET geom = x'47500003' WHERE fid = 2", "no polygon on the lattice"},
      {"UPDATE gate SET geom = (SELECT geom FROM sector LIMIT 1) WHERE fid = 2", "no line on the lattice"},
      {"UPDATE object SET geom = substr(geom, 1, 28) WHERE fid = 2", "no point on the lattice"},
      {"UPDATE panorama SET radius_m = 1e300 WHERE fid = 1", "a panorama of no size"},
      {"UPDATE panorama SET top_m = bottom_m WHERE fid = 1", "a panorama of no size"},
      {"UPDATE panorama SET sides = 65536 WHERE fid = 1", "a panorama without sides"},
      {"UPDATE impostor SET width_px = 0 WHERE fid = 1", "a picture with a side of 0 px"},
      {"UPDATE sector SET kind = 'tunnel' WHERE fid = 1", "unknown kind 'tunnel'"},
      {"UPDATE building SET height_source = 'lidar' WHERE fid = 1", "unknown kind 'lidar'"},
      {"UPDATE sector SET names = '[\"a\"' WHERE fid = 1", "names are no JSON array"},
      {"UPDATE object SET tags = '{\"a\":1}' WHERE fid = 1", "tags are no JSON object"},
      {"UPDATE sector SET ground_triangles = x'0000000001000000FF000000' WHERE fid = 1", "a triangle with a corner"},
      {"UPDATE sector SET ground_triangles = x'00000000' WHERE fid = 1", "triangles of odd length"},
      {"UPDATE building SET side_walls = x'00' WHERE fid = 1", "side walls of odd length"},
      {"UPDATE building SET side_walls = zeroblob(16) || x'000000000000F07F' WHERE fid = 1", "height is not finite"},
      {"UPDATE building SET side_walls = x'000000400000000000000000000000000000000000000000' WHERE fid = 1",
       "a side wall outside the lattice"},
      {"UPDATE building SET height_m = 9e999 WHERE fid = 1", "a number that is not finite"},
      {"UPDATE sector SET origin_east_m = 2e6 WHERE fid = 1", "a coordinate outside the lattice"},
      {"UPDATE sector SET importance = 'great' WHERE fid = 1", "unknown kind 'great'"},
      {"UPDATE sector SET vicinity_m = -1 WHERE fid = 1", "a vicinity below 0"},
      {"UPDATE visible SET reason = 'rumour' WHERE fid = 1", "unknown kind 'rumour'"},
      {"UPDATE visible SET building_ids = '{}' WHERE fid = 1", "building ids are no JSON array"},
      {"UPDATE terrain SET heights = substr(heights, 1, 47)", "other than columns x rows heights"},
      {"UPDATE terrain SET columns = 4294967300", "a terrain that does not fit"},
      {"UPDATE terrain SET rows = 0", "a terrain that does not fit"},
      {"UPDATE terrain SET columns = -4, rows = -3", "a terrain that does not fit"},
      {"UPDATE terrain SET step_m = 0", "a terrain that does not fit"},
      {"UPDATE terrain SET step_m = 5e5", "a terrain that does not fit"},
      {"UPDATE terrain SET corner_north_m = 1.0737e6", "a terrain that does not fit"},
      {"UPDATE terrain SET columns = 12, rows = 2", "other than columns x rows heights"},
      {"DELETE FROM terrain", "table terrain has 0 rows, meta says 1"},
      {"INSERT INTO terrain SELECT 2, corner_east_m, corner_north_m, step_m, columns, rows, heights FROM terrain;"
       "UPDATE meta SET value = '2' WHERE key = 'count_terrain'",
       "two terrains"},
      {"UPDATE issue SET code = 999 WHERE fid = 1", "unknown issue code 999"},
      {"UPDATE issue SET code = 4294967498 WHERE fid = 1", "unknown issue code"},
      {"DELETE FROM visible WHERE fid = 3", "table visible has 25 rows, meta says 26"},
      {"DELETE FROM meta WHERE key = 'count_gate'", "table gate has 15 rows, meta says no count"},
      {"UPDATE meta SET value = '90.5' WHERE key = 'origin_lat'", "meta origin_lat is no angle"},
      {"UPDATE meta SET value = 'nan' WHERE key = 'origin_lon'", "meta origin_lon is no angle"},
      {"DELETE FROM meta WHERE key = 'origin_lon'", "meta origin_lon is no angle"}};
  for (const auto& [sql, message] : cases) {
    SCOPED_TRACE(sql);
    write_city(path, city, nullptr);
    run_sql(path, without_triggers(sql));
    const std::string error = read_error(path);
    EXPECT_SAYS(error, message);
    EXPECT_SAYS(error, path.string() + " is damaged");
  }
}

TEST(CityReader, ThrowsOnADamagedRecordAndStaysUsable) {
  ScratchDirectory scratch;
  const fs::path path = scratch / "city.gpkg";
  write_city(path, test::sample_city(), nullptr);
  run_sql(path, without_triggers("UPDATE sector SET geom = x'00' WHERE id = 's-yard'"));
  const CityReader reader(path);
  for (int again = 0; again < 3; ++again) {
    EXPECT_THROW(reader.sector("s-yard"), CityError);
    EXPECT_EQ(reader.sector("s-cross")->id, "s-cross");
  }
}

/// Everything a server asks for; true if nothing was refused.
bool reads_all(const fs::path& path) {
  try {
    read_city(path);
    const CityReader reader(path);
    for (const auto& id : reader.sector_ids()) {
      reader.sector(id);
      reader.gates_of(id);
      reader.borders_of(id);
      reader.buildings_of(id);
      reader.objects_of(id);
      reader.viewpoints_of(id);
      reader.visible_from(id);
    }
    const PlanBox all{{-kPlanLimit, -kPlanLimit}, {kPlanLimit, kPlanLimit}};
    reader.sectors_in(all, 100, 0);
    reader.gates_in(all, 100, 0);
    reader.buildings_in(all, 100, 0);
    reader.artefact("/a", {"identity"});
    reader.artefact_totals();
    return true;
  } catch (const CityError&) {
    return false;
  }
}

TEST(ReadCity, SurvivesRandomDamage) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  ScratchDirectory scratch;
  write_city(scratch / "whole.gpkg", test::sample_city(),
             test::one_by_one({{"/a", "text/plain", "identity", "h", std::string(50'000, 'a')}}));
  const std::string whole = test::read_bytes(scratch / "whole.gpkg");
  // Most pages are nearly empty; damage goes where the bytes are.
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i] != 0 && whole[i] != 'a') used.push_back(i);
  int refused = 0;
  constexpr int kRounds = 600;
  for (int round = 0; round < kRounds; ++round) {
    std::string bytes = whole;
    const int edits = 1 + static_cast<int>(random() % 20);
    for (int i = 0; i < edits; ++i) bytes[used[random() % used.size()]] = static_cast<char>(random());
    if (round % 10 == 0) bytes.resize(random() % bytes.size());
    test::write_bytes(scratch / "damaged.gpkg", bytes);
    refused += !reads_all(scratch / "damaged.gpkg");
  }
  EXPECT_GT(refused, kRounds / 10);
  EXPECT_TRUE(reads_all(scratch / "whole.gpkg"));
}

}  // namespace
}  // namespace vicus
