#include "sectorgen/models/facade_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "city_db/house_parts.hpp"
#include "city_db/steady_hash.hpp"

namespace vicus {
namespace {

using Words = std::set<std::string>;

constexpr int kPatternBays = 8;  // longer facades repeat their pattern: one image serves more of them
constexpr double kLeastLength_m = 3, kLeastShedLength_m = 2.2, kLeastHeight_m = 2.3;
constexpr double kStoreyLeast_m = 2.2, kStoreyMost_m = 6;
constexpr double kStoneFrom_m = 13;  // of eaves: four storeys and more were built of stone, or to look so

std::string tag(const Building& house, const char* key) {
  const auto at = house.tags.find(key);
  return at == house.tags.end() ? std::string() : at->second;
}

bool is_church(const Building& house) {
  static const Words kTypes{"church", "cathedral", "chapel", "basilica", "monastery", "temple", "synagogue", "mosque"};
  return kTypes.contains(tag(house, "building")) || tag(house, "amenity") == "place_of_worship";
}

bool is_shed(const Building& house) {
  static const Words kTypes{"garage",     "garages",        "shed", "hut",     "carport", "barn",
                            "greenhouse", "farm_auxiliary", "roof", "service", "toilets"};
  return kTypes.contains(tag(house, "building"));
}

bool is_modern(const Building& house) {
  static const Words kTypes{"office",      "commercial",    "industrial", "warehouse",  "retail",
                            "supermarket", "parking",       "hospital",   "university", "school",
                            "hangar",      "train_station", "hotel",      "sports_hall"};
  static const Words kMaterials{"concrete", "glass", "metal", "steel"};
  return kTypes.contains(tag(house, "building")) || kMaterials.contains(tag(house, "building:material"));
}

}  // namespace

FacadeStyle style_of(const Building& house, const RegionStyle& region) {
  const std::string material = tag(house, "building:material");
  if (is_church(house)) return FacadeStyle::church;
  if (is_shed(house)) return FacadeStyle::shed;
  if (material == "brick" || material == "bricks") return FacadeStyle::brick;
  if (material == "stone" || material == "sandstone" || material == "limestone") return FacadeStyle::stone;
  if (is_modern(house)) return FacadeStyle::modern;
  const auto choice = steady_hash("style " + house_of(house)) % 10;
  const bool is_high = house.eave_m - house.base_m >= kStoneFrom_m;
  if (is_high && choice < region.stone_of_ten_high) return FacadeStyle::stone;
  const unsigned bricks = is_high ? region.brick_of_ten_high : region.brick_of_ten_low;
  return choice >= 10 - bricks ? FacadeStyle::brick : FacadeStyle::plaster;
}

int floors_of(const Building& house, FacadeStyle style, double height_m) {
  if (style == FacadeStyle::church || style == FacadeStyle::shed) return 1;
  const StyleFigures& f = figures_of(style);
  const double levels = std::strtod(tag(house, "building:levels").c_str(), nullptr);
  if (levels >= 1 && levels <= kMostFloors) {
    const int floors = static_cast<int>(std::lround(levels));
    const double storey = height_m / floors;
    if (storey >= kStoreyLeast_m && storey <= kStoreyMost_m) return floors;
  }
  return std::clamp(1 + static_cast<int>(std::lround((height_m - f.cornice - f.ground_floor) / f.storey)), 1,
                    kMostFloors);
}

bool lay_out_bays(Facade& facade) {
  const bool is_small = facade.style == FacadeStyle::shed;
  const double length = length_m(facade), height = facade.top_m - facade.bottom_m;
  if (length < (is_small ? kLeastShedLength_m : kLeastLength_m) || height < kLeastHeight_m * (is_small ? 0.8 : 1))
    return false;
  const double bays = std::max(1.0, std::round(length / figures_of(facade.style).bay));
  facade.repeats = std::min(kMostRepeats, static_cast<int>(std::ceil(bays / kPatternBays)));
  facade.bays = std::clamp(static_cast<int>(std::lround(bays / facade.repeats)), 1, kPatternBays);
  return true;
}

}  // namespace vicus
