#include "sectorgen/bake/impostors/capture_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vicus {
namespace {

constexpr double kLeastSine = 0.25;  // of the angle between sight and gate: seen from farther aside it is a slit

struct Place {
  double x = 0, y = 0;  // mm
};
Place place_of(PlanPoint p) { return {double(p.x), double(p.y)}; }
PlanPoint rounded(Place p) {
  return {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))};
}
Place between(Place a, Place b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }
double distance(Place a, Place b) { return std::hypot(a.x - b.x, a.y - b.y); }
double side(Place a, Place b, Place c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

template <class Visit>
void visit_edges(const Polygon& ground, Visit visit) {
  const auto ring = [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) visit(place_of(r[i]), place_of(r[(i + 1) % r.size()]));
  };
  ring(ground.outer);
  for (const Ring& hole : ground.holes) ring(hole);
}

class GroundOf {
 public:
  explicit GroundOf(const Polygon& ground) : ground_(ground) {}

  bool contains(Place p) const {
    bool is_inside = false;
    visit_edges(ground_, [&](Place a, Place b) {
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
    });
    return is_inside;
  }
  /// Does no edge cross the line? Touching its ends counts as free.
  bool is_free(Place from, Place to) const {
    bool free = true;
    visit_edges(ground_, [&](Place a, Place b) {
      if (side(from, to, a) * side(from, to, b) < 0 && side(a, b, from) * side(a, b, to) < 0) free = false;
    });
    return free;
  }

 private:
  const Polygon& ground_;
};

/// Corners moved inwards along the middle between their edges, and middles of triangles.
std::vector<Place> candidates(const Sector& sector) {
  std::vector<Place> out;
  std::vector<PlanPoint> points = sector.ground.outer;
  const double keep = kKeepOff_m * kMmPerMetre;
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place p = place_of(ring[i]), a = place_of(ring[(i + ring.size() - 1) % ring.size()]),
                  b = place_of(ring[(i + 1) % ring.size()]);
      const double la = distance(p, a), lb = distance(p, b);
      // Inside is on the left of a -> p -> b.
      double x = -((p.y - a.y) / la + (b.y - p.y) / lb), y = (p.x - a.x) / la + (b.x - p.x) / lb;
      const double l = std::hypot(x, y);
      if (l > 1e-6) out.push_back({p.x + 2 * keep * x / l, p.y + 2 * keep * y / l});
    }
  };
  add_ring(sector.ground.outer);
  for (const Ring& hole : sector.ground.holes) {
    add_ring(hole);
    points.insert(points.end(), hole.begin(), hole.end());
  }
  const auto& t = sector.ground_triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const Place a = place_of(points.at(t[i])), b = place_of(points.at(t[i + 1])), c = place_of(points.at(t[i + 2]));
    out.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
  }
  return out;
}

}  // namespace

GateWindow window_of(const Gate& gate) { return {gate.line.back(), gate.line.front()}; }

PlanPoint capture_point(const Sector& sector, const Gate& gate, double share) {
  const GateWindow window = window_of(gate);
  const Place left = place_of(window.left), right = place_of(window.right), middle = between(left, right, 0.5);
  const double width = distance(left, right);
  const GroundOf ground(sector.ground);
  // Just inside the gate's ends, so that its own neighbours among the edges do not hide them.
  constexpr double kInside = 0.02;
  const Place near_left = between(left, right, kInside), near_right = between(left, right, 1 - kInside);
  const auto ahead = [&](Place p) { return -side(left, right, p) / width; };
  Place best{};
  double farthest = 0;
  for (const Place& p : candidates(sector)) {
    const double d = distance(p, middle);
    if (d <= farthest || ahead(p) < kLeastSine * d || !ground.contains(p)) continue;
    if (!ground.is_free(p, near_left) || !ground.is_free(p, near_right) || !ground.is_free(p, middle)) continue;
    best = p;
    farthest = d;
  }
  const double nx = (right.y - left.y) / width, ny = -(right.x - left.x) / width;  // into the sector
  const auto before = [&](double mm) { return Place{middle.x + nx * mm, middle.y + ny * mm}; };
  if (farthest == 0) {
    double mm = std::max(width, 4 * kKeepOff_m * kMmPerMetre);
    while (mm > 2 * kKeepOff_m * kMmPerMetre && !(ground.contains(before(mm)) && ground.is_free(before(mm), middle)))
      mm *= 0.7;
    best = before(mm);
  }
  const Place at = between(middle, best, share);
  // However near: before the gate, not in it.
  const double least = 2 * kKeepOff_m * kMmPerMetre;
  return rounded(ahead(at) >= least ? at : before(least));
}

}  // namespace vicus
