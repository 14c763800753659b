#include "sectorgen/visibility/visible.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "sectorgen/visibility/line_of_sight.hpp"
#include "sectorgen/visibility/over_roofs.hpp"

namespace vicus {
namespace {

/// What is seen of one visible sector: houses, one after the other in the list, and behind them its ground.
Visible row_over_roofs(const City& city, const std::string& from, const RoofSight* first, const RoofSight* last) {
  Visible row{from, city.sectors[first->sector].id, VisibleReason::over_roofs, false, {}};
  if (const RoofSight& ground = *(last - 1); ground.house == RoofSight::kGround) {
    row.is_proven = ground.is_proven;
    return row;
  }
  for (const RoofSight* sight = first; sight != last; ++sight) {
    row.building_ids.push_back(city.buildings[sight->house].id);
    row.is_proven = row.is_proven || sight->is_proven;
  }
  std::sort(row.building_ids.begin(), row.building_ids.end());
  return row;
}

/// Seen on the level, but not the ground of the sector that sends them: they are listed by name as those over roofs
/// are.
void add_houses_on_the_level(RoofLists& lists, const SightLists& level, const std::vector<std::uint32_t>& owner) {
  for (std::size_t s = 0; s < level.houses.size(); ++s) {
    auto& list = lists.visible[s];
    for (const std::uint32_t house : level.houses[s]) list.push_back({owner[house], house, true});
    std::sort(list.begin(), list.end(), [](const RoofSight& a, const RoofSight& b) {
      return std::tie(a.sector, a.house) < std::tie(b.sector, b.house);
    });
  }
}

void report_over_budget(City& city, const SightLists& lists, std::uint64_t budget) {
  for (const std::uint32_t s : lists.over_budget)
    city.issues.push_back({IssueCode::sight_over_budget,
                           "sector " + city.sectors[s].id + ": its lines of sight were not followed after " +
                               std::to_string(budget) +
                               " steps; whom it sees is known from the others, but for others of this kind",
                           city.sectors[s].id, city.sectors[s].origin});
}

const char* name_of(OverRoofs over_roofs) {
  return over_roofs == OverRoofs::yes ? "yes" : over_roofs == OverRoofs::landmarks ? "landmarks" : "no";
}

}  // namespace

void list_visible(City& city, const VisibleOptions& options) {
  const SightMap map = make_sight_map(city);
  const SightLists level = lines_of_sight(map, {options.threads, options.step_budget});
  report_over_budget(city, level, options.step_budget);
  RoofLists roofs;
  roofs.visible.resize(city.sectors.size());
  const OverRoofs over_roofs = options.over_roofs != OverRoofs::automatic ? options.over_roofs
                               : city.sectors.size() <= kSectorsOverRoofs ? OverRoofs::yes
                                                                          : OverRoofs::no;
  city.meta["over_roofs"] = name_of(over_roofs);
  if (over_roofs != OverRoofs::no) {
    RoofOptions roof_options;
    roof_options.threads = options.threads;
    if (over_roofs == OverRoofs::landmarks) roof_options.least_height_m = kLandmark_m;
    roof_options.least_radius_m = options.least_radius_m;
    roofs = sights_over_roofs(city, level, roof_options);
  }
  add_houses_on_the_level(roofs, level, map.owner);
  std::set<std::pair<std::string, std::string>> gates;
  for (const auto& gate : city.gates)
    if (!gate.to_sector_id.empty()) gates.insert({gate.sector_id, gate.to_sector_id});

  city.visible.clear();
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) {
    const std::string& id = city.sectors[s].id;
    for (const std::uint32_t t : level.visible[s]) {
      const std::string& other = city.sectors[t].id;
      const VisibleReason reason = s == t                        ? VisibleReason::self
                                   : gates.contains({id, other}) ? VisibleReason::gate
                                                                 : VisibleReason::line_of_sight;
      city.visible.push_back({id, other, reason, true, {}});
    }
    const auto& list = roofs.visible[s];
    for (std::size_t i = 0, end = 0; i < list.size(); i = end) {
      for (end = i; end < list.size() && list[end].sector == list[i].sector;) ++end;
      city.visible.push_back(row_over_roofs(city, id, &list[i], &list[0] + end));
    }
  }
  std::sort(city.visible.begin(), city.visible.end(), [](const Visible& a, const Visible& b) {
    return std::tie(a.sector_id, a.visible_sector_id) < std::tie(b.sector_id, b.visible_sector_id);
  });
}

}  // namespace vicus
