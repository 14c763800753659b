#include "city_db/rules_edges.hpp"

#include <algorithm>
#include <tuple>

namespace vicus::rules {
namespace {

struct RawEdge {
  PlanPoint lo, hi;
  EdgeUse use;
};

void add_edge(std::vector<RawEdge>& raw, PlanPoint a, PlanPoint b, EdgeUse use) {
  if (a == b) return;
  use.forward = a < b;
  raw.push_back({use.forward ? a : b, use.forward ? b : a, use});
}

void add_polygon(std::vector<RawEdge>& raw, const Polygon& polygon, EdgeUse use) {
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i, ++use.at)
      add_edge(raw, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], use);
  };
  add_ring(polygon.outer);
  for (const auto& hole : polygon.holes) add_ring(hole);
}

void add_line(std::vector<RawEdge>& raw, const std::vector<PlanPoint>& line, EdgeUse use) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i, ++use.at) add_edge(raw, line[i], line[i + 1], use);
}

std::vector<RawEdge> raw_edges(const City& city) {
  std::vector<RawEdge> raw;
  const auto use = [](std::size_t owner, Layer layer) {
    return EdgeUse{static_cast<std::uint32_t>(owner), 0, layer, true};
  };
  for (std::size_t i = 0; i < city.domain.size(); ++i) add_polygon(raw, city.domain[i], use(i, Layer::domain));
  for (std::size_t i = 0; i < city.sectors.size(); ++i) add_polygon(raw, city.sectors[i].ground, use(i, Layer::sector));
  for (std::size_t i = 0; i < city.buildings.size(); ++i)
    if (stands_on_ground(city.buildings[i])) add_polygon(raw, city.buildings[i].footprint, use(i, Layer::building));
  for (std::size_t i = 0; i < city.obstacles.size(); ++i)
    add_polygon(raw, city.obstacles[i].area, use(i, Layer::obstacle));
  for (std::size_t i = 0; i < city.borders.size(); ++i) add_line(raw, city.borders[i].line, use(i, Layer::border));
  for (std::size_t i = 0; i < city.gates.size(); ++i) add_line(raw, city.gates[i].line, use(i, Layer::gate));
  return raw;
}

}  // namespace

EdgeTable edge_table(const City& city) {
  auto raw = raw_edges(city);
  std::sort(raw.begin(), raw.end(), [](const RawEdge& a, const RawEdge& b) {
    return std::tie(a.lo, a.hi, a.use.layer, a.use.owner, a.use.at) <
           std::tie(b.lo, b.hi, b.use.layer, b.use.owner, b.use.at);
  });
  EdgeTable table;
  table.uses.reserve(raw.size());
  for (const auto& r : raw) {
    if (table.edges.empty() || table.edges.back().lo != r.lo || table.edges.back().hi != r.hi)
      table.edges.push_back({r.lo, r.hi, static_cast<std::uint32_t>(table.uses.size())});
    table.uses.push_back(r.use);
  }
  return table;
}

}  // namespace vicus::rules
