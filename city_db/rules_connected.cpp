#include <algorithm>
#include <map>

#include "city_db/rules_parts.hpp"
#include "city_db/rules_sets.hpp"

namespace vicus::rules {
namespace {

/// Sectors on both sides of one edge touch there on foot: a ring edge has a length.
DisjointSets join_by_ground(const Subject& subject) {
  DisjointSets sets(subject.city.sectors.size());
  for (std::size_t e = 0; e < subject.table.edges.size(); ++e) {
    const auto uses = subject.table.uses_of(e);
    for (const auto& a : uses)
      for (const auto& b : uses)
        if (a.layer == Layer::sector && b.layer == Layer::sector && a.forward && !b.forward)
          sets.unite(a.owner, b.owner);
  }
  return sets;
}

DisjointSets join_by_gates(const Subject& subject) {
  DisjointSets sets(subject.city.sectors.size());
  for (const auto& gate : subject.city.gates) {
    const auto from = find_index(subject.sectors, gate.sector_id), to = find_index(subject.sectors, gate.to_sector_id);
    if (from != kNone && to != kNone) sets.unite(from, to);
  }
  return sets;
}

/// A ring that runs to and fro along the same edge.
void check_slits(const Subject& subject, Findings& findings) {
  for (std::size_t e = 0; e < subject.table.edges.size(); ++e) {
    const auto uses = subject.table.uses_of(e);
    for (const auto& a : uses)
      for (const auto& b : uses)
        if (a.layer == Layer::sector && b.layer == Layer::sector && a.owner == b.owner && a.forward && !b.forward)
          findings.add(Rule::connected, subject.city.sectors[a.owner].id, subject.table.edges[e].lo,
                       "the sector's ring runs to and fro along one edge");
  }
}

}  // namespace

void check_connected(const Subject& subject, Findings& findings) {
  const auto& sectors = subject.city.sectors;
  check_slits(subject, findings);
  auto on_foot = join_by_ground(subject), by_gates = join_by_gates(subject);
  // Two partitions are equal when each set's members agree with the set's smallest member.
  for (std::uint32_t i = 0; i < sectors.size(); ++i) {
    const auto& ring = sectors[i].ground.outer;
    const PlanPoint at = ring.empty() ? PlanPoint{} : ring.front();
    const auto foot = on_foot.find(i), gates = by_gates.find(i);
    if (foot == i) ++findings.report().components;
    if (by_gates.find(foot) != gates)
      findings.add(Rule::connected, sectors[i].id, at,
                   "one can walk to sector " + sectors[foot].id + ", but no gates lead there");
    if (on_foot.find(gates) != foot)
      findings.add(Rule::connected, sectors[i].id, at,
                   "gates lead to sector " + sectors[gates].id + ", but one cannot walk there");
  }
}

}  // namespace vicus::rules
