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
constexpr double kSameTop_m = 0.3;
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
    add_step_walls();
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
      const auto pieces = wall_stretches(border.line[runs[i]], border.line[runs[i + 1]], doors_in_[border.sector_id]);
      if (!gables.empty() && pieces.size() == 1 && !pieces.front().door) {
        add_gabled_run(border, house, runs[i], runs[i + 1], gables);
        continue;
      }
      for (const WallStretch& piece : pieces)
        if (!piece.door) add_stretch(border.sector_id, house, piece.a, piece.b, 0, top_of(house));
    }
  }

  /// A straight run of a border, as far as the walls over it reach up alike, each time.
  void add_gabled_run(const Border& border, const Building& house, std::size_t begin, std::size_t end,
                      const std::map<std::pair<PlanPoint, PlanPoint>, double>& gables) {
    const auto top_over = [&](std::size_t k) {
      const auto gable = gables.find({border.line[k + 1], border.line[k]});
      return gable == gables.end() ? top_of(house) : gable->second;
    };
    for (std::size_t k = begin; k < end;) {
      double top_m = top_over(k);
      std::size_t next = k + 1;
      for (; next < end && std::abs(top_over(next) - top_over(k)) < kSameTop_m; ++next)
        top_m = std::min(top_m, top_over(next));
      add_stretch(border.sector_id, house, border.line[k], border.line[next], 0, top_m);
      k = next;
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

  /// Of houses with windows of their own: walls between low and high parts of their roofs, joined where they go on with
  /// the same top.
  void add_step_walls() {
    for (const Building& house : city_.buildings) {
      if (!modelled_.contains(house.id) || house.base_m > 0) continue;
      FullWalls walls;
      std::map<std::int32_t, std::vector<std::pair<PlanPoint, PlanPoint>>> edges;  // by top
      for (const RoofFacet& facet : house.roof.facets)
        if (const auto step = step_of(house, facet); step)
          if (const auto [low_m, high_m] = full_wall(*step); high_m - low_m > kLeastOwn_m) {
            walls.emplace(std::pair(step->a, step->b), std::pair(low_m, high_m));
            edges[lattice_mm(high_m)].emplace_back(step->a, step->b);
          }
      for (const auto& [top_mm, list] : edges)
        for (const auto& line : joined_lines(list)) {
          const auto runs = straight_runs(line);
          for (std::size_t i = 0; i + 1 < runs.size(); ++i)
            add_step_run(house,
                         {line.begin() + static_cast<std::ptrdiff_t>(runs[i]),
                          line.begin() + static_cast<std::ptrdiff_t>(runs[i + 1]) + 1},
                         metres(top_mm), walls);
        }
    }
  }

  using FullWalls = std::map<std::pair<PlanPoint, PlanPoint>, std::pair<double, double>>;

  /// One facade over pieces of a wall in a row, down to the highest foot of them; each by itself where that leaves less
  /// than half of the highest piece.
  void add_step_run(const Building& house, const std::vector<PlanPoint>& line, double top_m, const FullWalls& walls) {
    double highest_m = 0, lowest_m = HUGE_VAL;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const double foot_m = walls.at({line[k], line[k + 1]}).first;
      highest_m = std::max(highest_m, foot_m);
      lowest_m = std::min(lowest_m, foot_m);
    }
    if (line.size() > 2 && top_m - highest_m < (top_m - lowest_m) / 2) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) add_step_run(house, {line[k], line[k + 1]}, top_m, walls);
    } else if (highest_m > 0) {
      add_stretch(house.sector_id, house, line.back(), line.front(), highest_m, top_m);
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
