#include <gtest/gtest.h>

#include "sectorgen/geo/geojson_feature.hpp"
#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

namespace vicus::test {
namespace {

namespace fs = std::filesystem;

const char* const kGood = R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":)"
                          R"([[[2.35,48.87],[2.3503,48.87],[2.3503,48.8702],[2.35,48.8702],[2.35,48.87]]]}})";

std::string feature(const std::string& geometry) {
  return R"({"type":"Feature","properties":{"height":9},"geometry":)" + geometry + "}";
}

std::string refusal(const fs::path& path) {
  try {
    load({path});
  } catch (const CityError& error) {
    EXPECT_EQ(error.exit_code, 4);
    EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos) << error.what();
    return error.what();
  }
  ADD_FAILURE() << path << " was read";
  return "";
}

TEST(BadInput, AMissingFileADirectoryAndAnEmptyFileAreNamed) {
  const ScratchDirectory scratch;
  EXPECT_NE(refusal(scratch / "none.osm.pbf").find("no such file"), std::string::npos);
  fs::create_directory(scratch / "folder.gpkg");
  EXPECT_NE(refusal(scratch / "folder.gpkg").find("directory"), std::string::npos);
  for (const char* name :
       {"a.osm", "a.osm.pbf", "a.geojson", "a.geojsonl", "a.geojsonl.gz", "a.gpkg", "a.fgb", "a.shp"}) {
    write_bytes(scratch / name, "");
    EXPECT_NE(refusal(scratch / name).find("empty"), std::string::npos) << name;
  }
}

TEST(BadInput, WhatIsNoMapIsRefusedWhateverItIsCalled) {
  const ScratchDirectory scratch;
  const std::string jpeg("\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01", 13);
  for (const char* name : {"photo.gpkg", "photo.osm", "photo.osm.pbf", "photo.osm.gz", "photo.geojson",
                           "photo.geojsonl", "photo.geojsonl.gz", "photo.shp", "photo.fgb", "photo.jpg", "photo"}) {
    write_bytes(scratch / name, jpeg + std::string(2000, '\x5a'));
    EXPECT_GT(refusal(scratch / name).size(), 20u) << name;
  }
}

TEST(BadInput, ATruncatedFileIsRefused) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  const ScratchDirectory scratch;
  for (const char* file :
       {"paris-rochechouart/paris-rochechouart.osm.pbf", "paris-rochechouart/paris-rochechouart.osm.gz",
        "graz/water.geojsonl.gz", "prague-bubenec/bubenec.gpkg"}) {
    const std::string whole = read_bytes(*data / file);
    for (std::size_t part : {1, 3}) {
      const fs::path copy = scratch / (std::to_string(part) + "_" + fs::path(file).filename().string());
      write_bytes(copy, whole.substr(0, whole.size() * part / 4));
      refusal(copy);
    }
  }
}

TEST(BadInput, BadLinesAreIssuesAndTheRestIsRead) {
  const ScratchDirectory scratch;
  const std::string nested =
      R"({"type":"GeometryCollection","geometries":[{"type":"GeometryCollection","geometries":[)"
      R"({"type":"Polygon","coordinates":[[[2.351,48.87],[2.3513,48.87],[2.3513,48.8702],[2.351,48.8702],[2.351,48.87]]]}]}]})";
  write_bytes(scratch / "buildings.geojsonl",
              std::string(kGood) + "\n" +
                  feature(R"({"type":"Polygon","coordinates":[[[NaN,48],[2,48],[2,49],[NaN,48]]]})") + "\n" +
                  feature("null") + "\n" + "{\"type\":\"Feature\",\"pro\n" + "[1,2,3]\n" +
                  feature(R"({"type":"Klein","coordinates":[[1,2]]})") + "\n" +
                  feature(R"({"type":"Polygon","coordinates":[]})") + "\n" +
                  feature(R"({"type":"Polygon","coordinates":[[[1e999,48],[2,48],[2,49]]]})") + "\n\n" + "\x1e" +
                  feature(nested) + "\r\n" + std::string(500'000, '[') + "\n");
  const Loaded loaded = load({scratch / "buildings.geojsonl"});
  EXPECT_EQ(loaded.map.footprints.size(), 2u);
  EXPECT_GE(loaded.count(IssueCode::unreadable_feature), 6u);
  EXPECT_EQ(broken_promise(loaded.map), "");
}

TEST(BadInput, AFeatureCollectionWithBadFeaturesIsReadToo) {
  const ScratchDirectory scratch;
  const std::string nested =
      R"({"type":"GeometryCollection","geometries":[{"type":"GeometryCollection","geometries":[)"
      R"({"type":"Polygon","coordinates":[[[2.351,48.87],[2.3513,48.87],[2.3513,48.8702],[2.351,48.8702],[2.351,48.87]]]}]}]})";
  write_bytes(scratch / "buildings.geojson", R"({"type":"FeatureCollection","features":[)" + std::string(kGood) + "," +
                                                 feature("null") + "," + feature(nested) + "]}");
  const Loaded loaded = load({scratch / "buildings.geojson"});
  EXPECT_EQ(loaded.map.footprints.size(), 2u);
  EXPECT_EQ(loaded.count(IssueCode::unreadable_feature), 1u);
  write_bytes(scratch / "nan.geojson",
              R"({"type":"FeatureCollection","features":[)" +
                  feature(R"({"type":"Polygon","coordinates":[[[NaN,48],[2,48],[2,49],[NaN,48]]]})") + "]}");
  refusal(scratch / "nan.geojson");
}

TEST(BadInput, AMapWithNothingWeNeedIsRefused) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "rails.osm",
              R"(<osm version="0.6"><node id="1" lat="1" lon="1"/><node id="2" lat="1" lon="1.1"/>)"
              R"(<way id="1"><nd ref="1"/><nd ref="2"/><tag k="railway" v="rail"/></way></osm>)");
  EXPECT_THROW(load({scratch / "rails.osm"}), CityError);
}

TEST(GeoJsonFeature, HoldsEveryGeometryInFileOrder) {
  std::string problem;
  const auto read = parse_geojson_feature(
      R"({"geometry":{"coordinates":[[[[0,0],[1,0],[1,1],[0,0]],[[0.2,0.1],[0.4,0.2],[0.4,0.1],[0.2,0.1]]],)"
      R"([[[5,5,9],[6,5,9],[6,6,9],[5,5,9]]]],"type":"MultiPolygon"},"properties":{"a":"x","b":2.50,"c":null,"d":true,)"
      R"("e":{"f":1}},"type":"Feature"})",
      problem);
  ASSERT_TRUE(read) << problem;
  EXPECT_TRUE(read->is_feature);
  ASSERT_EQ(read->geometries.size(), 1u);
  EXPECT_EQ(read->geometries[0].type, "MultiPolygon");
  const auto polygons = polygons_of(read->geometries[0]);
  ASSERT_EQ(polygons.size(), 2u);
  ASSERT_EQ(polygons[0].size(), 2u);
  EXPECT_EQ(polygons[0][1].size(), 4u);
  ASSERT_EQ(polygons[1].size(), 1u);
  EXPECT_EQ(polygons[1][0][2].lon_deg, 6);
  EXPECT_EQ(polygons[1][0][2].lat_deg, 6);
  EXPECT_EQ(read->properties, (Tags{{"a", "x"}, {"b", "2.50"}, {"d", "yes"}}));
}

}  // namespace
}  // namespace vicus::test
