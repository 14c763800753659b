#pragma once
#include <string>
#include <unordered_map>
#include <vector>

#include "city_db/city.hpp"

namespace vicus {

/// Where gates stand: sectors and surfaces of a city by the sector's id.   Needs   `city` outlives it.
class CityGround {
 public:
  explicit CityGround(const City& city) : terrain_(city.terrain) {
    for (const Sector& sector : city.sectors) sectors_.emplace(sector.id, &sector);
    for (const Surface& surface : city.surfaces) surfaces_[surface.sector_id].push_back(&surface);
  }

  const Sector* sector(const std::string& id) const {  ///< nullptr: there is none
    const auto at = sectors_.find(id);
    return at == sectors_.end() ? nullptr : at->second;
  }
  const std::vector<const Surface*>& surfaces_of(const std::string& sector_id) const {
    static const std::vector<const Surface*> kNone;
    const auto at = surfaces_.find(sector_id);
    return at == surfaces_.end() ? kNone : at->second;
  }
  const Terrain& terrain() const { return terrain_; }

 private:
  const Terrain& terrain_;
  std::unordered_map<std::string, const Sector*> sectors_;
  std::unordered_map<std::string, std::vector<const Surface*>> surfaces_;
};

}  // namespace vicus
