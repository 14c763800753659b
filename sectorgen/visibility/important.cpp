#include "sectorgen/visibility/important.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/visibility/propose.hpp"

namespace vicus {
namespace {

void keep_previous(City& city, const City& previous, std::vector<Issue>& issues) {
  std::unordered_map<std::string, Sector*> by_id;
  for (auto& s : city.sectors) by_id.emplace(s.id, &s);
  for (const auto& old : previous.sectors) {
    if (old.importance != Importance::author) continue;
    if (const auto at = by_id.find(old.id); at != by_id.end()) {
      at->second->importance = old.importance;
      at->second->vicinity_m = old.vicinity_m;
    } else {
      issues.push_back({IssueCode::unknown_place,
                        "sector " + old.id + (old.name.empty() ? "" : " (" + old.name + ")") +
                            " was marked important in the city that is replaced and is no more; name its successor "
                            "with --important",
                        old.id, old.origin});
    }
  }
}

/// Metres from the point to the nearest point of the box.
double distance_m(PlanPoint p, const PlanBox& box) {
  const auto outside = [](std::int64_t v, std::int64_t low, std::int64_t high) {
    return metres(std::max<std::int64_t>({low - v, v - high, 0}));
  };
  return std::hypot(outside(p.x, box.min.x, box.max.x), outside(p.y, box.min.y, box.max.y));
}

PlanPoint middle_of(const PlanBox& box) {
  const auto middle = [](std::int64_t a, std::int64_t b) { return static_cast<std::int32_t>((a + b) / 2); };
  return {middle(box.min.x, box.max.x), middle(box.min.y, box.max.y)};
}

}  // namespace

void mark_important(City& city, const ImportantOptions& options, std::vector<Issue>& issues) {
  if (options.previous != nullptr) keep_previous(city, *options.previous, issues);
  mark_author_list(city, options.list, options.plan_of, issues);
  propose_important(city);
}

void add_important(City& city) {
  std::unordered_map<std::string, std::unordered_set<std::string>> listed_by;  // important sector -> who lists it
  for (const auto& s : city.sectors)
    if (s.importance == Importance::author) listed_by[s.id].insert(s.id);
  if (listed_by.empty()) return;
  for (const auto& v : city.visible)
    if (const auto at = listed_by.find(v.visible_sector_id); at != listed_by.end()) at->second.insert(v.sector_id);
  std::vector<PlanPoint> middles;
  for (const auto& s : city.sectors) middles.push_back(middle_of(box_of(s.ground)));
  for (const auto& important : city.sectors) {
    if (important.importance != Importance::author) continue;
    const PlanBox box = box_of(important.ground);
    auto& listed = listed_by.at(important.id);
    for (std::size_t i = 0; i < middles.size(); ++i)
      if (distance_m(middles[i], box) <= important.vicinity_m && listed.insert(city.sectors[i].id).second)
        city.visible.push_back({city.sectors[i].id, important.id, VisibleReason::important, true, {}});
  }
}

}  // namespace vicus
