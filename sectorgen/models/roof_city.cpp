#include "sectorgen/models/roof_city.hpp"

#include <algorithm>
#include <tuple>

#include "sectorgen/models/roof_flat.hpp"

namespace vicus {
namespace {

constexpr double kLeastWall_m = 0.05;  // lower steps between neighbours are not modelled

using PlanEdge = std::pair<PlanPoint, PlanPoint>;

template <class Visit>
void visit_edges(const Polygon& polygon, Visit visit) {
  const auto ring = [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) visit(PlanEdge{r[i], r[(i + 1) % r.size()]});
  };
  ring(polygon.outer);
  for (const auto& hole : polygon.holes) ring(hole);
}

std::vector<PlanEdge> facade_edges(const City& city) {
  std::vector<PlanEdge> edges;
  for (const auto& border : city.borders)
    if (border.kind == BorderKind::facade)
      for (std::size_t k = 0; k + 1 < border.line.size(); ++k) edges.push_back({border.line[k + 1], border.line[k]});
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

void update_side_walls(City& city) {
  const auto facades = facade_edges(city);
  std::vector<std::pair<PlanEdge, double>> eaves;  // of houses on the ground, by edge
  for (const auto& b : city.buildings)
    if (b.base_m <= 0) visit_edges(b.footprint, [&](PlanEdge e) { eaves.emplace_back(e, b.eave_m); });
  std::sort(eaves.begin(), eaves.end());
  for (auto& b : city.buildings) {
    if (b.base_m > 0) continue;  // the exporter draws all walls of what hangs in the air
    std::vector<SideWall> walls;
    visit_edges(b.footprint, [&](PlanEdge e) {
      if (std::binary_search(facades.begin(), facades.end(), e)) return;
      const PlanEdge twin{e.second, e.first};
      double bottom = -1;
      for (auto it = std::lower_bound(eaves.begin(), eaves.end(), std::pair(twin, -1.0));
           it != eaves.end() && it->first == twin; ++it)
        bottom = std::max(bottom, it->second);
      if (bottom < 0)
        for (const auto& wall : b.side_walls)
          if (wall.a == e.first && wall.b == e.second && wall.bottom_m == 0) bottom = 0;
      if (bottom >= 0 && bottom + kLeastWall_m < b.eave_m) walls.push_back({e.first, e.second, bottom});
    });
    b.side_walls = std::move(walls);
  }
}

void roof_houses(City& city) {
  for (auto& b : city.buildings) {
    b.roof = flat_roof(b.footprint, b.eave_m);
  }
  update_side_walls(city);
}

}  // namespace vicus
