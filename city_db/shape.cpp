#include "city_db/shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "city_db/rules_exact.hpp"
#include "city_db/shape_ground.hpp"
#include "city_db/shape_names.hpp"

namespace vicus {
namespace {

double twice_area(const Ring& ring) {
  rules::Int128 sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += rules::cross(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  return static_cast<double>(sum);
}

/// Counter-clockwise, corners only.
Ring convex_hull(Ring points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring hull;
  const auto add_chain = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= start + 2 && rules::orient(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // begins the other chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

double distance_mm(PlanPoint a, PlanPoint b) { return std::hypot(double(b.x) - a.x, double(b.y) - a.y); }

double diameter_mm(const Ring& hull) {
  double widest = 0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i + 1; j < hull.size(); ++j) widest = std::max(widest, distance_mm(hull[i], hull[j]));
  return widest;
}

PlanPlace middle_of(const std::vector<PlanPoint>& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += distance_mm(line[i], line[i + 1]);
  double rest = length / 2;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double step = distance_mm(line[i], line[i + 1]);
    if (step > 0 && rest <= step) {
      const double t = rest / step;
      return {line[i].x + t * (double(line[i + 1].x) - line[i].x), line[i].y + t * (double(line[i + 1].y) - line[i].y)};
    }
    rest -= step;
  }
  return place_of(line.back());
}

bool is_street_gate(const Gate& g) { return g.kind == GateKind::street || g.kind == GateKind::passage; }

template <class CountsSector, class CountsGate>
SectorFigures measure_sectors(const City& city, CountsSector counts_sector, CountsGate counts_gate) {
  std::map<std::string, double> gates;
  for (const auto& gate : city.gates)
    if (counts_gate(gate)) gates[gate.sector_id] += 1;
  std::vector<double> gate_counts, convexities, lengths;
  double area_sum = 0, weighted = 0;
  for (const auto& sector : city.sectors) {
    if (!counts_sector(sector)) continue;
    double area = twice_area(sector.ground.outer);
    for (const auto& hole : sector.ground.holes) area += twice_area(hole);
    const Ring hull = convex_hull(sector.ground.outer);
    const double hull_area = twice_area(hull);
    gate_counts.push_back(gates[sector.id]);
    lengths.push_back(diameter_mm(hull) / kMmPerMetre);
    if (hull_area <= 0) continue;
    convexities.push_back(area / hull_area);
    area_sum += area;
    weighted += area * area / hull_area;
  }
  return {spread_of(std::move(gate_counts)), spread_of(std::move(convexities)), area_sum > 0 ? weighted / area_sum : 0,
          spread_of(std::move(lengths))};
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double fraction) {
    const double rank = fraction * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const double above = values[std::min(below + 1, values.size() - 1)];
    return values[below] + (rank - static_cast<double>(below)) * (above - values[below]);
  };
  double sum = 0;
  for (const double v : values) sum += v;
  return {values.size(), at(0.5), at(0.05), at(0.95), sum / static_cast<double>(values.size())};
}

ShapeReport measure_shape(const City& city) {
  const GroundMap ground(city);
  ShapeReport report;
  const auto is_street_like = [](const Sector& s) {
    return s.kind == SectorKind::street || s.kind == SectorKind::crossroads || s.kind == SectorKind::square;
  };
  report.streets = measure_sectors(city, is_street_like, is_street_gate);
  report.all = measure_sectors(
      city, [](const Sector&) { return true; }, [](const Gate& g) { return !g.to_sector_id.empty(); });
  std::vector<double> streets, yards, kerbs;
  for (const auto& gate : city.gates) {
    if (gate.to_sector_id.empty() || gate.line.size() < 2 || gate.twin_id < gate.id) continue;
    const double clearance = std::max(1.0, ground.clearance_mm(middle_of(gate.line)));  // mm: a ratio even at an edge
    const double ratio = distance_mm(gate.line.front(), gate.line.back()) / (2 * clearance);
    (is_street_gate(gate) ? streets : gate.kind == GateKind::kerb ? kerbs : yards).push_back(ratio);
  }
  report.gate_width_ratio = spread_of(std::move(streets));
  report.yard_gate_width_ratio = spread_of(std::move(yards));
  report.kerb_gate_width_ratio = spread_of(std::move(kerbs));
  report.named_streets = measure_named_streets(city, ground);
  return report;
}

}  // namespace vicus
