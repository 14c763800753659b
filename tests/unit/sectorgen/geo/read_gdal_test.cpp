#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "sectorgen/geo/plan_frame.hpp"
#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

namespace vicus::test {
namespace {

namespace fs = std::filesystem;

/// A layer of 20 x 20 unit squares along x, or of one line, with a HEIGHT and a NAME.
struct LayerSpec {
  std::string name;
  bool is_lines = false;
  double x = 0, y = 0, size = 20;
  int epsg = 0;  // 0: none
};

void write_layers(const fs::path& path, const char* driver_name, const std::vector<LayerSpec>& layers) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  ASSERT_NE(driver, nullptr) << driver_name;
  const GDALDatasetUniquePtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  ASSERT_TRUE(dataset);
  for (const LayerSpec& spec : layers) {
    OGRSpatialReference system;
    if (spec.epsg != 0) {
      system.importFromEPSG(spec.epsg);
      system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    }
    OGRLayer* layer = dataset->CreateLayer(spec.name.c_str(), spec.epsg ? &system : nullptr,
                                           spec.is_lines ? wkbLineString : wkbPolygon, nullptr);
    ASSERT_NE(layer, nullptr);
    OGRFieldDefn height("HEIGHT", OFTReal), name("NAME", OFTString);
    layer->CreateField(&height);
    layer->CreateField(&name);
    for (int i = 0; i < 3; ++i) {
      OGRFeature feature(layer->GetLayerDefn());
      feature.SetField("HEIGHT", 10.0 + i);
      feature.SetField("NAME", "Häuser");
      OGRLineString line;
      const double x = spec.x + 2 * spec.size * i, y = spec.y, s = spec.size;
      for (const auto& [dx, dy] : {std::pair(0.0, 0.0), std::pair(s, 0.0), std::pair(s, s), std::pair(0.0, s)})
        line.addPoint(x + dx, y + dy);
      OGRPolygon polygon;
      OGRLinearRing ring;
      ring.addSubLineString(&line);
      ring.closeRings();
      polygon.addRing(&ring);
      feature.SetGeometry(spec.is_lines ? static_cast<OGRGeometry*>(&line) : &polygon);
      ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
  }
}

/// Paris in Lambert-93, whose scale there is about 1.
const LayerSpec kBuildings{"buildings", false, 652'000, 6'862'000, 20, 2154};
const LayerSpec kStreets{"streets", true, 652'000, 6'861'980, 20, 2154};

class Format : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Format, ReadsWithItsCoordinateSystemAndAttributes) {
  const auto [driver, file] = GetParam();
  const ScratchDirectory scratch;
  write_layers(scratch / file, driver, {kBuildings});
  const Loaded loaded = load({scratch / file});
  ASSERT_EQ(loaded.map.footprints.size(), 3u);
  EXPECT_TRUE(loaded.issues.empty());
  EXPECT_EQ(broken_promise(loaded.map), "");
  double heights = 0;  // their order is the format's own
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(area_by_geos_m2(loaded.map.footprints[i].area), 400, 1);
    heights += loaded.map.footprints[i].height_m;
    EXPECT_EQ(loaded.map.footprints[i].height_source, HeightSource::measured);
    EXPECT_EQ(loaded.map.footprints[i].name, "Häuser");
  }
  EXPECT_EQ(heights, 10 + 11 + 12);
  EXPECT_NEAR(loaded.map.origin.lat_deg, 48.857, 0.01);
  EXPECT_NEAR(loaded.map.origin.lon_deg, 2.346, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Drivers, Format,
                         testing::Values(std::pair("GPKG", "buildings.gpkg"), std::pair("FlatGeobuf", "buildings.fgb"),
                                         std::pair("ESRI Shapefile", "buildings.shp")),
                         [](const auto& info) { return std::string(info.param.first).substr(0, 4); });

TEST(ReadGdal, LayersAreRecognisedByName) {
  const ScratchDirectory scratch;
  LayerSpec plots = kBuildings, cells = kBuildings, water = kBuildings;
  plots.name = "plots";
  cells.name = "tessellation";
  water.name = "water";
  write_layers(scratch / "city.gpkg", "GPKG", {kBuildings, kStreets, plots, cells, water});
  const Loaded loaded = load({scratch / "city.gpkg"});
  EXPECT_EQ(loaded.map.footprints.size(), 3u);
  EXPECT_EQ(loaded.map.axes.size(), 3u);
  ASSERT_EQ(loaded.map.areas.size(), 6u);
  EXPECT_EQ(loaded.map.areas[0].kind, AreaKind::plot);
  EXPECT_EQ(loaded.map.areas[5].kind, AreaKind::water);
  EXPECT_EQ(loaded.map.axes[0].kind, "unknown");
}

TEST(ReadGdal, LayersAreTakenAsNamed) {
  const ScratchDirectory scratch;
  LayerSpec odd = kBuildings, lines = kStreets;
  odd.name = "a";
  odd.x += 500;
  lines.name = "b";
  write_layers(scratch / "city.gpkg", "GPKG", {kBuildings, kStreets, odd, lines});
  LoadOptions options;
  options.inputs = {scratch / "city.gpkg"};
  options.buildings_layer = (scratch / "city.gpkg").string() + ":a";
  options.streets_layer = (scratch / "city.gpkg").string() + ":b";
  const Loaded loaded = load(options);
  ASSERT_EQ(loaded.map.footprints.size(), 3u);
  EXPECT_EQ(loaded.map.footprints[0].source_id, "a#1");
  ASSERT_EQ(loaded.map.axes.size(), 3u);
  EXPECT_EQ(loaded.map.axes[0].source_id, "b#1");
  options.buildings_layer = (scratch / "city.gpkg").string() + ":c";
  EXPECT_THROW(load(options), CityError);
}

TEST(ReadGdal, BuildingsFromOneFileAndStreetsFromAnotherMeetInOneFrame) {
  const ScratchDirectory scratch;
  LayerSpec mercator_streets = kStreets;
  // The same place in another system.
  mercator_streets.epsg = 3857;
  mercator_streets.x = 261'000;
  mercator_streets.y = 6'250'000;
  write_layers(scratch / "buildings.gpkg", "GPKG", {kBuildings});
  write_layers(scratch / "streets.fgb", "FlatGeobuf", {mercator_streets});
  const Loaded loaded = load({scratch / "buildings.gpkg", scratch / "streets.fgb"});
  ASSERT_EQ(loaded.map.footprints.size(), 3u);
  ASSERT_EQ(loaded.map.axes.size(), 3u);
  EXPECT_LT(std::abs(loaded.map.axes[0].line[0].x), 3'000'000);
}

TEST(ReadGdal, TheBoundaryIsItsFilesPolygons) {
  const ScratchDirectory scratch;
  LayerSpec rim = kBuildings;
  rim.name = "rim";
  rim.size = 500;
  write_layers(scratch / "buildings.gpkg", "GPKG", {kBuildings});
  write_layers(scratch / "rim.gpkg", "GPKG", {rim});
  LoadOptions options;
  options.inputs = {scratch / "buildings.gpkg"};
  options.boundary = scratch / "rim.gpkg";
  EXPECT_EQ(load(options).map.boundary.size(), 3u);
  options.boundary = scratch / "buildings.gpkg";
  EXPECT_EQ(load(options).map.footprints.size(), 3u);
}

std::string refusal(const fs::path& path) {
  try {
    load({path});
  } catch (const CityError& error) {
    EXPECT_EQ(error.exit_code, 4);
    return error.what();
  }
  return "";
}

TEST(CoordinateSystem, AMissingOneIsAClearError) {
  const ScratchDirectory scratch;
  LayerSpec none = kBuildings;
  none.epsg = 0;
  write_layers(scratch / "buildings.shp", "ESRI Shapefile", {none});
  const std::string what = refusal(scratch / "buildings.shp");
  for (const char* part : {"buildings.shp", "layer buildings", "no coordinate system", "ogr2ogr"})
    EXPECT_NE(what.find(part), std::string::npos) << part << " in: " << what;
  // Metres that happen to be less than 90.
  none.x = none.y = 0;
  none.size = 15;
  write_layers(scratch / "plan.shp", "ESRI Shapefile", {none});
  EXPECT_NE(refusal(scratch / "plan.shp").find("no coordinate system"), std::string::npos);
}

TEST(CoordinateSystem, AnAbsurdOneIsAClearError) {
  const ScratchDirectory scratch;
  // Lambert-93 coordinates declared as degrees, then as Krovak.
  LayerSpec wrong = kBuildings;
  wrong.epsg = 4326;
  write_layers(scratch / "buildings.gpkg", "GPKG", {wrong});
  const std::string what = refusal(scratch / "buildings.gpkg");
  for (const char* part : {"buildings.gpkg", "layer buildings", "EPSG:4326", "-a_srs"})
    EXPECT_NE(what.find(part), std::string::npos) << part << " in: " << what;
  wrong.epsg = 5514;
  write_layers(scratch / "czech.gpkg", "GPKG", {wrong});
  EXPECT_NE(refusal(scratch / "czech.gpkg").find("EPSG:5514"), std::string::npos);
}

TEST(CoordinateSystem, GeoJsonWithoutOneMustBeInDegrees) {
  const ScratchDirectory scratch;
  const std::string metres_text =
      R"({"type":"Feature","properties":{"building":"yes"},"geometry":{"type":"Polygon","coordinates":)"
      R"([[[652000,6862000],[652020,6862000],[652020,6862020],[652000,6862000]]]}})";
  write_bytes(scratch / "buildings.geojson", R"({"type":"FeatureCollection","features":[)" + metres_text + "]}");
  write_bytes(scratch / "buildings.geojsonl", metres_text + "\n");
  for (const char* file : {"buildings.geojson", "buildings.geojsonl"}) {
    const std::string what = refusal(scratch / file);
    EXPECT_NE(what.find(file), std::string::npos) << what;
    EXPECT_NE(what.find("4326"), std::string::npos) << what;
  }
}

std::string square_at(double lon, double lat, double size) {
  const auto text = [](double v) { return std::to_string(v); };
  const auto wrapped = [](double v) { return v > 180 ? v - 360 : v; };
  std::string ring;
  for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1), std::pair(0, 0)})
    ring += (ring.empty() ? "[" : ",[") + text(wrapped(lon + dx * size)) + "," + text(lat + dy * size / 10) + "]";
  return R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":[[)" + ring +
         "]]}}\n";
}

