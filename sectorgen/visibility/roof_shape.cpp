#include "sectorgen/visibility/roof_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "sectorgen/geom/polygon.hpp"

namespace vicus {
namespace {

constexpr double kSliver_m = 0.002;
constexpr double kMisfit_m = 0.01;  // of a roof between the house's eave and its height
constexpr double kNear_m = 1e-6;    // rounding of doubles within 2^30 mm

double up_of(const RoofPoint& p) { return p.up / kRoofStepsPerMetre; }

}  // namespace

RoofTriangle::RoofTriangle(const RoofPoint& a, const RoofPoint& b, const RoofPoint& c) {
  const Spot corner[3] = {spot_of(a.at), spot_of(b.at), spot_of(c.at)};
  at_ = corner[0];
  up_ = up_of(a);
  const double bx = corner[1].x - at_.x, by = corner[1].y - at_.y, cx = corner[2].x - at_.x, cy = corner[2].y - at_.y;
  const double area2 = bx * cy - by * cx, b_up = up_of(b) - up_, c_up = up_of(c) - up_;
  slope_ = {(b_up * cy - c_up * by) / area2, (c_up * bx - b_up * cx) / area2};
  steepness_ = length_of(slope_.x, slope_.y);
  least_m_ = std::min({up_of(a), up_of(b), up_of(c)});
  most_m_ = std::max({up_of(a), up_of(b), up_of(c)});
  low_ = {std::min({corner[0].x, corner[1].x, corner[2].x}), std::min({corner[0].y, corner[1].y, corner[2].y})};
  high_ = {std::max({corner[0].x, corner[1].x, corner[2].x}), std::max({corner[0].y, corner[1].y, corner[2].y})};
  for (std::size_t k = 0; k < 3; ++k) {
    const Spot p = corner[k], q = corner[(k + 1) % 3];
    const double length = length_of(q.x - p.x, q.y - p.y);
    normal_[k] = {-(q.y - p.y) / length, (q.x - p.x) / length};
    offset_[k] = -(normal_[k].x * p.x + normal_[k].y * p.y);
  }
}

double RoofTriangle::least_within(Spot x, double reach) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (normal_[k].x * x.x + normal_[k].y * x.y + offset_[k] < -reach - kNear_m)
      return std::numeric_limits<double>::infinity();
  return std::max(least_m_, height_at(x) - steepness_ * reach - kNear_m);
}

Stretch RoofTriangle::stretch(Spot p, Spot q) const {
  Stretch stretch{0, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at_p = normal_[k].x * p.x + normal_[k].y * p.y + offset_[k],
                 at_q = normal_[k].x * q.x + normal_[k].y * q.y + offset_[k];
    if (at_p < 0 && at_q < 0) return {};
    if (at_p >= 0 && at_q >= 0) continue;
    const double at = at_p / (at_p - at_q);
    if (at_p < 0)
      stretch.from = std::max(stretch.from, at);
    else
      stretch.to = std::min(stretch.to, at);
  }
  return stretch;
}

std::vector<RoofTriangle> roof_triangles(const Building& building) {
  std::vector<RoofTriangle> triangles;
  const auto& points = building.roof.points;
  double covered2 = 0;  // mm2
  for (const auto& facet : building.roof.facets) {
    if (is_upright(facet.kind)) continue;
    for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3) {
      const RoofPoint &a = points[facet.triangles[i]], &b = points[facet.triangles[i + 1]],
                      &c = points[facet.triangles[i + 2]];
      const auto area2 = static_cast<double>(orient(a.at, b.at, c.at));
      covered2 += area2;
      const double longest2 =
          static_cast<double>(std::max({distance2(a.at, b.at), distance2(b.at, c.at), distance2(c.at, a.at)}));
      if (area2 > kSliver_m * kMmPerMetre * std::sqrt(longest2)) triangles.emplace_back(a, b, c);
    }
  }
  double rim_mm = kMmPerMetre * perimeter_m(building.footprint.outer);
  for (const auto& hole : building.footprint.holes) rim_mm += kMmPerMetre * perimeter_m(hole);
  const double footprint2 = static_cast<double>(area2(building.footprint));
  bool fits = std::abs(covered2 - footprint2) <= 2 * kSliver_m * kMmPerMetre * rim_mm;
  for (const auto& p : points)
    fits &= up_of(p) >= building.eave_m - kMisfit_m && up_of(p) <= building.height_m + kMisfit_m;
  if (!fits) triangles.clear();
  return triangles;
}

std::vector<RoofEdge> roof_edges(const Building& building, bool has_triangles, bool from_above_too) {
  std::vector<RoofEdge> edges;
  if (!has_triangles) {
    const auto add = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.push_back(
            {spot_of(ring[i]), spot_of(ring[i + 1 == ring.size() ? 0 : i + 1]), building.height_m, building.height_m});
    };
    add(building.footprint.outer);
    for (const auto& hole : building.footprint.holes) add(hole);
    return edges;
  }
  const auto& points = building.roof.points;
  std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
  for (const auto& p : points) lowest = std::min(lowest, p.up);
  std::set<std::pair<std::uint32_t, std::uint32_t>> known;
  for (const auto& facet : building.roof.facets)
    for (const auto& ring : facet.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
        const RoofPoint &p = points[a], &q = points[b];
        if (p.at == q.at || !known.insert(std::minmax(a, b)).second) continue;
        if (!from_above_too && p.up <= lowest && q.up <= lowest) continue;
        edges.push_back({spot_of(p.at), spot_of(q.at), up_of(p), up_of(q)});
      }
  return edges;
}

}  // namespace vicus
