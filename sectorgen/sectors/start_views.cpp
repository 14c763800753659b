#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/naming.hpp"

namespace vicus {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFar_m = 100;       // what lies farther makes a view no better
constexpr double kGood_m = 60;       // of a view's worth: no other place is looked at
constexpr double kBeside = 0.2;      // rad: to both sides of the middle of a view
constexpr double kOutside = 0.25;    // worth of a look out of the city
constexpr double kAlong = 1.25;      // worth of a look along the street
constexpr int kHeadings = 16;        // all round
constexpr int kMostSteps = 4096;     // of a look, triangle by triangle: none goes round a corner for ever
constexpr std::size_t kPlaces = 24;  // looked at where the first is no good

/// A place to stand at: the middle of a line across the sector, in triangle t.
struct Place {
  std::int64_t from_middle2 = 0, wide2 = 0;  // mm2
  PlanPoint at, left, right;
  std::uint32_t triangle = 0;
  bool is_on_axis = false;
};

struct View {
  double worth = -1;
  PlanPoint at;
  double heading = 0;  // rad, clockwise from north
};

class Looker {
 public:
  Looker(const Ground& ground, const Sector& sector) : g_(ground), sector_(sector) {}

  View best_from(const Place& place) const {
    const double across = std::atan2(double(place.left.x) - place.right.x, double(place.left.y) - place.right.y);
    View best;
    const auto offer = [&](double heading, double factor) {
      const double worth =
          factor * (seen(place, heading) + seen(place, heading - kBeside) / 2 + seen(place, heading + kBeside) / 2) / 2;
      if (worth > best.worth) best = {worth, place.at, heading};
    };
    for (const double turn : {0.5, -0.5}) offer(across + turn * kPi, kAlong);
    for (int i = 0; i < kHeadings; ++i) offer(2 * kPi * i / kHeadings, 1);
    return best;
  }

 private:
  /// m of ground before the eye, up to kFar_m; over gates, but not over the sector's own islands.
  double seen(const Place& place, double heading) const {
    const double east = std::sin(heading), north = std::cos(heading);
    const auto side_of = [&](PlanPoint p) {
      return east * (double(p.y) - place.at.y) - north * (double(p.x) - place.at.x);
    };
    /// Where the ray, mm along it, crosses the line from a, on its right, to b.
    const auto crossing = [&](PlanPoint a, PlanPoint b) {
      const double right = side_of(a), left = side_of(b), share = left == right ? 0 : right / (right - left);
      return east * (a.x + share * (double(b.x) - a.x) - place.at.x) +
             north * (a.y + share * (double(b.y) - a.y) - place.at.y);
    };
    double least = kFar_m * kMmPerMetre;
    for (const Ring& hole : sector_.ground.holes)
      for (std::size_t i = 0; i < hole.size(); ++i) {
        const PlanPoint a = hole[i], b = hole[(i + 1) % hole.size()];
        if ((side_of(a) < 0) == (side_of(b) < 0)) continue;
        if (const double mm = crossing(a, b); mm > 0) least = std::min(least, mm);
      }
    std::uint32_t t = place.triangle;
    int entry = -1;
    double mm = 0;
    for (int steps = 0; mm < least && steps < kMostSteps; ++steps) {
      int k = 0;
      while (k < 3 && (k == entry || side_of(g_.from(t, k)) > 0 || side_of(g_.to(t, k)) < 0)) ++k;
      if (k == 3) return mm / kMmPerMetre;  // through a corner
      mm = std::max(mm, crossing(g_.from(t, k), g_.to(t, k)));
      if (g_.is_city_edge(t, k)) return kOutside * std::min(mm, least) / kMmPerMetre;
      if (!g_.is_crossable(t, k)) return std::min(mm, least) / kMmPerMetre;
      entry = g_.mesh.twin_side(t, k);
      t = g_.beyond(t, k);
    }
    return std::min(mm, least) / kMmPerMetre;
  }

  const Ground& g_;
  const Sector& sector_;
};

/// Those of one sector, the best first: on a street's axis, then near the middle.
std::vector<Place> places_in(const Plan& plan, const Sector& sector, std::uint32_t cell,
                             const std::vector<std::uint32_t>& triangles) {
  const Ground& g = plan.ground;
  std::vector<Place> places;
  for (const std::uint32_t t : triangles)
    for (int k = 0; k < 3; ++k) {
      if (!g.is_crossable(t, k) || plan.cells.of[g.beyond(t, k)] != cell || g.beyond(t, k) < t) continue;
      const PlanPoint a = std::min(g.from(t, k), g.to(t, k)), b = std::max(g.from(t, k), g.to(t, k));
      const PlanPoint middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
      places.push_back({distance2(middle, sector.origin), distance2(a, b), middle, a, b, t,
                        plan.routes.is_used[g.edge_id(t, k)] != 0});
    }
  std::sort(places.begin(), places.end(), [](const Place& p, const Place& q) {
    if (p.is_on_axis != q.is_on_axis) return p.is_on_axis;
    return std::tie(p.from_middle2, p.at) < std::tie(q.from_middle2, q.at);
  });
  return places;
}

/// The first place if one sees enough from there; else the best of those with the most room.
std::optional<View> start_view(const Ground& ground, const Sector& sector, std::vector<Place> places) {
  const Looker looker(ground, sector);
  View best;
  const auto offer = [&](const Place& place) {
    if (locate(sector.ground, place.at) != Side::inside) return;  // on an island
    if (const View view = looker.best_from(place); view.worth > best.worth) best = view;
  };
  std::size_t first = 0;
  while (first < places.size() && best.worth < 0) offer(places[first++]);
  if (best.worth >= 0 && best.worth < kGood_m) {
    std::stable_sort(places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
                     [](const Place& p, const Place& q) { return p.wide2 > q.wide2; });
    for (std::size_t i = first; i < std::min(places.size(), first + kPlaces); ++i) offer(places[i]);
  }
  return best.worth < 0 ? std::nullopt : std::optional(best);
}

}  // namespace

void add_start_views(const Plan& plan, City& city) {
  std::vector<std::vector<std::uint32_t>> triangles(city.sectors.size());
  for (std::uint32_t t = 0; t < plan.cells.of.size(); ++t)
    if (plan.cells.of[t] != kNone) triangles[plan.cells.of[t]].push_back(t);
  for (std::uint32_t c = 0; c < city.sectors.size(); ++c) {
    const Sector& s = city.sectors[c];
    Viewpoint v;
    v.sector_id = s.id;
    v.kind = "start";
    v.name = s.name.empty() ? std::string(name_of(s.kind)) : s.name;
    if (const auto view = start_view(plan.ground, s, places_in(plan, s, c, triangles[c]))) {
      v.at = view->at;
      v.heading_deg = std::fmod(std::round(view->heading * 1800 / kPi) + 7200, 3600) / 10;
    } else {  // one triangle: its centre
      std::vector<PlanPoint> p = s.ground.outer;
      const auto& i = s.ground_triangles;
      if (i.size() < 3) continue;
      for (const auto& hole : s.ground.holes) p.insert(p.end(), hole.begin(), hole.end());
      v.at = {static_cast<std::int32_t>((std::int64_t{p[i[0]].x} + p[i[1]].x + p[i[2]].x) / 3),
              static_cast<std::int32_t>((std::int64_t{p[i[0]].y} + p[i[1]].y + p[i[2]].y) / 3)};
    }
    city.viewpoints.push_back(std::move(v));
  }
}

}  // namespace vicus