TEST(FarPlaces, ACityAcrossTheDateLineStaysInOnePiece) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "buildings.geojsonl", square_at(179.9990, -16.8, 0.0003) + square_at(179.9999, -16.8, 0.0003) +
                                                  square_at(180.0006, -16.8, 0.0003));
  const Loaded loaded = load({scratch / "buildings.geojsonl"});
  ASSERT_EQ(loaded.map.footprints.size(), 3u);
  EXPECT_TRUE(loaded.issues.empty());
  for (const Footprint& footprint : loaded.map.footprints) {
    EXPECT_NEAR(area_by_geos_m2(footprint.area), 32.0 * 3.32, 2);
    EXPECT_LT(std::abs(footprint.area.outer[0].x), 150'000);
  }
  EXPECT_NEAR(std::abs(loaded.map.origin.lon_deg), 180, 0.001);
}

TEST(FarPlaces, ACityAt85DegreesNorthKeepsItsSizes) {
  const ScratchDirectory scratch;
  write_bytes(scratch / "buildings.geojsonl", square_at(20, 85, 0.003) + square_at(20.01, 85, 0.003));
  const Loaded loaded = load({scratch / "buildings.geojsonl"});
  ASSERT_EQ(loaded.map.footprints.size(), 2u);
  EXPECT_NEAR(area_by_geos_m2(loaded.map.footprints[0].area), 29.2 * 33.5, 5);
}

TEST(FarPlaces, OneLostFeatureDoesNotMoveTheCity) {
  const ScratchDirectory scratch;
  std::string text = square_at(0, 0, 0.0003);
  for (int i = 0; i < 5; ++i) text += square_at(2.35 + i * 0.001, 48.87, 0.0003);
  write_bytes(scratch / "buildings.geojsonl", text);
  const Loaded loaded = load({scratch / "buildings.geojsonl"});
  EXPECT_EQ(loaded.map.footprints.size(), 5u);
  EXPECT_EQ(loaded.count(IssueCode::outside_limits), 1u);
  EXPECT_NEAR(loaded.map.origin.lat_deg, 48.87, 0.01);
}

}  // namespace
}  // namespace vicus::test
