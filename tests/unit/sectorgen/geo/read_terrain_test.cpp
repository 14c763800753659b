#include "sectorgen/geo/read_terrain.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <functional>

#include "city_db/terrain.hpp"
#include "tests/support/scratch.hpp"

namespace vicus {
namespace {

namespace fs = std::filesystem;

constexpr LatLon kOrigin{47.0707, 15.4395};
constexpr PlanBox kBox{{-200'000, -150'000}, {301'000, 250'000}};
constexpr float kNoData = -9999;

/// A GeoTIFF of 1 second of arc (31 m x 21 m) around the origin; heights by longitude and latitude.
struct Spec {
  int epsg = 4326;  ///< 0: none
  double west = 15.43, north = 47.08, step_deg = 1.0 / 3600;
  int columns = 80, rows = 80;
  std::function<double(double lon, double lat)> height = [](double, double) { return 350.25; };
  const char* unit = "";
};

void write_raster(const fs::path& path, const Spec& spec) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  ASSERT_NE(driver, nullptr);
  const GDALDatasetUniquePtr dataset(driver->Create(path.c_str(), spec.columns, spec.rows, 1, GDT_Float32, nullptr));
  ASSERT_TRUE(dataset);
  double transform[6] = {spec.west, spec.step_deg, 0, spec.north, 0, -spec.step_deg};
  dataset->SetGeoTransform(transform);
  if (spec.epsg != 0) {
    OGRSpatialReference system;
    system.importFromEPSG(spec.epsg);
    dataset->SetSpatialRef(&system);
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  band.SetNoDataValue(kNoData);
  band.SetUnitType(spec.unit);
  std::vector<float> values;
  for (int row = 0; row < spec.rows; ++row)
    for (int column = 0; column < spec.columns; ++column)
      values.push_back(static_cast<float>(
          spec.height(spec.west + (column + 0.5) * spec.step_deg, spec.north - (row + 0.5) * spec.step_deg)));
  ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, spec.columns, spec.rows, values.data(), spec.columns, spec.rows, GDT_Float32,
                          0, 0, nullptr),
            CE_None);
}

struct Outcome {
  ReadTerrain read;
  std::vector<Issue> issues;
  std::string error;
};
Outcome read(const Spec& spec, const TerrainOptions& options = {}) {
  test::ScratchDirectory scratch;
  write_raster(scratch / "dem.tif", spec);
  Outcome outcome;
  try {
    outcome.read = read_terrain(scratch / "dem.tif", PlanFrame(kOrigin), kBox, options, outcome.issues);
  } catch (const CityError& error) {
    outcome.error = error.what();
  }
  return outcome;
}

double plane(double lon, double lat) { return 360 + 4000 * (lon - 15.4395) - 6000 * (lat - 47.0707); }

TEST(ReadTerrain, CoversTheBoxAndHasTheHeightOfAnInclinedPlane) {
  const auto outcome = read({.height = plane});
  ASSERT_EQ(outcome.error, "");
  EXPECT_TRUE(outcome.issues.empty());
  const Terrain& t = outcome.read.terrain;
  EXPECT_EQ(t.corner, kBox.min);
  EXPECT_EQ(t.step_mm, 5000);
  EXPECT_EQ(t.columns, 102u);  // 501 m: 101 steps
  EXPECT_EQ(t.rows, 81u);
  EXPECT_FALSE(outcome.read.is_coarsened);
  const PlanFrame frame(kOrigin);
  double lowest = 1e9;
  for (int x = kBox.min.x; x <= kBox.max.x; x += 7'000)
    for (int y = kBox.min.y; y <= kBox.max.y; y += 7'000) {
      const LatLon p = frame.latlon_from_plan({x, y});
      EXPECT_NEAR(height_m(t, {x, y}) + outcome.read.base_m, plane(p.lon_deg, p.lat_deg), 0.002);
    }
  for (const auto mm : t.height_mm) lowest = std::min(lowest, mm / 1000.0);
  EXPECT_GE(lowest, 0);
  EXPECT_LT(lowest, 1);
}

TEST(ReadTerrain, ReadsAProjectedRasterAndFeet) {
  // UTM 33: the origin of the plan lies at 533,366 E 5,213,215 N or so; a constant needs no more.
  const auto outcome = read({.epsg = 32633,
                             .west = 531'000,
                             .north = 5'215'000,
                             .step_deg = 50,
                             .columns = 100,
                             .rows = 100,
                             .height = [](double, double) { return 1000.0; },
                             .unit = "ft"});
  ASSERT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.read.base_m, 304);
  for (const auto mm : outcome.read.terrain.height_mm) ASSERT_EQ(mm, 800);
}

