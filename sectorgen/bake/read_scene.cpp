#include "sectorgen/bake/read_scene.hpp"

#include <limits>
#include <set>

#include "city_db/boxes.hpp"

namespace vicus {
namespace {

constexpr std::int32_t kAround_mm = 64'000;          // houses that darken the tile's ground
constexpr std::int32_t kSectorsAround_mm = 600'000;  // whose borders and surfaces may reach the tile

}  // namespace

BakeScene read_scene(const CityReader& reader, const PlanBox& box) {
  constexpr auto kAll = std::numeric_limits<std::size_t>::max();
  City city;
  city.buildings = reader.buildings_in(grown(box, kAround_mm), kAll, 0);
  std::set<std::string> houses;
  for (const Building& house : city.buildings) houses.insert(house.id);
  for (const std::string& id : reader.sectors_in(grown(box, kSectorsAround_mm), kAll, 0)) {
    for (Facade& f : reader.facades_of(id))
      if (houses.contains(f.building_id)) city.facades.push_back(std::move(f));
    for (Surface& s : reader.surfaces_of(id)) city.surfaces.push_back(std::move(s));
    for (StandaloneObject& o : reader.objects_of(id)) city.objects.push_back(std::move(o));
  }
  city.terrain = reader.terrain();
  return BakeScene(
      city,
      [&](const std::string& id) {
        const auto artefact = reader.artefact("textures/" + id + ".png", {"identity"});
        return artefact ? artefact->body : std::string();
      },
      1);
}

}  // namespace vicus
