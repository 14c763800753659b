#pragma once
#include <string>
#include <unordered_map>

#include "city_db/rules.hpp"
#include "city_db/rules_edges.hpp"
#include "city_db/rules_plane.hpp"

/// The parts of check_rules, one per rule or pair of rules. Each adds what it finds to the findings.
namespace vicus::rules {

/// Counts every violation, keeps the first few of each rule.
class Findings {
 public:
  Findings(RuleReport& report, const RuleOptions& options) : report_(report), options_(options) {}
  void add(Rule rule, const std::string& id, PlanPoint at, const std::string& message);
  RuleReport& report() { return report_; }
  const RuleOptions& options() const { return options_; }

 private:
  RuleReport& report_;
  const RuleOptions& options_;
};

/// Index of the first record with an id.
using IdIndex = std::unordered_map<std::string, std::uint32_t>;
inline constexpr std::uint32_t kNone = 0xffffffffu;
std::uint32_t find_index(const IdIndex& index, const std::string& id);

/// What every part looks at.
struct Subject {
  const City& city;
  EdgeTable table;
  Plane plane;
  IdIndex sectors, gates, buildings;
};

/// False: some coordinate is outside of the lattice, and nothing exact can be said (rules_rings.cpp).
bool check_limits(const City& city, Findings& findings);
/// Rings: points, turning sense, edges of no length (rules_rings.cpp).
void check_rings(const City& city, Findings& findings);
/// Rule 1 (rules_partition.cpp).
void report_noding(const Subject& subject, const std::vector<NodingFault>& faults, Findings& findings);
void check_partition(const Subject& subject, Findings& findings);
/// Rules 2 and 3 (rules_borders.cpp, rules_gates.cpp).
void check_borders(const Subject& subject, Findings& findings);
void check_gates(const Subject& subject, Findings& findings);
/// Rule 4 (rules_houses.cpp).
void check_houses_whole(const City& city, Findings& findings);
/// Rule 5 (rules_connected.cpp).
void check_connected(const Subject& subject, Findings& findings);
/// Rules 6 and 7 (rules_records.cpp).
void check_budget(const City& city, Findings& findings);
void check_identity(const Subject& subject, Findings& findings);
/// Rule 7 for L_vis: every list has its own sector and those behind its gates, a line of sight leads both ways, a row
/// names what exists. Cities without L_vis hold (rules_visible.cpp).
void check_visible(const Subject& subject, Findings& findings);

/// Rules 2, 4, 5 and 7 for interiors: each inside its house and clear of the others, its doors edges of its ground and
/// of a facade, each with a twin, a chain of them leading to a street (rules_interiors.cpp).
void check_interiors(const Subject& subject, Findings& findings);

}  // namespace vicus::rules
