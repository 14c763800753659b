#include <algorithm>

#include "city_db/rules_parts.hpp"

namespace vicus::rules {
namespace {

/// What kind of obstacle may stop a walker at a border of the kind.
bool obstacle_fits(BorderKind border, ObstacleKind obstacle) {
  const bool is_closed_ground = obstacle == ObstacleKind::yard || obstacle == ObstacleKind::courtyard;
  switch (border) {
    case BorderKind::facade:
      return false;
    case BorderKind::wall:
      return obstacle == ObstacleKind::wall;
    case BorderKind::fence:
      return obstacle == ObstacleKind::fence || is_closed_ground;
    case BorderKind::bank:
      return obstacle == ObstacleKind::water;
    case BorderKind::edge:
      return obstacle == ObstacleKind::island || is_closed_ground;
  }
  return false;
}

/// One directed edge of the table: what lies on its left is `near`, on its right `far`.
struct DirectedEdge {
  const Subject& subject;
  std::size_t edge;
  bool forward;

  const Cover& near() const { return forward ? subject.plane.left[edge] : subject.plane.right[edge]; }
  const Cover& far() const { return forward ? subject.plane.right[edge] : subject.plane.left[edge]; }
  PlanPoint from() const { return forward ? subject.table.edges[edge].lo : subject.table.edges[edge].hi; }
  std::span<const EdgeUse> uses() const { return subject.table.uses_of(edge); }
  const std::string& sector_of(const EdgeUse& line) const {
    const auto& city = subject.city;
    return line.layer == Layer::border ? city.borders[line.owner].sector_id : city.gates[line.owner].sector_id;
  }
};

void check_sector_edge(const DirectedEdge& d, const Sector& sector, Findings& findings) {
  int lines = 0;
  for (const auto& use : d.uses()) lines += !use.is_ring() && use.forward == d.forward && d.sector_of(use) == sector.id;
  if (lines == 1) return;
  findings.add(Rule::edges, sector.id, d.from(),
               lines == 0 ? "a ground edge is neither border nor gate"
                          : "a ground edge is " + std::to_string(lines) + " borders or gates at once");
}

bool lies_on_ring(const DirectedEdge& d, const EdgeUse& line) {
  const auto& sectors = d.subject.city.sectors;
  const auto uses = d.uses();
  return std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& use) {
    return use.layer == Layer::sector && use.forward == d.forward && sectors[use.owner].id == d.sector_of(line);
  });
}

void check_border_edge(const DirectedEdge& d, const Border& border, Findings& findings) {
  const auto complain = [&](const std::string& what) { findings.add(Rule::edges, border.sector_id, d.from(), what); };
  const std::string kind = name_of(border.kind);
  if (d.far().is_walkable() || d.far().sectors > 0) return complain("one could walk on beyond a " + kind);
  if (d.far().blocks == 0) return complain("the city ends here, but there is a " + kind + " and no end-of-city gate");
  const auto& city = d.subject.city;
  for (const auto& use : d.uses()) {
    if (use.forward == d.forward) continue;
    if (use.layer == Layer::building && border.kind == BorderKind::facade &&
        city.buildings[use.owner].id == border.building_id)
      return;
    if (use.layer == Layer::obstacle && obstacle_fits(border.kind, city.obstacles[use.owner].kind)) return;
  }
  complain(border.kind == BorderKind::facade ? "building " + border.building_id + " has no such facade"
                                             : "nothing beyond the edge makes it a " + kind);
}

void check_gate_edge(const DirectedEdge& d, const Gate& gate, Findings& findings) {
  const auto complain = [&](const std::string& what) { findings.add(Rule::edges, gate.id, d.from(), what); };
  const auto& city = d.subject.city;
  const auto uses = d.uses();
  if (gate.to_sector_id.empty()) {
    const bool on_rim = std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& use) {
      return use.layer == Layer::domain && use.forward == d.forward;
    });
    if (!on_rim || d.far().domain > 0) return complain("an end-of-city gate inside of the domain");
    if (d.far().blocks > 0) complain("an end-of-city gate in front of a house or an obstacle");
    return;
  }
  const bool arrives = std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& use) {
    return use.layer == Layer::sector && use.forward != d.forward && city.sectors[use.owner].id == gate.to_sector_id;
  });
  if (!arrives) complain("the ground beyond the gate is not of sector " + gate.to_sector_id);
}

/// Rule 3 at one side of an edge.
void check_facade(const DirectedEdge& d, Findings& findings) {
  if (!d.near().is_walkable()) return;
  const auto& city = d.subject.city;
  const auto uses = d.uses();
  const auto house = std::find_if(uses.begin(), uses.end(), [&](const EdgeUse& use) {
    return use.layer == Layer::building && use.forward != d.forward;
  });
  if (house == uses.end()) return;
  const auto facades = std::count_if(uses.begin(), uses.end(), [&](const EdgeUse& use) {
    return use.layer == Layer::border && use.forward == d.forward && city.borders[use.owner].kind == BorderKind::facade;
  });
  if (facades == 1) return;
  findings.add(Rule::facades, city.buildings[house->owner].id, d.from(),
               facades == 0 ? "a facade piece belongs to no sector"
                            : "a facade piece is sent " + std::to_string(facades) + " times");
}

}  // namespace

void check_borders(const Subject& subject, Findings& findings) {
  const auto& city = subject.city;
  for (std::size_t e = 0; e < subject.table.edges.size(); ++e)
    for (const bool forward : {true, false}) {
      const DirectedEdge d{subject, e, forward};
      check_facade(d, findings);
      for (const auto& use : d.uses()) {
        if (use.forward != forward) continue;
        if (use.layer == Layer::sector) check_sector_edge(d, city.sectors[use.owner], findings);
        if (use.is_ring()) continue;
        const std::string& id = use.layer == Layer::gate ? city.gates[use.owner].id : d.sector_of(use);
        if (!lies_on_ring(d, use))
          findings.add(Rule::edges, id, d.from(),
                       "a border or gate lies on no ring edge of sector " + d.sector_of(use));
        else if (use.layer == Layer::border)
          check_border_edge(d, city.borders[use.owner], findings);
        else
          check_gate_edge(d, city.gates[use.owner], findings);
      }
    }
}

}  // namespace vicus::rules
