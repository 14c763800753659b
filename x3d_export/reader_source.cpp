#include <limits>

#include "x3d_export/city_index.hpp"

namespace vicus {

RecordSource source_of(const CityReader& reader) {
  RecordSource source;
  source.sector = [&reader](const std::string& id) {
    auto sector = reader.sector(id);
    if (!sector)
      if (auto room = reader.interior(id)) sector = std::move(room->sector);
    return sector;
  };
  source.gates_of = [&reader](const std::string& id) { return reader.gates_of(id); };
  source.doors_of = [&reader](const std::string& id) { return reader.doors_of(id); };
  source.viewpoints_of = [&reader](const std::string& id) { return reader.viewpoints_of(id); };
  source.objects_of = [&reader](const std::string& id) { return reader.objects_of(id); };
  source.visible_from = [&reader](const std::string& id) { return reader.visible_from(id); };
  source.impostors_of = [&reader](const std::string& id) { return reader.impostors_of(id); };
  source.panorama_of = [&reader](const std::string& id) { return reader.panorama_of(id); };
  source.houses_in = [&reader](const PlanBox& box) {
    return reader.buildings_in(box, std::numeric_limits<std::int32_t>::max(), 0);
  };
  source.sector_ids = [&reader] { return reader.sector_ids(); };
  source.meta = [&reader](const std::string& key) { return reader.meta(key).value_or(""); };
  return source;
}

std::optional<City> city_around(const CityReader& reader, const std::string& id) {
  auto sector = reader.sector(id);
  if (!sector) return std::nullopt;
  City city;
  city.meta["licences"] = reader.meta("licences").value_or("");
  for (const char* image : {"atlas", "grain"})
    if (const auto id = reader.meta(image)) city.meta[image] = *id;
  city.gates = reader.gates_of(id);
  city.doors = reader.doors_of(id);
  city.borders = reader.borders_of(id);
  city.buildings = reader.buildings_of(id);
  city.facades = reader.facades_of(id);
  city.objects = reader.objects_of(id);
  city.surfaces = reader.surfaces_of(id);
  city.rides = reader.rides_of(id);
  city.prototypes = reader.prototypes();
  city.viewpoints = reader.viewpoints_of(id);
  city.visible = reader.visible_from(id);
  city.impostors = reader.impostors_of(id);
  if (auto panorama = reader.panorama_of(id)) city.panoramas.push_back(*std::move(panorama));
  for (const auto& d : city.doors)
    if (auto room = reader.interior(d.to_sector_id)) city.interiors.push_back(*std::move(room));
  std::set<std::string> others, houses, facades;
  for (const auto& g : city.gates) others.insert(g.to_sector_id);
  for (const auto& v : city.visible) others.insert(v.visible_sector_id);
  for (const auto& h : city.buildings) houses.insert(h.id);
  for (const auto& b : city.borders)
    if (b.kind == BorderKind::facade && !houses.contains(b.building_id)) facades.insert(b.building_id);
  city.sectors.push_back(*std::move(sector));
  others.erase(id);
  for (const auto& other : others)
    if (auto found = reader.sector(other)) city.sectors.push_back(*std::move(found));
  for (const auto& house : facades)
    if (auto found = reader.building(house)) city.buildings.push_back(*std::move(found));
  return city;
}

}  // namespace vicus