TEST(ReadTerrain, FillsHolesFromTheHeightsAround) {
  // No height east of the origin, and a value that is no height in the south-west.
  const auto outcome = read({.height = [](double lon, double lat) {
    return lon > 15.4395 ? kNoData : lat < 47.0697 && lon < 15.4385 ? 1e6 : 400.0;
  }});
  ASSERT_EQ(outcome.error, "");
  for (const auto mm : outcome.read.terrain.height_mm) ASSERT_EQ(mm, 0);
  EXPECT_EQ(outcome.read.base_m, 400);
  ASSERT_EQ(outcome.issues.size(), 1u);
  EXPECT_EQ(outcome.issues[0].code, IssueCode::terrain_hole);
  EXPECT_GT(outcome.read.filled, outcome.read.terrain.height_mm.size() / 2);
  EXPECT_LT(outcome.read.filled, outcome.read.terrain.height_mm.size());
  EXPECT_TRUE(outcome.issues[0].message.starts_with(std::to_string(outcome.read.filled) + " of 8262 nodes"))
      << outcome.issues[0].message;
  EXPECT_EQ(outcome.issues[0].source_id, "dem.tif");
  EXPECT_EQ(outcome.issues[0].at, kBox.min);
}

TEST(ReadTerrain, HoldsOnToTheRasterWhereItEnds) {
  // The raster ends 100 m north of the origin.
  const auto outcome = read({.north = 47.0716, .height = plane});
  ASSERT_EQ(outcome.error, "");
  EXPECT_GT(outcome.read.filled, 0u);
  const double rim = height_m(outcome.read.terrain, {0, 95'000}), beyond = height_m(outcome.read.terrain, {0, 250'000});
  EXPECT_NEAR(beyond, rim, 1.0);
}

TEST(ReadTerrain, WidensTheStepWhereThereWouldBeTooManyNodes) {
  const auto outcome = read({}, {.step_mm = 5000, .most_nodes = 2000});
  EXPECT_TRUE(outcome.read.is_coarsened);
  EXPECT_EQ(outcome.read.terrain.step_mm, 11'000);
  EXPECT_LE(outcome.read.terrain.height_mm.size(), 2000u);
}

TEST(ReadTerrain, SaysWhatIsWrongWithARaster) {
  const auto has = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(read({.epsg = 0}).error, "dem.tif: it has no coordinate system on the earth");
  has(read({.west = 2.3}).error, "does not cover any of the city");
  has(read({.epsg = 32633}).error, "does not cover any of the city");
  has(read({.height = [](double, double) { return kNoData; }}).error, "no height anywhere in the city");
  test::ScratchDirectory scratch;
  test::write_bytes(scratch / "text.tif", "no raster");
  std::vector<Issue> issues;
  for (const char* name : {"text.tif", "none.tif"}) {
    try {
      read_terrain(scratch / name, PlanFrame(kOrigin), kBox, {}, issues);
      ADD_FAILURE() << name;
    } catch (const CityError& error) {
      has(error.what(), "expected a raster with heights");
      EXPECT_EQ(error.exit_code, 4);
    }
  }
}

}  // namespace
}  // namespace vicus
