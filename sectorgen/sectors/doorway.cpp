#include "sectorgen/sectors/doorway.hpp"

#include <algorithm>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/interiors.hpp"

namespace vicus {
namespace {

constexpr double kJamb_mm = 60;  // of wall that stays between a doorway and a corner of the room
constexpr double kThinnest_mm = 20;

}  // namespace

std::optional<RayHit> first_hit(const Ring& ring, PlanPoint p, Heading ray) {
  std::optional<RayHit> best;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const double ex = double(b.x) - a.x, ey = double(b.y) - a.y, across = ex * ray.y - ey * ray.x;
    if (across <= 0) continue;  // along the edge, or out of the room
    const double px = double(p.x) - a.x, py = double(p.y) - a.y;
    const double share = (px * ray.y - py * ray.x) / across, distance = (py * ex - px * ey) / -across;
    if (share < 0 || share > 1 || distance < 0 || (best && distance >= best->distance_mm)) continue;
    best = RayHit{i, share, distance};
  }
  return best;
}

std::optional<bool> open_doorway(Ring& ring, PlanPoint p, PlanPoint q, Heading ray) {
  const auto hit_p = first_hit(ring, p, ray), hit_q = first_hit(ring, q, ray);
  if (!hit_p || !hit_q || hit_p->edge != hit_q->edge) return std::nullopt;
  if (std::min(hit_p->distance_mm, hit_q->distance_mm) < kThinnest_mm ||
      std::max(hit_p->distance_mm, hit_q->distance_mm) > kDeepestDoorway_m * kMmPerMetre)
    return std::nullopt;
  const std::size_t i = hit_p->edge;
  const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
  const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
  const double low = std::min(hit_p->share, hit_q->share), high = std::max(hit_p->share, hit_q->share);
  if (low * length < kJamb_mm || (1 - high) * length < kJamb_mm) return std::nullopt;
  const auto at = [&](const RayHit& hit) { return moved(a, heading_of(a, b), hit.share * length); };
  const bool is_p_first = hit_p->share < hit_q->share;
  std::vector<PlanPoint> way{at(*hit_p), p, q, at(*hit_q)};
  if (!is_p_first) std::reverse(way.begin(), way.end());
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, way.begin(), way.end());
  return is_p_first;
}

bool is_segment_inside(PlanPoint a, PlanPoint b, const Polygon& polygon) {
  if (locate(polygon, a) == Side::outside || locate(polygon, b) == Side::outside) return false;
  const auto crosses = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint c = ring[i], d = ring[(i + 1) % ring.size()];
      if (cross_properly(a, b, c, d)) return true;
      // A corner between the two, and the outline on both sides of the segment.
      if (c != a && c != b && on_segment(a, b, c)) {
        const PlanPoint before = ring[(i + ring.size() - 1) % ring.size()];
        if ((orient(a, b, before) > 0) != (orient(a, b, d) > 0) && orient(a, b, before) != 0 && orient(a, b, d) != 0)
          return true;
      }
    }
    return false;
  };
  return !crosses(polygon.outer) && std::none_of(polygon.holes.begin(), polygon.holes.end(), crosses);
}

}  // namespace vicus
