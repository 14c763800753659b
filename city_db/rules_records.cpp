#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>
#include <unordered_set>

#include "city_db/rules_parts.hpp"

namespace vicus::rules {
namespace {

PlanPoint place_of(const std::vector<PlanPoint>& points) { return points.empty() ? PlanPoint{} : points.front(); }
PlanPoint place_of(const Sector& s) { return place_of(s.ground.outer); }
PlanPoint place_of(const Gate& g) { return place_of(g.line); }
PlanPoint place_of(const Building& b) { return place_of(b.footprint.outer); }
PlanPoint place_of(const StandaloneObject& o) { return o.at; }
PlanPoint place_of(const Viewpoint& v) { return v.at; }

bool is_url_name(const std::string& id) {
  return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

template <class T>
void check_ids(const std::string& what, const std::vector<T>& records, Findings& findings) {
  std::unordered_set<std::string> seen;
  for (const auto& record : records) {
    if (record.id.empty())
      findings.add(Rule::identity, "", place_of(record), what + " has no id");
    else if (!seen.insert(record.id).second)
      findings.add(Rule::identity, record.id, place_of(record), what + " has the id of another " + what);
  }
}

/// Of records that agree in all that `key` compares, all but one are repetitions.
template <class T, class Key>
void check_repeats(const std::string& what, const std::vector<T>& records, Key key, Findings& findings) {
  std::vector<std::uint32_t> order(records.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(records[a]) < key(records[b]); });
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const T &a = records[order[i]], &b = records[order[i + 1]];
    if (key(a) < key(b)) continue;
    if constexpr (requires { a.line; })
      findings.add(Rule::identity, a.sector_id, place_of(a.line), what + " is there twice");
    else if constexpr (requires { a.id; })
      findings.add(Rule::identity, a.id, place_of(a), what + " is there twice");
    else
      findings.add(Rule::identity, a.sector_id, {}, what + " is there twice");
  }
}

/// A record that names a sector which is not there.
template <class T>
void check_sector_names(const std::string& what, const std::vector<T>& records, const IdIndex& sectors,
                        bool may_be_empty, Findings& findings) {
  for (const auto& record : records)
    if (!(may_be_empty && record.sector_id.empty()) && !sectors.contains(record.sector_id))
      findings.add(Rule::identity, record.id, place_of(record),
                   what + " names the sector \"" + record.sector_id + "\", which does not exist");
}

}  // namespace

void check_budget(const City& city, Findings& findings) {
  std::uint64_t budget = findings.options().default_budget_bytes;
  if (const auto stored = city.meta.find("budget_bytes"); stored != city.meta.end()) {
    char* end = nullptr;
    budget = std::strtoull(stored->second.c_str(), &end, 10);
    if (stored->second.empty() || *end != 0 || stored->second[0] == '-')
      return findings.add(Rule::budget, "", {}, "meta budget_bytes is no number: " + stored->second);
  }
  for (const auto& sector : city.sectors)
    if (sector.bytes > budget)
      findings.add(Rule::budget, sector.id, place_of(sector),
                   std::to_string(sector.bytes) + " bytes, budget " + std::to_string(budget));
  for (const auto& interior : city.interiors)
    if (interior.sector.bytes > budget)
      findings.add(Rule::budget, interior.sector.id, place_of(interior.sector),
                   std::to_string(interior.sector.bytes) + " bytes, budget " + std::to_string(budget));
}

void check_identity(const Subject& subject, Findings& findings) {
  const City& city = subject.city;
  check_ids("sector", city.sectors, findings);
  check_ids("gate", city.gates, findings);
  check_ids("building", city.buildings, findings);
  check_ids("object", city.objects, findings);
  check_ids("viewpoint", city.viewpoints, findings);
  for (const auto& sector : city.sectors)
    if (!sector.id.empty() && !is_url_name(sector.id))
      findings.add(Rule::identity, sector.id, place_of(sector), "the sector's id is not of [A-Za-z0-9_-]");
  check_repeats(
      "sector", city.sectors, [](const Sector& s) { return std::tie(s.ground.outer); }, findings);
  check_repeats(
      "gate", city.gates, [](const Gate& g) { return std::tie(g.sector_id, g.line); }, findings);
  check_repeats(
      "border", city.borders, [](const Border& b) { return std::tie(b.sector_id, b.line); }, findings);
  check_repeats(
      "visible", city.visible, [](const Visible& v) { return std::tie(v.sector_id, v.visible_sector_id); }, findings);
  check_repeats(
      "building", city.buildings,
      [](const Building& b) { return std::tie(b.source_id, b.footprint.outer, b.base_m, b.height_m); }, findings);
  check_sector_names("building", city.buildings, subject.sectors, true, findings);
  check_sector_names("object", city.objects, subject.sectors, true, findings);
  IdIndex with_interiors = subject.sectors;
  for (const auto& interior : city.interiors) with_interiors.emplace(interior.sector.id, kNone);
  check_sector_names("viewpoint", city.viewpoints, with_interiors, false, findings);
}

}  // namespace vicus::rules
