#include "city_db/rules.hpp"

#include <algorithm>

#include "city_db/rules_parts.hpp"

namespace vicus {
namespace {

struct RuleText {
  const char *name, *sentence;
};
constexpr std::array<RuleText, kRuleCount> kTexts = {{
    {"partition", "sector grounds have disjoint interiors and together are the walkable ground, to the last mm2"},
    {"edges",
     "every ground edge is one border or one gate; every gate has one twin or leads out of the city, "
     "every door a twin"},
    {"facades", "every facade piece that faces walkable ground belongs to exactly one sector"},
    {"houses_whole", "no gate crosses a footprint; every interior lies inside its house"},
    {"connected", "two places are joined by gates exactly when they are joined on foot"},
    {"budget", "no sector is sent with more bytes than the budget"},
    {"identity", "ids are present and unique, no record is there twice, and lists of visible sectors are whole"},
}};

template <class T>
rules::IdIndex index_ids(const std::vector<T>& records) {
  rules::IdIndex index;
  index.reserve(records.size());
  for (std::uint32_t i = 0; i < records.size(); ++i) index.emplace(records[i].id, i);
  return index;
}

}  // namespace

const char* name_of(Rule rule) { return kTexts[static_cast<std::size_t>(rule)].name; }
const char* sentence_of(Rule rule) { return kTexts[static_cast<std::size_t>(rule)].sentence; }

bool RuleReport::all_hold() const {
  return std::all_of(violation_counts.begin(), violation_counts.end(), [](auto n) { return n == 0; });
}

RuleReport check_rules(const City& city, const RuleOptions& options) {
  RuleReport report;
  rules::Findings findings(report, options);
  rules::check_budget(city, findings);
  if (!rules::check_limits(city, findings)) return report;
  rules::check_rings(city, findings);
  rules::Subject subject{
      city, rules::edge_table(city), {}, index_ids(city.sectors), index_ids(city.gates), index_ids(city.buildings)};
  const auto faults = rules::noding_faults(subject.table);
  report.is_noded = faults.empty();
  if (faults.empty()) {
    subject.plane = rules::plane_of_faces(subject.table);
    rules::check_partition(subject, findings);
  } else {
    subject.plane = rules::plane_of_rings(subject.table);
    rules::report_noding(subject, faults, findings);
  }
  rules::check_borders(subject, findings);
  rules::check_gates(subject, findings);
  rules::check_houses_whole(city, findings);
  rules::check_connected(subject, findings);
  rules::check_interiors(subject, findings);
  rules::check_identity(subject, findings);
  rules::check_visible(subject, findings);
  std::stable_sort(report.violations.begin(), report.violations.end(),
                   [](const auto& a, const auto& b) { return a.rule < b.rule; });
  return report;
}

namespace rules {

void Findings::add(Rule rule, const std::string& id, PlanPoint at, const std::string& message) {
  if (report_.violation_counts[static_cast<std::size_t>(rule)]++ < options_.listed_per_rule)
    report_.violations.push_back({rule, id, at, message});
}

std::uint32_t find_index(const IdIndex& index, const std::string& id) {
  const auto found = index.find(id);
  return found == index.end() ? kNone : found->second;
}

}  // namespace rules
}  // namespace vicus
