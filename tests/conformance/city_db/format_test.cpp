#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>

#include <sstream>

#include "city_db/geometry_blob.hpp"
#include "city_db/store.hpp"
#include "tests/support/hex_dump.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"

/// city_db/FORMAT.md, GeoPackage and the file agree.
namespace vicus {
namespace {

using test::ScratchDirectory;
using Rows = std::vector<std::vector<std::string>>;

std::string format_md() { return test::read_bytes(std::string(VICUS_TESTS) + "/../city_db/FORMAT.md"); }

Rows query(const std::filesystem::path& path, const std::string& sql) {
  sqlite3* db = nullptr;
  EXPECT_EQ(sqlite3_open_v2(path.c_str(), &db, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  Rows rows;
  const auto keep = [](void* out, int n, char** values, char**) {
    auto& row = static_cast<Rows*>(out)->emplace_back();
    for (int i = 0; i < n; ++i) row.push_back(values[i] != nullptr ? values[i] : "NULL");
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(db, sql.c_str(), keep, &rows, nullptr), SQLITE_OK) << sqlite3_errmsg(db) << " in " << sql;
  sqlite3_close(db);
  return rows;
}

TEST(FormatMd, ShowsAGateAsTheEncoderWritesIt) {
  const City city = test::sample_city();
  const auto gate =
      std::find_if(city.gates.begin(), city.gates.end(), [](const Gate& g) { return g.id == "s-main-w-to-out"; });
  ASSERT_NE(gate, city.gates.end());
  const std::string dump = test::dumped_bytes(0);
  EXPECT_EQ(dump.size(), 81u);
  EXPECT_EQ(dump, encode_line(gate->line));
  EXPECT_EQ(decode_line(dump), gate->line);
}

TEST(FormatMd, NamesEveryTableColumnAndMetaKey) {
  ScratchDirectory scratch;
  const auto path = scratch / "city.gpkg";
  write_city(path, test::sample_city(), nullptr);
  const std::string text = format_md();
  const auto tables = query(path, "SELECT table_name FROM gpkg_contents");
  EXPECT_EQ(tables.size(), 23u);
  for (const auto& table : tables) {
    EXPECT_NE(text.find(table[0]), std::string::npos) << table[0];
    if (table[0] == "layer_styles") continue;
    for (const auto& column : query(path, "SELECT name FROM pragma_table_info('" + table[0] + "')"))
      EXPECT_NE(text.find('`' + column[0] + '`'), std::string::npos) << table[0] << '.' << column[0];
  }
  for (const auto& key : query(path, "SELECT key FROM meta WHERE key NOT LIKE 'count%'"))
    EXPECT_NE(text.find('`' + key[0] + '`'), std::string::npos) << key[0];
}

TEST(FormatMd, ListsEveryIssueCodeAndNoOther) {
  const std::string text = format_md();
  for (int number = 100; number < 1000; ++number) {
    const std::string name = name_of(static_cast<IssueCode>(number));
    const std::string row = "| " + std::to_string(number) + " | `";
    if (name == "?")
      EXPECT_EQ(text.find(row), std::string::npos) << number;
    else
      EXPECT_NE(text.find(row + name + "` |"), std::string::npos) << number;
  }
}

TEST(FormatMd, ListsEveryKind) {
  const std::string text = format_md();
  const auto expect_all = [&](auto kind) {
    for (int i = 0;; ++i) {
      kind = static_cast<decltype(kind)>(i);
      const std::string name = name_of(kind);
      if (name == "?") break;
      EXPECT_NE(text.find('`' + name + '`'), std::string::npos) << name;
    }
  };
  expect_all(SectorKind{});
  expect_all(GateKind{});
  expect_all(BorderKind{});
  expect_all(ObstacleKind{});
  expect_all(HeightSource{});
  expect_all(VisibleReason{});
  expect_all(Importance{});
}

TEST(GeoPackage, HasWhatTheStandardRequires) {
  ScratchDirectory scratch;
  const auto path = scratch / "city.gpkg";
  write_city(path, test::sample_city(), nullptr);
  const auto value = [&](const std::string& sql) { return query(path, sql).at(0).at(0); };
  EXPECT_EQ(value("PRAGMA application_id"), std::to_string(0x47504B47));
  EXPECT_EQ(value("PRAGMA user_version"), "10300");
  EXPECT_EQ(value("PRAGMA page_size"), "16384");
  EXPECT_EQ(value("PRAGMA integrity_check"), "ok");
  EXPECT_TRUE(query(path, "PRAGMA foreign_key_check").empty());
  EXPECT_EQ(query(path, "SELECT srs_id FROM gpkg_spatial_ref_sys ORDER BY srs_id"),
            (Rows{{"-1"}, {"0"}, {"4326"}, {"100000"}}));
  const auto layers = query(path, "SELECT table_name, column_name, srs_id FROM gpkg_geometry_columns");
  EXPECT_EQ(layers.size(), 15u);
  for (const auto& layer : layers) {
    SCOPED_TRACE(layer[0]);
    EXPECT_EQ(layer[1], "geom");
    EXPECT_EQ(layer[2], "100000");
    EXPECT_EQ(value("SELECT data_type FROM gpkg_contents WHERE table_name = '" + layer[0] + "'"), "features");
    EXPECT_EQ(
        value("SELECT count(*) FROM gpkg_extensions WHERE extension_name = 'gpkg_rtree_index' AND table_name = '" +
              layer[0] + "'"),
        "1");
    EXPECT_EQ(value("SELECT count(*) FROM rtree_" + layer[0] + "_geom"), value("SELECT count(*) FROM " + layer[0]));
    EXPECT_EQ(value("SELECT count(*) FROM sqlite_master WHERE type = 'trigger' AND tbl_name = '" + layer[0] + "'"),
              "6");
    EXPECT_EQ(value("SELECT count(*) FROM layer_styles WHERE useAsDefault = 1 AND f_table_name = '" + layer[0] + "'"),
              "1");
  }
}

/// Runs the command line; its stdout, with stderr in `errors`.
std::string run(const std::string& command, const std::filesystem::path& errors, int& rc) {
  FILE* pipe = ::popen((command + " 2>'" + errors.string() + "'").c_str(), "r");
  std::string out;
  char buffer[4096];
  while (const auto n = std::fread(buffer, 1, sizeof buffer, pipe)) out.append(buffer, n);
  const int status = ::pclose(pipe);
  rc = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return out;
}

TEST(GeoPackage, IsReadByOgrinfoWithoutAWord) {
  if (std::system("command -v ogrinfo >/dev/null 2>&1") != 0) GTEST_SKIP() << "ogrinfo is not installed";
  ScratchDirectory scratch;
  const auto path = scratch / "city.gpkg", errors = scratch / "stderr";
  write_city(path, test::sample_city(), nullptr);
  int rc = -1;
  const std::string summary = run("ogrinfo -al -so '" + path.string() + "'", errors, rc);
  EXPECT_EQ(rc, 0);
  EXPECT_EQ(test::read_bytes(errors), "");
  const std::pair<const char*, const char*> layers[] = {
      {"sector", "Polygon"},   {"gate", "Line String"},    {"border", "Line String"}, {"building", "Polygon"},
      {"obstacle", "Polygon"}, {"domain", "Polygon"},      {"street", "Line String"}, {"object", "Point"},
      {"viewpoint", "Point"},  {"issue", "Unknown (any)"}, {"meta", "None"},          {"visible", "None"},
      {"terrain", "None"},     {"artefact", "None"}};
  for (const auto& [layer, geometry] : layers) {
    const auto begin = summary.find(std::string("Layer name: ") + layer + "\n");
    ASSERT_NE(begin, std::string::npos) << layer;
    const auto section = summary.substr(begin, summary.find("Layer name: ", begin + 1) - begin);
    EXPECT_NE(section.find(std::string("Geometry: ") + geometry + "\n"), std::string::npos) << section;
  }
  EXPECT_NE(summary.find("METHOD[\"Transverse Mercator\""), std::string::npos);
  const std::string features = run("ogrinfo -al '" + path.string() + "'", errors, rc);
  EXPECT_EQ(rc, 0);
  EXPECT_EQ(test::read_bytes(errors), "");
  EXPECT_NE(features.find("LINESTRING (-60 5,-60 -5)"), std::string::npos);
  EXPECT_NE(features.find(std::string("name (String) = ") + test::kAwkwardName), std::string::npos);
}

TEST(GeoPackage, PlacesItsOriginWhereItIs) {
  if (std::system("command -v ogr2ogr >/dev/null 2>&1") != 0) GTEST_SKIP() << "ogr2ogr is not installed";
  ScratchDirectory scratch;
  City city = test::sample_city();
  StandaloneObject tree;
  tree.id = "o";
  tree.sector_id = "s-cross";
  tree.kind = "tree";
  city.objects = {tree};
  write_city(scratch / "city.gpkg", city, nullptr);
  int rc = -1;
  const std::string json = run("ogr2ogr -f GeoJSON -t_srs EPSG:4326 -lco COORDINATE_PRECISION=9 /vsistdout/ '" +
                                   (scratch / "city.gpkg").string() + "' object",
                               scratch / "stderr", rc);
  EXPECT_EQ(rc, 0) << test::read_bytes(scratch / "stderr");
  EXPECT_NE(json.find("[ 15.4395, 47.0707 ]"), std::string::npos) << json;
}

TEST(LayerStyles, AreWellFormedXml) {
  if (std::system("command -v xmllint >/dev/null 2>&1") != 0) GTEST_SKIP() << "xmllint is not installed";
  ScratchDirectory scratch;
  write_city(scratch / "city.gpkg", test::sample_city(), nullptr);
  for (const auto& style : query(scratch / "city.gpkg", "SELECT f_table_name, styleQML FROM layer_styles")) {
    test::write_bytes(scratch / "style.qml", style[1]);
    int rc = -1;
    run("xmllint --noout --nonet '" + (scratch / "style.qml").string() + "'", scratch / "stderr", rc);
    EXPECT_EQ(rc, 0) << style[0] << ": " << test::read_bytes(scratch / "stderr");
  }
}

}  // namespace
}  // namespace vicus
