#include "sectorgen/sectors/facade_spot.hpp"

#include <algorithm>

#include "city_db/facade_layout.hpp"
#include "city_db/segment.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/doorway.hpp"
#include "sectorgen/sectors/interiors.hpp"

namespace vicus {
namespace {

template <class Visit>
void visit_stretches(const City& city, const std::string& building_id, Visit visit) {
  for (const Border& border : city.borders) {
    if (border.kind != BorderKind::facade || border.building_id != building_id) continue;
    const auto runs = straight_runs(border.line);
    for (std::size_t i = 0; i + 1 < runs.size(); ++i)
      if (border.line[runs[i]] != border.line[runs[i + 1]])
        visit(border.sector_id, border.line[runs[i]], border.line[runs[i + 1]]);
  }
}

double length_of(PlanPoint a, PlanPoint b) { return std::hypot(double(b.x) - a.x, double(b.y) - a.y); }

}  // namespace

std::optional<FacadeSpot> facade_spot(const City& city, const std::string& building_id, PlanPoint at, double reach_m) {
  std::optional<FacadeSpot> best;
  visit_stretches(city, building_id, [&](const std::string& sector, PlanPoint a, PlanPoint b) {
    const double distance_m = distance_to_segment_mm(at, a, b) / kMmPerMetre;
    if (distance_m > reach_m || (best && distance_m >= best->distance_m)) return;
    const Heading h = heading_of(a, b);
    const double along = (double(at.x) - a.x) * h.x + (double(at.y) - a.y) * h.y;
    best = FacadeSpot{sector, a, b, std::clamp(along, 0.0, length_of(a, b)), distance_m};
  });
  return best;
}

std::optional<PlanPoint> middle_of_longest_facade(const City& city, const std::string& building_id,
                                                  const Polygon& room) {
  std::optional<PlanPoint> best;
  double longest = 0;
  visit_stretches(city, building_id, [&](const std::string&, PlanPoint a, PlanPoint b) {
    const PlanPoint middle = moved(a, heading_of(a, b), length_of(a, b) / 2);
    const auto hit = first_hit(room.outer, middle, right_of(heading_of(a, b)));
    if (!hit || hit->distance_mm > kDeepestDoorway_m * kMmPerMetre || length_of(a, b) <= longest) return;
    longest = length_of(a, b);
    best = middle;
  });
  return best;
}

std::optional<std::pair<PlanPoint, PlanPoint>> opening_in(const FacadeSpot& spot, double width_m,
                                                          const Polygon& footprint) {
  const double half = width_m / 2 * kMmPerMetre, least = half + kFromCorner_m * kMmPerMetre;
  const double length = length_of(spot.a, spot.b);
  if (length < 2 * least) return std::nullopt;
  const double along = std::clamp(spot.along_mm, least, length - least);
  const Heading h = heading_of(spot.a, spot.b);
  for (int inset = 0; inset <= kMostInset_mm; ++inset) {
    const auto at = [&](double mm) { return moved(moved(spot.a, h, mm), right_of(h), inset); };
    const PlanPoint a = at(along - half), b = at(along + half);
    if (is_segment_inside(a, b, footprint)) return std::pair(a, b);
  }
  return std::nullopt;
}

}  // namespace vicus
