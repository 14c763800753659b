#include <gtest/gtest.h>

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

namespace vicus::test {
namespace {

namespace fs = std::filesystem;

struct RealCity {
  const char* name;
  std::vector<const char*> files;
  std::size_t footprints, axes;  // at least
};

class RealMap : public testing::TestWithParam<RealCity> {};

TEST_P(RealMap, ReadsWithEveryFootprintValid) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  std::vector<fs::path> inputs;
  for (const char* file : GetParam().files) inputs.push_back(*data / file);
  const std::clock_t before = std::clock();
  const Loaded loaded = load(inputs);
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  std::cout << GetParam().name << ": " << seconds << " s CPU, " << loaded.map.footprints.size() << " footprints, "
            << loaded.map.axes.size() << " axes, " << loaded.issues.size() << " issues\n";
  EXPECT_GE(loaded.map.footprints.size(), GetParam().footprints);
  EXPECT_GE(loaded.map.axes.size(), GetParam().axes);
  EXPECT_EQ(broken_promise(loaded.map), "");
}

INSTANTIATE_TEST_SUITE_P(
    Cities, RealMap,
    testing::Values(RealCity{"Rochechouart", {"paris-rochechouart/paris-rochechouart.osm.pbf"}, 740, 100},
                    RealCity{"RochechouartXml", {"paris-rochechouart/paris-rochechouart.osm.gz"}, 740, 100},
                    RealCity{"LondonSoho", {"london-soho/london-soho.osm.pbf"}, 400, 70},
                    RealCity{"BerlinNeukoelln", {"berlin-details/berlin-neukoelln-2024.osm.pbf"}, 200, 40},
                    RealCity{"BerlinSiegessaeule", {"berlin-details/berlin-siegessaeule-2017.osm.pbf"}, 120, 50},
                    RealCity{"RotterdamModels", {"citymodels-cityjson/rotterdam-3-20-delfshaven.city.json.gz"}, 840, 0},
                    RealCity{"ZurichModels", {"citymodels-cityjson/zurich_subset_lod2.city.json.gz"}, 100, 0},
                    RealCity{"TokyoModels", {"citymodels-citygml/plateau_tokyo_53392642_bldg_op2.gml.gz"}, 8, 0},
                    RealCity{"IngolstadtModel", {"ingolstadt-lod3/example_4018216.xml"}, 1, 0},
                    RealCity{"PragueBubenec", {"prague-bubenec/bubenec.gpkg"}, 144, 35},
                    RealCity{"Lyon1", {"lyon1-heights/buildings_lyon1.geojson.gz"}, 2500, 0},
                    RealCity{"Montmartre",
                             {"paris-montmartre/buildings.geojsonl.gz", "paris-montmartre/streets.geojsonl.gz",
                              "paris-montmartre/water.geojsonl.gz"},
                             4800,
                             800},
                    RealCity{"Graz",
                             {"graz/buildings.geojsonl.gz", "graz/streets.geojsonl.gz", "graz/water.geojsonl.gz"},
                             13000,
                             4000},
                    RealCity{"BerlinMitte",
                             {"berlin-mitte/buildings.geojsonl.gz", "berlin-mitte/streets.geojsonl.gz",
                              "berlin-mitte/water.geojsonl.gz"},
                             15000,
                             4000}),
    [](const auto& info) { return info.param.name; });

TEST(RealMaps, EqualInputGivesEqualMapsInWhicheverForm) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  const Loaded pbf = load({*data / "paris-rochechouart/paris-rochechouart.osm.pbf"});
  const Loaded xml = load({*data / "paris-rochechouart/paris-rochechouart.osm.gz"});
  ASSERT_EQ(pbf.map.footprints.size(), xml.map.footprints.size());
  for (std::size_t i = 0; i < pbf.map.footprints.size(); ++i) {
    EXPECT_EQ(pbf.map.footprints[i].source_id, xml.map.footprints[i].source_id);
    EXPECT_EQ(pbf.map.footprints[i].area.outer, xml.map.footprints[i].area.outer);
    EXPECT_EQ(pbf.map.footprints[i].height_m, xml.map.footprints[i].height_m);
  }
  EXPECT_EQ(pbf.issues.size(), xml.issues.size());
}

