#include "httpd/features.hpp"

#include "httpd/media_types.hpp"

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

/// NULL, as in the city's tables, where there is none.
Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Feature feature_of(const Sector& sector) {
  Feature feature{sector.id, sector.ground, {}, {}, {}};
  feature.properties = {{"kind", name_of(sector.kind)},
                        {"name", text_or_null(sector.name)},
                        {"names", sector.names},
                        {"bytes", sector.bytes}};
  for (const char* suffix : {".x3d", ".wrl", ".json"})
    feature.alternates.emplace_back(media_type_of_file(suffix), "/sectors/" + sector.id + suffix);
  return feature;
}

Feature feature_of(const Gate& gate) {
  Feature feature{gate.id, {}, gate.line, {}, {}};
  feature.properties = {{"kind", name_of(gate.kind)},
                        {"sector_id", gate.sector_id},
                        {"to_sector_id", text_or_null(gate.to_sector_id)},
                        {"twin_id", text_or_null(gate.twin_id)}};
  return feature;
}

Feature feature_of(const Building& building) {
  Feature feature{building.id, building.footprint, {}, {}, {}};
  feature.properties = {{"name", text_or_null(building.name)},
                        {"source_id", building.source_id},
                        {"sector_id", text_or_null(building.sector_id)},
                        {"base_m", building.base_m},
                        {"height_m", building.height_m},
                        {"eave_m", building.eave_m},
                        {"roof_shape", building.roof_shape},
                        {"roof_source", name_of(building.roof_source)},
                        {"height_source", name_of(building.height_source)},
                        {"tags", building.tags}};
  return feature;
}

Feature feature_of(const Interior& interior) {
  auto feature = feature_of(interior.sector);
  feature.properties.erase("names");
  feature.properties["building_id"] = interior.building_id;
  feature.properties["source_id"] = interior.source_id;
  feature.properties["floor_m"] = interior.floor_m;
  feature.properties["height_m"] = interior.height_m;
  return feature;
}

template <class Record>
std::vector<Feature> features_of(const std::vector<Record>& records) {
  std::vector<Feature> features;
  for (const auto& record : records) features.push_back(feature_of(record));
  return features;
}

template <class Record>
std::optional<Feature> feature_if(const std::optional<Record>& record) {
  return record ? std::optional(feature_of(*record)) : std::nullopt;
}

std::vector<Feature> fetch_sectors(const CityReader& city, const PlanBox& box, std::size_t limit, std::size_t offset) {
  std::vector<Feature> features;
  for (const auto& id : city.sectors_in(box, limit, offset))
    if (auto feature = feature_if(city.sector(id))) features.push_back(*std::move(feature));
  return features;
}

}  // namespace

const std::vector<Collection>& collections() {
  static const std::vector<Collection> all = {
      {"sectors", "Sectors", "Walkable ground, cut at gates: streets, crossroads, squares, yards, passages, open land",
       true, fetch_sectors, [](const CityReader& city, const std::string& id) { return feature_if(city.sector(id)); }},
      {"gates", "Gates", "Where one walks from a sector to the next, or out of the city", false,
       [](const CityReader& city, const PlanBox& box, std::size_t limit, std::size_t offset) {
         return features_of(city.gates_in(box, limit, offset));
       },
       [](const CityReader& city, const std::string& id) { return feature_if(city.gate(id)); }},
      {"houses", "Houses", "Footprints with heights and where these come from", true,
       [](const CityReader& city, const PlanBox& box, std::size_t limit, std::size_t offset) {
         return features_of(city.buildings_in(box, limit, offset));
       },
       [](const CityReader& city, const std::string& id) { return feature_if(city.building(id)); }},
      {"interiors", "Interiors", "Rooms behind doors", true,
       [](const CityReader& city, const PlanBox& box, std::size_t limit, std::size_t offset) {
         return features_of(city.interiors_in(box, limit, offset));
       },
       [](const CityReader& city, const std::string& id) { return feature_if(city.interior(id)); }}};
  return all;
}

}  // namespace vicus
