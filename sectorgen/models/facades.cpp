#include "sectorgen/models/facades.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

#include "city_db/facade_layout.hpp"
#include "city_db/gables.hpp"
#include "city_db/house_parts.hpp"
#include "city_db/polygon_edges.hpp"
#include "city_db/segment.hpp"
#include "city_db/wall_stretches.hpp"
#include "sectorgen/models/facade_choice.hpp"
#include "sectorgen/models/own_openings.hpp"
#include "sectorgen/models/tag_colours.hpp"
#include "sectorgen/models/wall_lines.hpp"

namespace vicus {
namespace {

constexpr double kDoorReach_m = 1.0, kShopReach_m = 12.0;
constexpr double kLeastOwn_m = 0.4;  // of a wall that may have a window of its house's model
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

bool is_shop(const StandaloneObject& object) {
  static const std::set<std::string> kKinds{"shop", "cafe", "restaurant", "bar", "pub", "bank", "pharmacy"};
  return kKinds.contains(object.kind);
}

struct Foot {
  double distance_m = 0, along_m = 0;  // from the facade's left end
};

Foot foot_on(const Facade& f, PlanPoint p) {
  const double ux = metres(f.a.x - f.b.x), uy = metres(f.a.y - f.b.y), px = metres(p.x - f.b.x),
               py = metres(p.y - f.b.y), length = std::hypot(ux, uy);
  const double t = std::clamp((px * ux + py * uy) / (length * length), 0.0, 1.0);
  return {std::hypot(px - t * ux, py - t * uy), t * length};
}

double top_of(const Building& house) { return house.eave_m > house.base_m ? house.eave_m : house.height_m; }

class FacadeLayout {
 public:
  FacadeLayout(City& city, const std::map<std::string, HouseModel>& models) : city_(city) {
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
      building_.emplace(city.buildings[i].id, i);
      const auto model = models.find(city.buildings[i].source_id);
      if (model != models.end() && !model->second.openings.empty())
        modelled_.emplace(city.buildings[i].id, &model->second);
    }
    for (const Door& door : city.doors) doors_in_[door.sector_id].push_back(&door);
  }

  void run() {
    for (const Border& border : city_.borders) {
      if (border.kind != BorderKind::facade || border.line.size() < 2) continue;
      const auto at = building_.find(border.building_id);
      if (at == building_.end() || city_.buildings[at->second].base_m > 0) continue;
      add_border(border, city_.buildings[at->second]);
    }
    add_upper_walls();
    hang_own_openings();
    for (std::size_t i = 0; i < city_.facades.size(); ++i) {
      if (city_.facades[i].bottom_m > 0) continue;
      in_sector_[city_.facades[i].sector_id].push_back(i);
      of_house_[city_.facades[i].building_id].push_back(i);
    }
    place_shops_and_doors();
    add_missing_doors();
  }

 private:
  void add_border(const Border& border, const Building& house) {
    const auto runs = straight_runs(border.line);
    const auto gables = modelled_.contains(house.id) && border.sector_id == house.sector_id
                            ? full_walls(house)
                            : std::map<std::pair<PlanPoint, PlanPoint>, double>();
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
      double top_m = gables.empty() ? top_of(house) : HUGE_VAL;
      for (std::size_t k = runs[i]; k < runs[i + 1] && !gables.empty(); ++k) {
        const auto gable = gables.find({border.line[k + 1], border.line[k]});
        top_m = std::min(top_m, gable == gables.end() ? top_of(house) : gable->second);
      }
      for (const WallStretch& piece :
           wall_stretches(border.line[runs[i]], border.line[runs[i + 1]], doors_in_[border.sector_id]))
        if (!piece.door) add_stretch(border.sector_id, house, piece.a, piece.b, 0, top_m);
    }
  }

  void add_stretch(const std::string& sector_id, const Building& house, PlanPoint a, PlanPoint b, double bottom_m,
                   double top_m) {
    Facade f;
    f.sector_id = sector_id;
    f.building_id = house.id;
    f.a = a;
    f.b = b;
    if (f.a == f.b) return;
    f.bottom_m = bottom_m;
    f.top_m = top_m;
    f.style = style_of(house, region_style(city_.origin));
    if (modelled_.contains(house.id)) {
      if (length_m(f) > kLeastOwn_m && f.top_m - f.bottom_m > kLeastOwn_m) city_.facades.push_back(std::move(f));
      return;
    }
    if (!lay_out_bays(f)) return;
    f.floors = floors_of(house, f.style, f.top_m - f.bottom_m);
    city_.facades.push_back(std::move(f));
  }

