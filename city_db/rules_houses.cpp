#include <algorithm>

#include "city_db/boxes.hpp"
#include "city_db/polygon_edges.hpp"
#include "city_db/rules_cells.hpp"
#include "city_db/rules_parts.hpp"

namespace vicus::rules {
namespace {

constexpr std::int64_t kCellMm = 32'000;  ///< about a house and its garden

/// A point of the half lattice: coordinates in half millimetres, |c| < 2^31.
struct HalfPoint {
  std::int64_t x = 0, y = 0;
};

/// Strictly inside, by crossings of a ray to the east. Exact.
bool is_strictly_inside(HalfPoint p, const Polygon& polygon) {
  bool inside = false, on_edge = false;
  visit_edges(polygon, [&](PlanPoint a, PlanPoint b) {
    const std::int64_t ax = 2 * std::int64_t{a.x}, ay = 2 * std::int64_t{a.y};
    const std::int64_t bx = 2 * std::int64_t{b.x}, by = 2 * std::int64_t{b.y};
    if (p.y < std::min(ay, by) || p.y > std::max(ay, by)) return;
    const Int128 side = static_cast<Int128>(bx - ax) * (p.y - ay) - static_cast<Int128>(by - ay) * (p.x - ax);
    if (side == 0 && p.x >= std::min(ax, bx) && p.x <= std::max(ax, bx)) on_edge = true;
    if ((ay > p.y) != (by > p.y) && (by > ay ? side > 0 : side < 0)) inside = !inside;
  });
  return inside && !on_edge;
}

/// Does the open segment meet the interior? If it crosses no edge properly, it changes between inside and outside
/// only at corners of the footprint that lie on it, so one point between neighbouring corners speaks for all.
bool passes_through(PlanPoint a, PlanPoint b, const Polygon& footprint) {
  std::vector<PlanPoint> stops{a, b};
  bool crosses = false;
  visit_edges(footprint, [&](PlanPoint c, PlanPoint d) {
    crosses = crosses || cross_properly(a, b, c, d);
    if (is_inside_segment(c, a, b)) stops.push_back(c);
  });
  if (crosses) return true;
  std::sort(stops.begin(), stops.end());
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const HalfPoint middle{std::int64_t{stops[i].x} + stops[i + 1].x, std::int64_t{stops[i].y} + stops[i + 1].y};
    if (is_strictly_inside(middle, footprint)) return true;
  }
  return false;
}

}  // namespace

void check_houses_whole(const City& city, Findings& findings) {
  CellIndex houses(kCellMm);
  std::vector<PlanBox> boxes(city.buildings.size());
  for (std::uint32_t i = 0; i < city.buildings.size(); ++i) {
    if (!stands_on_ground(city.buildings[i])) continue;
    boxes[i] = box_of(city.buildings[i].footprint.outer);
    if (!boxes[i].is_empty()) houses.add_box(i, boxes[i]);
  }
  houses.finish();
  std::vector<std::uint32_t> near;
  for (const auto& gate : city.gates)
    for (std::size_t k = 0; k + 1 < gate.line.size(); ++k) {
      const PlanPoint a = gate.line[k], b = gate.line[k + 1];
      near.clear();
      houses.visit_segment(a, b, [&](std::int32_t ix, std::int32_t iy) {
        for (const auto i : houses.ids_at(ix, iy))
          if (meet(boxes[i], box_of(a, b))) near.push_back(i);
      });
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      for (const auto i : near)
        if (passes_through(a, b, city.buildings[i].footprint))
          findings.add(Rule::houses_whole, gate.id, a, "the gate passes through building " + city.buildings[i].id);
    }
}

}  // namespace vicus::rules
