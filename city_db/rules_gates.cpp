#include <algorithm>

#include "city_db/rules_parts.hpp"

/// Rule 2 as far as it concerns whole lines and twins; rules_borders.cpp looks at single edges.
namespace vicus::rules {
namespace {

PlanPoint place_of(const std::vector<PlanPoint>& line) { return line.empty() ? PlanPoint{} : line.front(); }

void check_twin(const Subject& subject, const Gate& gate, Findings& findings) {
  const auto complain = [&](const std::string& what) { findings.add(Rule::edges, gate.id, place_of(gate.line), what); };
  const bool leads_out = gate.to_sector_id.empty();
  if (leads_out != (gate.kind == GateKind::end_of_city))
    return complain(leads_out ? "a gate leads nowhere, but is no end-of-city gate"
                              : "an end-of-city gate leads to a sector");
  if (leads_out != gate.twin_id.empty())
    return complain(leads_out ? "a gate out of the city has a twin" : "a gate has no twin");
  if (leads_out) return;
  const auto index = find_index(subject.gates, gate.twin_id);
  if (index == kNone) return complain("the twin " + gate.twin_id + " does not exist");
  const Gate& twin = subject.city.gates[index];
  if (twin.twin_id != gate.id) return complain("the twin " + twin.id + " has another twin");
  if (twin.sector_id != gate.to_sector_id || twin.to_sector_id != gate.sector_id)
    return complain("the twin " + twin.id + " does not join the same two sectors");
  if (twin.kind != gate.kind) complain("the twin " + twin.id + " is of another kind");
  if (!std::equal(gate.line.begin(), gate.line.end(), twin.line.rbegin(), twin.line.rend()))
    complain("the twin " + twin.id + " is another line");
}

/// Start of the ring, in ordinals of the polygon's edges, that holds edge `at`; and the ring's length.
std::pair<std::uint32_t, std::uint32_t> ring_range(const Polygon& polygon, std::uint32_t at) {
  auto start = std::uint32_t{0}, length = static_cast<std::uint32_t>(polygon.outer.size());
  for (std::size_t h = 0; at >= start + length && h < polygon.holes.size(); ++h) {
    start += length;
    length = static_cast<std::uint32_t>(polygon.holes[h].size());
  }
  return {start, length};
}

/// Where on its sector's ring each edge of each line lies, for the lines of one layer.
class LinePlaces {
 public:
  template <class Lines>
  explicit LinePlaces(const Lines& lines) {
    starts_.push_back(0);
    for (const auto& line : lines) starts_.push_back(starts_.back() + line.line.size());
    places_.assign(starts_.back(), kNone);
  }
  std::uint32_t& place(std::size_t line, std::size_t at) { return places_[starts_[line] + at]; }

 private:
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> places_;
};

template <class Line>
void check_run(const Line& line, const Polygon& ground, LinePlaces& places, std::size_t index, const std::string& id,
               Findings& findings) {
  for (std::size_t i = 0; i + 2 < line.line.size(); ++i) {
    const auto here = places.place(index, i), next = places.place(index, i + 1);
    if (here == kNone || next == kNone) continue;  // reported edge by edge
    const auto [start, length] = ring_range(ground, here);
    if (next == (here + 1 < start + length ? here + 1 : start)) continue;
    findings.add(Rule::edges, id, line.line[i + 1], "a border or gate is no run of consecutive ground edges");
    return;
  }
}

}  // namespace

void check_gates(const Subject& subject, Findings& findings) {
  const auto& city = subject.city;
  LinePlaces borders(city.borders), gates(city.gates);
  for (std::size_t e = 0; e < subject.table.edges.size(); ++e) {
    const auto uses = subject.table.uses_of(e);
    for (const auto& line : uses) {
      if (line.is_ring()) continue;
      const bool is_gate = line.layer == Layer::gate;
      const auto& id = is_gate ? city.gates[line.owner].sector_id : city.borders[line.owner].sector_id;
      const auto sector = find_index(subject.sectors, id);
      for (const auto& use : uses)
        if (use.layer == Layer::sector && use.owner == sector && use.forward == line.forward)
          (is_gate ? gates : borders).place(line.owner, line.at) = use.at;
    }
  }
  const auto check_line = [&](const auto& line, LinePlaces& places, std::size_t index, const std::string& id) {
    const auto sector = find_index(subject.sectors, line.sector_id);
    if (sector == kNone)
      findings.add(Rule::edges, id, place_of(line.line), "its sector " + line.sector_id + " does not exist");
    else if (line.line.size() < 2)
      findings.add(Rule::edges, id, place_of(line.line), "a border or gate has fewer than two points");
    else
      check_run(line, city.sectors[sector].ground, places, index, id, findings);
  };
  for (std::size_t i = 0; i < city.borders.size(); ++i)
    check_line(city.borders[i], borders, i, city.borders[i].sector_id);
  for (std::size_t i = 0; i < city.gates.size(); ++i) {
    check_line(city.gates[i], gates, i, city.gates[i].id);
    check_twin(subject, city.gates[i], findings);
  }
}

}  // namespace vicus::rules