  /// Walls of a house's part above lower parts of the same house.
  void add_upper_walls() {
    std::map<std::pair<PlanPoint, PlanPoint>, const std::string*> house_at;  // by edge
    for (const Building& part : city_.buildings) {
      const auto house = part.tags.find(kPartOf);
      if (house == part.tags.end() || part.base_m > 0) continue;
      visit_edges(part.footprint, [&](PlanPoint a, PlanPoint b) { house_at.emplace(std::pair(a, b), &house->second); });
    }
    for (const Building& part : city_.buildings) {
      const auto house = part.tags.find(kPartOf);
      if (house == part.tags.end() || part.base_m > 0) continue;
      // What noding cut into pieces is one wall again where it stands on one roof.
      std::map<std::int32_t, std::vector<std::pair<PlanPoint, PlanPoint>>> walls;  // by bottom
      for (const SideWall& wall : part.side_walls)
        if (const auto below = house_at.find({wall.b, wall.a});
            below != house_at.end() && *below->second == house->second)
          walls[lattice_mm(wall.bottom_m)].emplace_back(wall.b, wall.a);
      for (const auto& [bottom_mm, edges] : walls)
        for (const auto& line : joined_lines(edges)) {
          const auto runs = straight_runs(line);
          for (std::size_t i = 0; i + 1 < runs.size(); ++i)
            add_stretch(part.sector_id, part, line[runs[i]], line[runs[i + 1]], metres(bottom_mm), top_of(part));
        }
    }
  }

  /// Those of its model, where a house has any: its other walls are blind.
  void hang_own_openings() {
    if (modelled_.empty()) return;
    std::map<std::string, std::vector<Facade*>> of_house;
    for (Facade& f : city_.facades)
      if (modelled_.contains(f.building_id)) of_house[f.building_id].push_back(&f);
    for (const auto& [house, facades] : of_house) hang_openings(*modelled_.at(house), facades);
    std::erase_if(city_.facades,
                  [&](const Facade& f) { return f.openings.empty() && modelled_.contains(f.building_id); });
  }

  std::size_t nearest(const std::string& sector_id, PlanPoint p, double reach_m) const {
    std::size_t best = kNone;
    const auto at = in_sector_.find(sector_id);
    if (at == in_sector_.end()) return kNone;
    for (const std::size_t i : at->second)
      if (const double d = foot_on(city_.facades[i], p).distance_m; d < reach_m && city_.facades[i].openings.empty()) {
        reach_m = d;
        best = i;
      }
    return best;
  }

  /// Is it the place of a door that opens? That one is not painted.
  bool leads_in(const StandaloneObject& object) const {
    const auto at = doors_in_.find(object.sector_id);
    return at != doors_in_.end() && std::any_of(at->second.begin(), at->second.end(), [&](const Door* door) {
             return distance_to_segment_mm(object.at, door->a, door->b) < kDoorReach_m * kMmPerMetre;
           });
  }

  void place_shops_and_doors() {
    for (const StandaloneObject& object : city_.objects) {
      if (object.kind == "door") {
        if (leads_in(object)) continue;
        if (const std::size_t i = nearest(object.sector_id, object.at, kDoorReach_m); i != kNone) {
          Facade& f = city_.facades[i];
          const int bay = static_cast<int>(foot_on(f, object.at).along_m / length_m(f) * f.bays * f.repeats);
          f.door_bay = std::clamp(bay, 0, f.bays * f.repeats - 1) % f.bays;
        }
      } else if (is_shop(object)) {
        if (const std::size_t i = nearest(object.sector_id, object.at, kShopReach_m); i != kNone) {
          Facade& f = city_.facades[i];
          f.has_shop = f.style != FacadeStyle::church && f.style != FacadeStyle::shed;
        }
      }
    }
  }

  /// A house that shows no door has one in its longest facade, on a street before a yard.
  void add_missing_doors() {
    std::map<std::string, bool> is_yard;
    for (const auto& s : city_.sectors) is_yard[s.id] = s.kind == SectorKind::yard;
    std::set<std::string> open_houses;
    for (const Door& door : city_.doors) open_houses.insert(door.building_id);
    for (const auto& [house, list] : of_house_) {
      if (open_houses.contains(house) || modelled_.contains(house)) continue;
      if (std::any_of(list.begin(), list.end(), [&](std::size_t i) { return city_.facades[i].door_bay >= 0; }))
        continue;
      const auto rank = [&](std::size_t i) {
        const Facade& f = city_.facades[i];
        return std::pair(!is_yard[f.sector_id], length_m(f));
      };
      Facade& f = city_.facades[*std::max_element(list.begin(), list.end(),
                                                  [&](std::size_t i, std::size_t k) { return rank(i) < rank(k); })];
      f.door_bay = f.bays / 2;
    }
  }

  City& city_;
  std::unordered_map<std::string, std::size_t> building_;
  std::unordered_map<std::string, const HouseModel*> modelled_;  // with openings of its own
  std::unordered_map<std::string, std::vector<std::size_t>> in_sector_;
  std::map<std::string, std::vector<std::size_t>> of_house_;
  std::map<std::string, std::vector<const Door*>> doors_in_;  // by sector
};

}  // namespace

void lay_out_facades(City& city, const std::map<std::string, HouseModel>& models) {
  city.facades.clear();
  const RegionStyle& region = region_style(city.origin);
  for (auto& house : city.buildings) {
    house.wall_colour = facade_colour(house, style_of(house, region), region);
    house.roof_colour = roof_colour(house, region);
  }
  FacadeLayout(city, models).run();
}

}  // namespace vicus