/// A map that holds nothing we need is refused by CityError; everything else must come out valid.
void read_without_harm(const fs::path& path, std::size_t& maps, std::size_t& footprints) {
  SCOPED_TRACE(path.string());
  try {
    const Loaded loaded = load({path});
    ++maps;
    footprints += loaded.map.footprints.size();
    EXPECT_EQ(broken_promise(loaded.map), "");
  } catch (const CityError& error) {
    EXPECT_EQ(error.exit_code, 4);
    EXPECT_GT(std::string(error.what()).size(), 20u);
  }
}

TEST(HardGeometry, EveryOsmFileOfTheCorpusReadsOrIsRefused) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  std::size_t files = 0, maps = 0, footprints = 0;
  for (const char* folder : {"hard-geometry/osm-testdata", "hard-geometry/osm2world"})
    for (const auto& entry : fs::recursive_directory_iterator(*data / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".osm" && extension != ".pbf") continue;
      ++files;
      read_without_harm(entry.path(), maps, footprints);
    }
  std::cout << files << " files, " << maps << " of them maps, " << footprints << " footprints\n";
  EXPECT_GE(files, 100u);
  EXPECT_GE(footprints, 50u);
}

/// osm-testdata's multipolygons are tagged landuse and the like: as houses they go through the assembler.
TEST(HardGeometry, EveryMultipolygonCaseReadsAsAHouse) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  const ScratchDirectory scratch;
  std::size_t maps = 0, footprints = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*data / "hard-geometry/osm-testdata")) {
    if (entry.path().extension() != ".osm") continue;
    std::string text = read_bytes(entry.path());
    for (const char* key : {"landuse", "natural", "test:section"})
      for (std::size_t at = 0; (at = text.find("k=\"" + std::string(key) + "\"", at)) != std::string::npos;)
        text.replace(at, std::string(key).size() + 4, "k=\"building\"");
    for (std::size_t at = 0; (at = text.find("k='landuse'", at)) != std::string::npos;)
      text.replace(at, 11, "k='building'");
    const fs::path copy = scratch / (std::to_string(maps) + "_" + entry.path().filename().string());
    write_bytes(copy, text);
    read_without_harm(copy, maps, footprints);
  }
  EXPECT_GE(maps, 100u);
  EXPECT_GE(footprints, 100u);
}

/// [[ring, ring, ...], ...] of any unit: scaled into a hundredth of a degree around 0, 0. Rings as they are.
nlohmann::json as_feature_collection(const nlohmann::json& rings) {
  double low = 1e300, high = -1e300;
  for (const auto& ring : rings)
    for (const auto& point : ring)
      for (int k = 0; k < 2; ++k) {
        low = std::min(low, point[k].get<double>());
        high = std::max(high, point[k].get<double>());
      }
  const double scale = high > low ? 0.01 / (high - low) : 1;
  nlohmann::json coordinates = nlohmann::json::array();
  for (const auto& ring : rings) {
    nlohmann::json scaled = nlohmann::json::array();
    for (const auto& point : ring)
      scaled.push_back({(point[0].get<double>() - low) * scale, (point[1].get<double>() - low) * scale});
    if (!scaled.empty() && scaled.front() != scaled.back()) scaled.push_back(scaled.front());
    coordinates.push_back(scaled);
  }
  return {{"type", "FeatureCollection"},
          {"name", "buildings"},
          {"features",
           {{{"type", "Feature"},
             {"properties", {{"height", 10}}},
             {"geometry", {{"type", "Polygon"}, {"coordinates", coordinates}}}}}}};
}

TEST(HardGeometry, EveryTriangulationCaseComesOutValid) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "real data is missing: set VICUS_DATA";
  const ScratchDirectory scratch;
  std::size_t files = 0, maps = 0, footprints = 0;
  for (const auto& entry : fs::directory_iterator(*data / "hard-geometry/earcut/test/fixtures")) {
    if (entry.path().extension() != ".json") continue;
    const fs::path copy = scratch / (entry.path().stem().string() + ".geojson");
    std::ifstream in(entry.path());
    write_bytes(copy, as_feature_collection(nlohmann::json::parse(in)).dump());
    ++files;
    read_without_harm(copy, maps, footprints);
  }
  EXPECT_GE(files, 50u);
  EXPECT_GE(footprints, 50u);
}

}  // namespace
}  // namespace vicus::test
