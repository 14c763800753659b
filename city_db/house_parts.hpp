#pragma once
#include "city_db/city.hpp"

/// Houses that a map gives in parts are several buildings of one house.
namespace vicus {

/// Tag of ours: the source_id of the house that a building is a part of.
inline constexpr const char* kPartOf = "part_of";

/// The same for all parts of a house: what makes them look alike.
inline const std::string& house_of(const Building& building) {
  const auto part_of = building.tags.find(kPartOf);
  return part_of == building.tags.end() ? building.id : part_of->second;
}

}  // namespace vicus
