#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "city_db/store.hpp"

/// Finding the records of a city by sector.
namespace vicus {

/// Somewhere on the ground, away from its edge where it can be: the middle of the largest triangle.
/// Needs   a ground with points (assert).
PlanPoint point_inside(const Sector& sector);

/// Where records come from: a City in memory, or a reader of a city file (the server). Lists in id order.
struct RecordSource {
  std::function<std::optional<Sector>(const std::string& id)> sector;  ///< of the streets, or an interior's
  std::function<std::vector<Gate>(const std::string& sector_id)> gates_of;
  std::function<std::vector<Door>(const std::string& sector_id)> doors_of;
  std::function<std::vector<Viewpoint>(const std::string& sector_id)> viewpoints_of;
  std::function<std::vector<StandaloneObject>(const std::string& sector_id)> objects_of;
  std::function<std::vector<Visible>(const std::string& sector_id)> visible_from;
  std::function<std::vector<GateImpostor>(const std::string& sector_id)> impostors_of;
  std::function<std::optional<Panorama>(const std::string& sector_id)> panorama_of;
  std::function<std::vector<Building>(const PlanBox& box)> houses_in;  ///< whose footprint's box meets `box`
  std::function<std::vector<std::string>()> sector_ids;                ///< of the streets
  std::function<std::string(const std::string& key)> meta;             ///< empty where there is none
};

/// Indices into the lists of a City, by sector, each list in id order (borders in the order they are stored).
/// Needs   the City outlives the index and is not changed but in Sector.bytes.
class CityIndex {
 public:
  explicit CityIndex(const City& city);

  const City& city() const { return *city_; }
  const Sector* sector(const std::string& id) const;
  const Building* building(const std::string& id) const;
  const Interior* interior(const std::string& id) const;
  const std::vector<const Gate*>& gates_of(const std::string& sector_id) const;
  const std::vector<const Door*>& doors_of(const std::string& sector_id) const;
  const std::vector<const Border*>& borders_of(const std::string& sector_id) const;
  const std::vector<const Facade*>& facades_of(const std::string& sector_id) const;
  const std::vector<const Building*>& buildings_of(const std::string& sector_id) const;
  const std::vector<const StandaloneObject*>& objects_of(const std::string& sector_id) const;
  const std::vector<const Surface*>& surfaces_of(const std::string& sector_id) const;
  const std::vector<const Ride*>& rides_of(const std::string& sector_id) const;
  const Prototype* prototype(const std::string& kind) const;  ///< an author's model of a kind; nullptr: ours
  const std::vector<const Viewpoint*>& viewpoints_of(const std::string& sector_id) const;
  const std::vector<const Visible*>& visible_from(const std::string& sector_id) const;
  const std::vector<const GateImpostor*>& impostors_of(const std::string& sector_id) const;
  const Panorama* panorama_of(const std::string& sector_id) const;  ///< nullptr: it has none
  /// Ids of the houses of the sector that some other sector sees over roofs.
  const std::set<std::string>& tall_houses_of(const std::string& sector_id) const;

 private:
  template <class T>
  using BySector = std::map<std::string, std::vector<const T*>>;

  const City* city_;
  std::map<std::string, const Sector*> sectors_;
  std::map<std::string, const Interior*> interiors_;
  std::map<std::string, const Building*> buildings_;
  BySector<Gate> gates_of_;
  BySector<Door> doors_of_;
  BySector<Border> borders_of_;
  BySector<Facade> facades_of_;
  BySector<Building> buildings_of_;
  BySector<StandaloneObject> objects_of_;
  BySector<Surface> surfaces_of_;
  BySector<Ride> rides_of_;
  std::map<std::string, const Prototype*> prototypes_;
  BySector<Viewpoint> viewpoints_of_;
  BySector<Visible> visible_from_;
  BySector<GateImpostor> impostors_of_;
  std::map<std::string, const Panorama*> panoramas_;
  std::map<std::string, std::set<std::string>> tall_houses_of_;
};

/// Needs   `index` outlives the source.
RecordSource source_of(const CityIndex& index);

/// The same from a city file, for the server.
/// Needs   `reader` outlives the source.   Fails   CityError as CityReader does.
RecordSource source_of(const CityReader& reader);

/// All that the near files of one sector are made from, as a city of its own: an index over it makes the same files as
/// one over the whole city. nullopt: there is no such sector.
/// Fails   CityError as CityReader does.
std::optional<City> city_around(const CityReader& reader, const std::string& sector_id);

}  // namespace vicus
