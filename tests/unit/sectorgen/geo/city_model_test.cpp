#include "sectorgen/geo/city_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "sectorgen/geom/polygon.hpp"
#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

/// Houses that come as models: CityJSON and CityGML.
namespace vicus::test {
namespace {

namespace fs = std::filesystem;

/// A house of 10 x 8 m with a gabled roof from 5 to 8 m, foot at 42 m, in Dutch coordinates. EXTRA: more of the file.
std::string cityjson(
    const std::string& extra,
    const std::string& metadata = R"("referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415")") {
  return R"({"type": "CityJSON", "version": "2.0", "metadata": {)" + metadata + R"(},
"transform": {"scale": [0.001, 0.001, 0.001], "translate": [90000, 435000, 42]},
"vertices": [[0,0,0],[10000,0,0],[10000,8000,0],[0,8000,0],[0,0,5000],[10000,0,5000],[10000,8000,5000],[0,8000,5000],[0,4000,8000],[10000,4000,8000]],
"CityObjects": {"house": {"type": "Building", "attributes": {"roofType": "1030", "storeysAboveGround": 2, "measuredHeight": 99},
"geometry": [{"type": "Solid", "lod": "2", "boundaries": [[[[3,2,1,0]],[[0,1,5,4]],[[1,2,6,9,5]],[[2,3,7,6]],[[3,0,4,8,7]],[[4,5,9,8]],[[8,9,6,7]]]],
"semantics": {"surfaces": [{"type": "GroundSurface"},{"type": "WallSurface"},{"type": "RoofSurface"}], "values": [[0,1,1,1,1,2,2]]}}]})" +
         extra + "}}";
}

fs::path written(const ScratchDirectory& scratch, const std::string& name, const std::string& text) {
  std::ofstream(scratch.path() / name) << text;
  return scratch.path() / name;
}

Loaded load_file(const fs::path& path) { return load(std::vector{path}); }

void expect_the_house(const SourceMap& map) {
  ASSERT_EQ(map.footprints.size(), 1u);
  const Footprint& house = map.footprints[0];
  EXPECT_NEAR(area_m2(house.area), 80, 0.1);  // the plan's scale is not the Dutch grid's
  EXPECT_EQ(house.height_source, HeightSource::measured);
  EXPECT_NEAR(house.height_m, 8, 1e-9) << "the model's own, not measuredHeight";
  EXPECT_EQ(house.roof_shape, "gabled");
  ASSERT_TRUE(map.models.contains(house.source_id));
  const auto& tops = map.models.at(house.source_id).tops;
  ASSERT_EQ(tops.size(), 2u);
  double least = 1e9, most = 0;
  for (const auto& top : tops)
    for (const auto& p : top.rings.at(0)) least = std::min(least, p.up_m), most = std::max(most, p.up_m);
  EXPECT_NEAR(least, 5, 1e-9);
  EXPECT_NEAR(most, 8, 1e-9);
}

std::string failure(const std::function<void()>& run) {
  try {
    run();
  } catch (const CityError& error) {
    EXPECT_EQ(error.exit_code, 4);
    return error.what();
  }
  return "none";
}

TEST(CityJson, GivesFootprintTagsAndRoof) {
  const ScratchDirectory scratch;
  const Loaded loaded = load_file(written(scratch, "a.city.json", cityjson("")));
  expect_the_house(loaded.map);
  EXPECT_TRUE(loaded.issues.empty());
  EXPECT_EQ(loaded.map.footprints[0].source_id, "a.city.json#house");
  EXPECT_EQ(loaded.map.footprints[0].tags.at("building:levels"), "2");
  EXPECT_NEAR(loaded.map.origin.lat_deg, 51.9, 0.2);
  EXPECT_NEAR(loaded.map.origin.lon_deg, 4.4, 0.2);
}

TEST(CityJson, IsReadAsLinesOfFeaturesToo) {
  const ScratchDirectory scratch;
  std::string house = cityjson("");
  house.erase(std::remove(house.begin(), house.end(), '\n'), house.end());
  const std::string head =
      R"({"type": "CityJSON", "version": "2.0", "metadata": {"referenceSystem": "EPSG:28992"}, "transform": {"scale": [0.001,0.001,0.001], "translate": [90000,435000,42]}, "CityObjects": {}, "vertices": []})";
  expect_the_house(load_file(written(scratch, "a.city.jsonl", head + "\n" + house + "\n")).map);
  const std::string what =
      failure([&] { load_file(written(scratch, "b.city.jsonl", head + "\n" + house.substr(0, 500))); });
  EXPECT_NE(what.find("b.city.jsonl, line 2"), std::string::npos) << what;
}

TEST(CityJson, LeavesOutAFaultyHouseAndKeepsTheOthers) {
  const ScratchDirectory scratch;
  const std::string bad =
      R"(, "bad": {"type": "Building", "geometry": [{"type": "MultiSurface", "lod": 2, "boundaries": [[[0,1,77]]]}]},
 "wall": {"type": "BuildingPart", "geometry": [{"type": "MultiSurface", "lod": 2, "boundaries": [[[0,1,5,4]]]}]},
 "road": {"type": "Road", "geometry": [{"type": "MultiSurface", "lod": 1, "boundaries": [[[0,1,2]]]}]})";
  const Loaded loaded = load_file(written(scratch, "a.json", cityjson(bad)));
  expect_the_house(loaded.map);
  ASSERT_EQ(loaded.issues.size(), 2u);
  for (const auto& issue : loaded.issues) EXPECT_EQ(issue.code, IssueCode::unreadable_feature);
}

TEST(CityJson, SaysWhatIsMissing) {
  const ScratchDirectory scratch;
  const auto told = [&](const std::string& text, const char* part) {
    const std::string what = failure([&] { load_file(written(scratch, "a.city.json", text)); });
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_NE(what.find("a.city.json"), std::string::npos) << what;
  };
  told(cityjson("", R"("title": "x")"), "--crs");
  told(cityjson("", R"("referenceSystem": "my own grid")"), "EPSG code");
  told(cityjson("", R"("referenceSystem": "EPSG:999999")"), "not known here");
  told(cityjson("", R"("referenceSystem": "EPSG:4326")"), "is it the right one?");
  told(cityjson("").substr(0, 700), "CityJSON");
  told(R"({"type": "CityJSON", "metadata": {"referenceSystem": "EPSG:28992"}, "CityObjects": {}, "vertices": []})",
       "found none");
  told(R"({"type": "CityJSON", "CityObjects": {"a": {"type": "Building", "geometry": []}}})", "no list of vertices");
}

TEST(CityJson, TakesTheGivenSystemWhereTheFileNamesNone) {
  const ScratchDirectory scratch;
  LoadOptions options;
  options.inputs = {written(scratch, "a.city.json", cityjson("", R"("title": "x")"))};
  options.assumed_system = "EPSG:28992";
  expect_the_house(load(options).map);
}

std::string citygml(const std::string& system, bool is_lat_first) {
  const auto corner = [&](double x, double y, double z) {
    char text[96];
    // About a house of 10 x 8 m at 50 N, 10 E; or in metres of UTM 32.
    if (is_lat_first)
      std::snprintf(text, sizeof text, "%.9f %.9f %.3f ", 50 + y / 111229.0, 10 + x / 71695.0, 42 + z);
    else
      std::snprintf(text, sizeof text, "%.3f %.3f %.3f ", 571666 + x, 5539109 + y, 42 + z);
    return std::string(text);
  };
  const auto surface = [&](const char* kind, std::vector<std::array<double, 3>> corners) {
    std::string list;
    corners.push_back(corners[0]);
    for (const auto& c : corners) list += corner(c[0], c[1], c[2]);
    return std::string("<bldg:boundedBy><bldg:") + kind +
           "><bldg:lod2MultiSurface><gml:MultiSurface><gml:surfaceMember><gml:Polygon>"
           "<gml:exterior><gml:LinearRing><gml:posList srsDimension='3'>" +
           list +
           "</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></gml:surfaceMember></gml:MultiSurface>"
           "</bldg:lod2MultiSurface></bldg:" +
           kind + "></bldg:boundedBy>";
  };
  return "<?xml version='1.0'?><core:CityModel xmlns:core='c' xmlns:gml='g' "
         "xmlns:bldg='b'><gml:boundedBy><gml:Envelope srsName='" +
         system +
         "'/></gml:boundedBy><core:cityObjectMember><bldg:Building gml:id='house'><gml:name>Town hall</gml:name>"
         "<bldg:roofType>1030</bldg:roofType>" +
         surface("GroundSurface", {{0, 0, 0}, {0, 8, 0}, {10, 8, 0}, {10, 0, 0}}) +
         surface("WallSurface", {{0, 0, 0}, {10, 0, 0}, {10, 0, 5}, {0, 0, 5}}) +
         surface("RoofSurface", {{0, 0, 5}, {10, 0, 5}, {10, 4, 8}, {0, 4, 8}}) +
         surface("RoofSurface", {{0, 4, 8}, {10, 4, 8}, {10, 8, 5}, {0, 8, 5}}) +
         "</bldg:Building></core:cityObjectMember></core:CityModel>";
}

TEST(CityGml, GivesFootprintTagsAndRoof) {
  const ScratchDirectory scratch;
  for (const auto& [system, is_lat_first] : {std::pair("urn:ogc:def:crs,crs:EPSG:6.12:25832,crs:EPSG:6.12:5783", false),
                                             {"http://www.opengis.net/def/crs/EPSG/0/6697", true}}) {
    SCOPED_TRACE(system);
    // 6697 is Japan's: its area of use does not hold this house, 4979's does.
    const std::string name = is_lat_first ? "http://www.opengis.net/def/crs/EPSG/0/4979" : system;
    const Loaded loaded = load_file(written(scratch, "a.gml", citygml(name, is_lat_first)));
    expect_the_house(loaded.map);
    EXPECT_EQ(loaded.map.footprints[0].name, "Town hall");
    EXPECT_TRUE(loaded.issues.empty());
  }
}

TEST(CityGml, HasOneEntranceForEachDoorHoweverManySurfacesItHas) {
  const ScratchDirectory scratch;
  std::string text = citygml("EPSG:25832", false);
  const auto surface = [](double x) {
    char list[200];
    std::snprintf(list, sizeof list, "%.3f 5539109 42 %.3f 5539109 42 %.3f 5539109 44", 571666 + x, 571667 + x,
                  571667 + x);
    return std::string("<gml:Polygon><gml:exterior><gml:LinearRing><gml:posList>") + list +
           "</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon>";
  };
  const auto door = [&](double x) {
    return "<bldg:Door><bldg:lod2MultiSurface>" + surface(x) + surface(x + 0.5) +
           "</bldg:lod2MultiSurface></bldg:Door>";
  };
  text.insert(text.find("</bldg:Building>"), door(2) + door(6));
  const Loaded loaded = load_file(written(scratch, "a.gml", text));
  ASSERT_EQ(loaded.map.objects.size(), 2u);
  for (const auto& object : loaded.map.objects) EXPECT_EQ(object.kind, "door");
  EXPECT_NEAR(metres(loaded.map.objects[1].at.x - loaded.map.objects[0].at.x), 4, 0.01);
}

TEST(CityGml, SaysWhatIsBroken) {
  const ScratchDirectory scratch;
  const std::string text = citygml("EPSG:25832", false);
  const auto told = [&](const std::string& broken, const char* part) {
    const std::string what = failure([&] { load_file(written(scratch, "a.gml", broken)); });
    EXPECT_NE(what.find(part), std::string::npos) << what;
  };
  told(text.substr(0, text.size() / 2), "a.gml, line 1");
  std::string bad = text;
  bad.replace(bad.find("571666"), 6, "none  ");
  told(bad, "found none");
}

TEST(EpsgCode, IsFoundInEveryWayOfWritingIt) {
  EXPECT_EQ(epsg_code("EPSG:28992"), 28992);
  EXPECT_EQ(epsg_code("urn:ogc:def:crs:EPSG::25832"), 25832);
  EXPECT_EQ(epsg_code("http://www.opengis.net/def/crs/EPSG/6.12/3068"), 3068);
  EXPECT_EQ(epsg_code("urn:ogc:def:crs,crs:EPSG:6.12:31467,crs:EPSG:6.12:5783"), 31467);
  EXPECT_EQ(epsg_code("EPSG:12345678901234567890"), 0);
  EXPECT_EQ(epsg_code("WGS84"), 0);
}

}  // namespace
}  // namespace vicus::test
