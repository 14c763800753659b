#include <cstdlib>

#include "city_db/rules_parts.hpp"

namespace vicus::rules {
namespace {

template <class Visit>
void visit_polygons(const City& city, Visit visit) {
  for (const auto& d : city.domain) visit("domain", std::string(), d);
  for (const auto& s : city.sectors) visit("sector", s.id, s.ground);
  for (const auto& b : city.buildings) visit("building", b.id, b.footprint);
  for (const auto& o : city.obstacles) visit("obstacle", o.source_id, o.area);
}

bool is_on_lattice(PlanPoint p) {
  return p.x > -kPlanLimit && p.x < kPlanLimit && p.y > -kPlanLimit && p.y < kPlanLimit;
}

Int128 twice_area(const Ring& ring) {
  Int128 sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  return sum;
}

void check_ring(const std::string& what, const std::string& id, const Ring& ring, bool is_hole, Findings& findings) {
  const PlanPoint at = ring.empty() ? PlanPoint{} : ring.front();
  if (ring.size() < 3) {
    findings.add(Rule::partition, id, at, what + " has a ring of fewer than three points");
    return;
  }
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] == ring[i + 1 < ring.size() ? i + 1 : 0])
      findings.add(Rule::partition, id, ring[i], what + " has a ring edge of no length");
  const Int128 area = twice_area(ring);
  if (is_hole ? area >= 0 : area <= 0)
    findings.add(Rule::partition, id, at,
                 what + (is_hole ? " has a hole that does not turn clockwise"
                                 : " has an outer ring that does not turn counter-clockwise"));
}

}  // namespace

bool check_limits(const City& city, Findings& findings) {
  bool all_on_lattice = true;
  const auto look = [&](const std::string& what, const std::string& id, const std::vector<PlanPoint>& points) {
    for (const auto p : points) {
      if (is_on_lattice(p)) continue;
      all_on_lattice = false;
      for (const Rule rule :
           {Rule::partition, Rule::edges, Rule::facades, Rule::houses_whole, Rule::connected, Rule::identity})
        findings.add(rule, id, p, what + " lies outside of the lattice: the rule cannot be proved");
    }
  };
  visit_polygons(city, [&](const std::string& what, const std::string& id, const Polygon& polygon) {
    look(what, id, polygon.outer);
    for (const auto& hole : polygon.holes) look(what, id, hole);
  });
  for (const auto& b : city.borders) look("border", b.sector_id, b.line);
  for (const auto& g : city.gates) look("gate", g.id, g.line);
  return all_on_lattice;
}

void check_rings(const City& city, Findings& findings) {
  Int128 sectors = 0;
  visit_polygons(city, [&](const std::string& what, const std::string& id, const Polygon& polygon) {
    check_ring(what, id, polygon.outer, false, findings);
    for (const auto& hole : polygon.holes) check_ring(what, id, hole, true, findings);
    if (what != "sector") return;
    sectors += twice_area(polygon.outer);
    for (const auto& hole : polygon.holes) sectors += twice_area(hole);
  });
  findings.report().sectors_mm2 = static_cast<double>(sectors) / 2;
}

}  // namespace vicus::rules
