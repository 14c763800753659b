#include <algorithm>
#include <unordered_set>

#include "city_db/rules_parts.hpp"

/// L_vis as a list: what every one must hold, whatever is seen.
namespace vicus::rules {
namespace {

PlanPoint place_of(const Sector& s) { return s.ground.outer.empty() ? PlanPoint{} : s.ground.outer.front(); }

/// Rows by their two sectors and reason; only rows whose sectors exist.
class Rows {
 public:
  explicit Rows(const Subject& subject) : subject_(subject) {
    for (const auto& v : subject.city.visible) {
      const auto from = find_index(subject.sectors, v.sector_id), to = find_index(subject.sectors, v.visible_sector_id);
      if (from == kNone || to == kNone) continue;
      pairs_.insert(key_of(from, to));
      if (v.reason == VisibleReason::line_of_sight) sights_.insert(key_of(from, to));
    }
  }
  bool has(const std::string& from, const std::string& to) const { return holds(pairs_, from, to); }
  bool has_sight(const std::string& from, const std::string& to) const { return holds(sights_, from, to); }

 private:
  using Keys = std::unordered_set<std::uint64_t>;
  static std::uint64_t key_of(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }
  bool holds(const Keys& keys, const std::string& from, const std::string& to) const {
    return keys.contains(key_of(find_index(subject_.sectors, from), find_index(subject_.sectors, to)));
  }

  const Subject& subject_;
  Keys pairs_, sights_;
};

/// Empty: nothing is wrong with the row alone.
std::string fault_of(const Visible& v, const Subject& subject) {
  if ((v.reason == VisibleReason::self) != (v.sector_id == v.visible_sector_id))
    return "\"self\" and nothing else is the reason of a sector to see itself";
  if (v.reason == VisibleReason::over_roofs) {
    for (const auto& id : v.building_ids)
      if (find_index(subject.buildings, id) == kNone) return "it names the house \"" + id + "\", which does not exist";
    const auto& ids = v.building_ids;
    if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>{}) != ids.end())
      return "its houses are not sorted, or one is there twice";
    return "";
  }
  if (!v.is_proven) return "only over roofs may something stay unproven";
  return v.building_ids.empty() ? "" : "only over roofs are houses seen by themselves";
}

}  // namespace

void check_visible(const Subject& subject, Findings& findings) {
  const City& city = subject.city;
  const auto place = [&](const std::string& id) {
    const auto i = find_index(subject.sectors, id);
    return i == kNone ? PlanPoint{} : place_of(city.sectors[i]);
  };
  for (const auto& v : city.visible) {
    const auto fault = subject.sectors.contains(v.sector_id) && subject.sectors.contains(v.visible_sector_id)
                           ? fault_of(v, subject)
                           : std::string("one of the two sectors does not exist");
    if (!fault.empty())
      findings.add(Rule::identity, v.sector_id, place(v.sector_id),
                   "its row of L_vis for \"" + v.visible_sector_id + "\": " + fault);
  }
  // Important sectors are listed whether or not anything was computed.
  if (std::all_of(city.visible.begin(), city.visible.end(),
                  [](const Visible& v) { return v.reason == VisibleReason::important; }))
    return;
  const Rows rows(subject);
  for (const auto& s : city.sectors)
    if (!rows.has(s.id, s.id)) findings.add(Rule::identity, s.id, place_of(s), "its L_vis lacks the sector itself");
  std::unordered_set<std::string> told;
  for (const auto& g : city.gates)
    if (subject.sectors.contains(g.sector_id) && subject.sectors.contains(g.to_sector_id) &&
        !rows.has(g.sector_id, g.to_sector_id) && told.insert(g.sector_id + ' ' + g.to_sector_id).second)
      findings.add(Rule::identity, g.sector_id, place(g.sector_id),
                   "its L_vis lacks \"" + g.to_sector_id + "\", which lies behind its gate " + g.id);
  for (const auto& v : city.visible)
    if (v.reason == VisibleReason::line_of_sight && subject.sectors.contains(v.sector_id) &&
        subject.sectors.contains(v.visible_sector_id) && !rows.has_sight(v.visible_sector_id, v.sector_id))
      findings.add(Rule::identity, v.sector_id, place(v.sector_id),
                   "it sees \"" + v.visible_sector_id + "\" along a line that does not lead back");
}

}  // namespace vicus::rules
