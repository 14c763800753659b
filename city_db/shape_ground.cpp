#include "city_db/shape_ground.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/rules_edges.hpp"

namespace vicus {
namespace {

constexpr std::int64_t kCellMm = 16'000;  ///< about a street's width

double distance_to_segment(PlanPlace p, PlanPoint a, PlanPoint b) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, px = p.x - a.x, py = p.y - a.y;
  const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(px - t * dx, py - t * dy);
}

}  // namespace

GroundMap::GroundMap(const City& city) : cells_(kCellMm) {
  using rules::Layer;
  const auto table = rules::edge_table(city);
  for (std::size_t e = 0; e < table.edges.size(); ++e) {
    GroundEdge edge{table.edges[e].lo, table.edges[e].hi};
    bool leads_out = false;
    for (const auto& use : table.uses_of(e)) {
      if (use.layer == Layer::sector) (use.forward ? edge.left : edge.right) = use.owner;
      if (use.layer == Layer::gate && city.gates[use.owner].kind == GateKind::end_of_city) leads_out = true;
    }
    if (edge.left == kNoSector && edge.right == kNoSector) continue;
    edge.stops = !leads_out && (edge.left == kNoSector || edge.right == kNoSector);
    cells_.add_segment(static_cast<std::uint32_t>(edges_.size()), edge.lo, edge.hi);
    edges_.push_back(edge);
  }
  cells_.finish();
}

std::uint32_t GroundMap::sector_at(PlanPlace place) const {
  const double y = std::floor(place.y) + 0.5;
  const auto row = cells_.cell_of(y);
  double nearest = INFINITY;
  std::uint32_t found = kNoSector;
  for (auto cell = cells_.first_cell_from(cells_.cell_of(place.x), row);
       cell < cells_.cell_count() && cells_.row(cell) == row; ++cell) {
    if (nearest < static_cast<double>(cells_.column(cell) * cells_.cell_mm())) break;
    for (const auto id : cells_.ids(cell)) {
      const GroundEdge& e = edges_[id];
      if ((e.lo.y > y) == (e.hi.y > y)) continue;
      const double x = e.lo.x + (y - e.lo.y) * (double(e.hi.x) - e.lo.x) / (double(e.hi.y) - e.lo.y);
      if (x <= place.x || x >= nearest) continue;
      nearest = x;
      // West of an edge that rises is its left.
      found = e.hi.y > e.lo.y ? e.left : e.right;
    }
  }
  return found;
}

double GroundMap::nearest_in_cell(PlanPlace place, std::int32_t ix, std::int32_t iy) const {
  double nearest = kFarMm;
  for (const auto id : cells_.ids_at(ix, iy))
    if (edges_[id].stops) nearest = std::min(nearest, distance_to_segment(place, edges_[id].lo, edges_[id].hi));
  return nearest;
}

double GroundMap::clearance_mm(PlanPlace place) const {
  const auto cx = cells_.cell_of(place.x), cy = cells_.cell_of(place.y);
  double nearest = kFarMm;
  // Cells in square rings round the place; what lies past ring r is farther than r cells.
  for (std::int32_t r = 0; r == 0 || nearest > static_cast<double>((r - 1) * kCellMm); ++r) {
    for (auto ix = cx - r; ix <= cx + r; ++ix) {
      const bool is_side = ix == cx - r || ix == cx + r;
      for (auto iy = cy - r; iy <= cy + r; iy += is_side || r == 0 ? 1 : 2 * r)
        nearest = std::min(nearest, nearest_in_cell(place, ix, iy));
    }
  }
  return nearest;
}

void GroundMap::add_crossings(PlanPoint a, PlanPoint b, std::vector<double>& fractions) const {
  std::vector<std::uint32_t> near;
  cells_.visit_segment(a, b, [&](std::int32_t ix, std::int32_t iy) {
    const auto ids = cells_.ids_at(ix, iy);
    near.insert(near.end(), ids.begin(), ids.end());
  });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const auto id : near) {
    const GroundEdge& e = edges_[id];
    const auto side_a = rules::orient(e.lo, e.hi, a), side_b = rules::orient(e.lo, e.hi, b);
    const auto side_lo = rules::orient(a, b, e.lo), side_hi = rules::orient(a, b, e.hi);
    if (side_a == side_b || rules::sign(side_a) * rules::sign(side_b) > 0 ||
        rules::sign(side_lo) * rules::sign(side_hi) > 0)
      continue;
    const double t = double(side_a) / (double(side_a) - double(side_b));
    if (t > 0 && t < 1) fractions.push_back(t);
  }
}

}  // namespace vicus
