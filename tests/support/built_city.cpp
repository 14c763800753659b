#include "tests/support/built_city.hpp"

#include <cstdlib>

#include "sectorgen/town/town.hpp"
#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

namespace vicus::test {

City city_of_files(const std::vector<std::filesystem::path>& inputs, const City* previous) {
  LoadOptions load;
  load.inputs = inputs;
  std::vector<Issue> issues;
  SourceMap map = load_source_map(load, issues);
  BuildOptions options;
  options.previous = previous;
  options.with_visibility = false;
  options.with_textures = false;
  BuildReport report;
  return build_city(std::move(map), options, std::move(issues), report);
}

City city_of_osm(const std::string& osm, const City* previous) {
  const ScratchDirectory scratch;
  const auto file = scratch / "town.osm";
  write_bytes(file, osm);
  return city_of_files({file}, previous);
}

City random_town_city(std::uint64_t seed) { return city_of_osm(make_random_town(seed)); }

const std::vector<RealCity>& real_cities() {
  static const std::vector<RealCity> kCities = {
      {"Rochechouart", {"paris-rochechouart/paris-rochechouart.osm.pbf"}},
      {"LondonSoho", {"london-soho/london-soho.osm.pbf"}},
      {"PragueBubenec", {"prague-bubenec/bubenec.gpkg"}},
      {"Montmartre",
       {"paris-montmartre/buildings.geojsonl.gz", "paris-montmartre/streets.geojsonl.gz",
        "paris-montmartre/water.geojsonl.gz"}},
      {"Graz", {"graz/buildings.geojsonl.gz", "graz/streets.geojsonl.gz", "graz/water.geojsonl.gz"}},
      {"BerlinMitte",
       {"berlin-mitte/buildings.geojsonl.gz", "berlin-mitte/streets.geojsonl.gz", "berlin-mitte/water.geojsonl.gz"}}};
  return kCities;
}

std::optional<City> real_city(const RealCity& which) {
  const auto data = real_data();
  if (!data) return std::nullopt;
  std::vector<std::filesystem::path> inputs;
  for (const char* file : which.files) inputs.push_back(*data / file);
  return city_of_files(inputs);
}

std::vector<std::uint64_t> seeds(std::uint64_t first, std::uint64_t count) {
  if (const char* text = std::getenv("VICUS_SEEDS")) {
    char* end = nullptr;
    first = std::strtoull(text, &end, 10);
    if (*end == ',') count = std::strtoull(end + 1, nullptr, 10);
  }
  std::vector<std::uint64_t> out;
  for (std::uint64_t i = 0; i < count; ++i) out.push_back(first + i);
  return out;
}

}  // namespace vicus::test
