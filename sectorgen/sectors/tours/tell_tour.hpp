#pragma once
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "city_db/tour.hpp"
#include "sectorgen/sectors/tours/shortest_walk.hpp"

/// From walks to what is shown and said of them.
namespace vicus {

/// What a tour tells of a city.
struct TourCity {
  std::vector<Sector> sectors;  ///< as the walks number them; grounds are not needed
  std::vector<Viewpoint> viewpoints;
  Terrain terrain;
};

/// One walk for each two stops that follow each other.
///
/// Steps   a new step where a street of another name begins. Short grounds without a name, and crossroads on the way
///         along one street, are passed without a word. Turns are measured from 20 m before to 20 m after, where the
///         way is that long: the bend in a crossroads counts, the step round a lamp does not.
/// Needs   stops.size() == walks.size() + 1, walks not empty.
Tour tell_tour(const TourCity& city, std::vector<TourPlace> stops, const std::vector<Walk>& walks);

/// "north", "north-east", ... for a heading clockwise from north.
const char* compass_word(double heading_deg);

}  // namespace vicus
