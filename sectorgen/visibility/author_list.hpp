#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// A person's list of important sectors (paper 004 §4.1.7), one a line.
///
/// CSV         PLACE[,VICINITY_M] or LAT,LON[,VICINITY_M]; a place with commas or quotation marks stands in quotation
///             marks, doubled inside
/// JSON lines  {"place": "Place Garibaldi", "vicinity_m": 300} or {"lat": 48.877, "lon": 2.345}
/// PLACE is a sector's id, or the name of a street or square: then every sector that bears it. Empty lines, lines that
/// begin with # and a first line "place..." are passed over. Vicinity 0 takes the mark away from a sector.
namespace vicus {

inline constexpr double kVicinity_m = 500;
/// A place given by degrees may lie in a house: then the sector is meant that is nearest, up to so far.
inline constexpr double kNearPlace_m = 50;
/// A city is smaller; a larger number is a mistake.
inline constexpr double kMostVicinity_m = 100'000;

struct AuthorEntry {
  std::string place;  ///< empty where `at` is set
  std::optional<LatLon> at;
  double vicinity_m = kVicinity_m;
  std::string source_id;  ///< FILE#LINE, from 1
};

/// A line that cannot be read becomes issue 101.
/// Fails   CityError: the file cannot be read.
std::vector<AuthorEntry> read_author_list(const std::filesystem::path& path, std::vector<Issue>& issues);

/// Degrees to the plan, from whoever knows the projection; nullopt: out of the lattice.
using PlanOf = std::function<std::optional<PlanPoint>(LatLon)>;

/// Marks the sectors of each entry. A place the city does not have becomes issue 104.
void mark_author_list(City& city, const std::vector<AuthorEntry>& list, const PlanOf& plan_of,
                      std::vector<Issue>& issues);

}  // namespace vicus
