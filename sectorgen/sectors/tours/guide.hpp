#pragma once
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "city_db/tour.hpp"

/// Who knows the ways and the names of a city: all that `vicus tour`, /tours and /search ask.
namespace vicus {

/// Nothing changes after it is made: any number of threads may ask at once.
class Guide {
 public:
  /// Reads the city's grounds, gates, names, and makes the mesh of its ground.
  /// Fails   CityError as read_city.   Cost   docs/tours.md.
  explicit Guide(const std::filesystem::path& city);
  ~Guide();

  /// A walk from stop to stop, each leg the shortest (shortest_walk.hpp) that keeps kWalkClearance_mm off walls where
  /// there is room (corner_caps.hpp).
  /// A stop is the id of a sector, of an interior (its door to the street), LAT,LON in degrees within kBesideGround_m
  /// of ground, or a name: the best that search() finds if it has every word.
  TourAnswer tour(const TourQuery& query) const;

  /// Best first (gazetteer.hpp), each with where one stands: the ground nearest to it.
  std::vector<TourPlace> search(std::string_view typed, std::size_t limit) const;

  /// Round trips past the city's sights and squares, where it has some. Made at the first call.
  const std::vector<TourProposal>& proposals() const;

  static constexpr double kBesideGround_m = 100;
  static constexpr std::size_t kMostStops = 20, kLongestName = 200;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vicus
