#pragma once
#include <functional>
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// The stages that turn a map into a city, in order: start reading here.
namespace vicus {

struct StageTime {
  std::string stage;
  double cpu_s = 0, wall_s = 0;
  double peak_mb = 0;  ///< largest resident size so far
};

struct BuildReport {
  std::vector<StageTime> stages;
};

struct BuildOptions {
  std::uint64_t budget_bytes = 200'000;  ///< per sector, as sent
  unsigned threads = 0;                  ///< 0: all cores
  const City* previous = nullptr;        ///< the city built before, whose sector ids are kept where sectors are the same
  std::function<void(const char* stage)> on_stage;  ///< progress
};

/// Needs   a map from load_source_map.
/// Fails   CityError(exit 4): no walkable ground at all.
City build_city(SourceMap map, const BuildOptions& options, std::vector<Issue> issues, BuildReport& report);

}  // namespace vicus
