#pragma once
#include <map>
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/sectors/tours/gazetteer.hpp"

/// What of a city has a name or an address.
namespace vicus {

/// Streets and squares (one of each name, where it is widest), named houses and addresses, named objects: shops,
/// sights, stops, interiors. A house's place is before its door, or its longest front, and looks at it. Places are
/// where the map has them: some are not on the ground one walks on. `degrees` and heights are left out. Needs sectors,
/// buildings, borders, facades, objects, viewpoints, interiors, doors; the other lists may be empty.
std::vector<NamedPlace> named_places(const City& city);

/// Each interior by its id, named or not: before the door by which one comes to it from a street through the fewest
/// doors, looking at that door. `detail`: its house, where it has a name or an address, else the street.
std::map<std::string, TourPlace> interior_places(const City& city);

/// A point well inside the sector's ground.
PlanPoint middle_of(const Sector& sector);

/// "Rue Haute 12" from tags addr:*; `street`: where they name none. Empty: no house number.
std::string address_of(const Tags& tags, const std::string& street);

}  // namespace vicus
