#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// The seven rules of DESIGN §3, proved from a city's records alone; nothing here is shared with the generator.
///
/// W is the domain less the houses on the ground (base_m <= 0) less the obstacles, whatever their kind.
/// Frame   plan lattice; all predicates are exact integers.
/// Needs   nothing: every record may be wrong in every way.
/// Fails   never: what is wrong is reported.
/// Cost    O(n log n) in ring edges; about 200 bytes per ring edge.
namespace vicus {

enum class Rule { partition, edges, facades, houses_whole, connected, budget, identity };
inline constexpr std::size_t kRuleCount = 7;
/// As in `check --json`: `houses_whole`.
const char* name_of(Rule);
/// What the rule says, as a sentence for a person.
const char* sentence_of(Rule);

struct RuleViolation {
  Rule rule = Rule::partition;
  std::string id;  ///< of the sector, gate, building, ... concerned; may be empty
  PlanPoint at;
  std::string message;
};

struct RuleOptions {
  std::size_t listed_per_rule = 20;              ///< violations past that are counted, not listed
  std::uint64_t default_budget_bytes = 200'000;  ///< where meta `budget_bytes` is missing
};

struct RuleReport {
  std::array<std::uint64_t, kRuleCount> violation_counts{};
  std::vector<RuleViolation> violations;  ///< in rule order
  /// Are all rings noded with each other? If not, no face is known, and rules 2, 3 and 5 are judged by which rings
  /// run along an edge instead of by what covers the ground beside it.
  bool is_noded = false;
  /// Ground where W and the union of sectors differ, or where sectors overlap. Exact below 2^52; empty if not noded.
  std::optional<double> area_error_mm2;
  std::optional<double> walkable_mm2;  ///< area of W, from the faces
  double sectors_mm2 = 0;              ///< sum of the sectors' ring areas
  std::uint64_t components = 0;        ///< of W, as its sectors touch

  bool holds(Rule rule) const { return violation_counts[static_cast<std::size_t>(rule)] == 0; }
  bool all_hold() const;
};

RuleReport check_rules(const City& city, const RuleOptions& options = {});

}  // namespace vicus
