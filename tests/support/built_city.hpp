#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sectorgen/build_city.hpp"

/// Cities made by the generator, in memory; L_vis is left to those who ask for it.
namespace vicus::test {

City city_of_files(const std::vector<std::filesystem::path>& inputs, const City* previous = nullptr);
City city_of_osm(const std::string& osm, const City* previous = nullptr);
/// make_random_town(seed), built.
City random_town_city(std::uint64_t seed);

struct RealCity {
  const char* name;
  std::vector<const char*> files;  ///< below the data folder
};
const std::vector<RealCity>& real_cities();
/// nullopt where the data is missing.
std::optional<City> real_city(const RealCity& which);

/// VICUS_SEEDS=first,count runs others than first .. first + count - 1.
std::vector<std::uint64_t> seeds(std::uint64_t first, std::uint64_t count);

}  // namespace vicus::test
