#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "city_db/store.hpp"

/// Records of the city as features: geometry and properties.
namespace vicus {

struct Feature {
  std::string id;
  Polygon area;                 ///< of an area
  std::vector<PlanPoint> line;  ///< of anything else
  nlohmann::ordered_json properties;
  std::vector<std::pair<std::string, std::string>> alternates;  ///< media type and path of the same thing elsewhere
};

struct Collection {
  const char* name;
  const char* title;
  const char* description;
  bool is_area;
  /// Records whose box meets `box`, in id order: at most `limit` after `offset`.
  std::vector<Feature> (*fetch)(const CityReader& city, const PlanBox& box, std::size_t limit, std::size_t offset);
  std::optional<Feature> (*find)(const CityReader& city, const std::string& id);
};

const std::vector<Collection>& collections();

}  // namespace vicus
