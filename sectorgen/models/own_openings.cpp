#include "sectorgen/models/own_openings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "city_db/facade_layout.hpp"

namespace vicus {
namespace {

// Before or behind the wall. First: bays, deep doorways, footprints that are not quite walls. Then, of what has found
// no wall: storeys that hang out over the footprint, and were cut off with it, and loggias.
constexpr double kReach_m = 0.8, kFarReach_m = 2.5;
constexpr double kLeast_m = 0.2;                            // of an opening's sides
constexpr double kEdge_m = 0.02;                            // of wall that stays at a facade's ends
constexpr double kGap_m = 0.01;                             // between openings
constexpr double kStorey_m = 1.2;                           // middles that differ by less stand in one row
constexpr double kLeastDepth_m = 0.03, kMostDepth_m = 0.5;  // as modelled; others are as deep as their style's

/// On a facade: where, and how far behind it.
struct Lying {
  Opening opening;
  double behind = 0;
};

std::optional<Lying> lying_on(const Facade& f, const ModelOpening& model, double reach_m) {
  const double length = length_m(f);
  const double ux = metres(f.a.x - f.b.x) / length, uy = metres(f.a.y - f.b.y) / length;
  double x0 = HUGE_VAL, x1 = -HUGE_VAL, z0 = HUGE_VAL, z1 = -HUGE_VAL, near = HUGE_VAL, far = -HUGE_VAL;
  for (const ModelPoint& p : model.corners) {
    const double px = metres(p.at.x - f.b.x), py = metres(p.at.y - f.b.y);
    const double x = px * ux + py * uy, behind = py * ux - px * uy, z = p.up_m - f.bottom_m;
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    z0 = std::min(z0, z), z1 = std::max(z1, z);
    near = std::min(near, behind), far = std::max(far, behind);
  }
  const double middle = (x0 + x1) / 2, behind = (near + far) / 2;
  const bool is_along = far - near < 0.7 * (x1 - x0);
  if (!is_along || std::abs(behind) > reach_m || middle < 0 || middle > length || z0 > f.top_m - f.bottom_m - kLeast_m)
    return std::nullopt;
  Opening o;
  o.x0 = std::max(x0, kEdge_m);
  o.x1 = std::min(x1, length - kEdge_m);
  o.z0 = std::max(z0, 0.0);
  o.z1 = std::min(z1, f.top_m - f.bottom_m - kEdge_m);
  if (o.x1 - o.x0 < kLeast_m || o.z1 - o.z0 < kLeast_m) return std::nullopt;
  o.depth = far > kLeastDepth_m && far < kMostDepth_m ? far : figures_of(f.style).depth;
  return Lying{o, std::abs(behind)};
}

OpeningKind kind_of(const Opening& o, bool is_door, FacadeStyle style) {
  const double width = o.x1 - o.x0, height = o.z1 - o.z0;
  if (is_door) {
    if (style == FacadeStyle::church) return OpeningKind::church_door;
    return width > 0.9 * height ? OpeningKind::gate_door : OpeningKind::house_door;
  }
  if (style == FacadeStyle::church && height > 1.5 * width) return OpeningKind::church_window;
  if (width > 1.05 * height) return OpeningKind::wide_window;
  return OpeningKind::window;
}

double area(const Opening& o) { return (o.x1 - o.x0) * (o.z1 - o.z0); }

/// Cuts `o` back to one side of `other`, the one that leaves most; false: too little is left.
bool yields(Opening& o, const Opening& other) {
  if (o.x1 + kGap_m <= other.x0 || other.x1 + kGap_m <= o.x0 || o.z1 + kGap_m <= other.z0 || other.z1 + kGap_m <= o.z0)
    return true;
  Opening left = o, right = o, low = o, high = o;
  left.x1 = std::min(o.x1, other.x0 - kGap_m);
  right.x0 = std::max(o.x0, other.x1 + kGap_m);
  low.z1 = std::min(o.z1, other.z0 - kGap_m);
  high.z0 = std::max(o.z0, other.z1 + kGap_m);
  const Opening* best = nullptr;
  for (const Opening* rest : {&left, &right, &low, &high})
    if (rest->x1 - rest->x0 >= kLeast_m && rest->z1 - rest->z0 >= kLeast_m && (!best || area(*rest) > area(*best)))
      best = rest;
  if (!best || area(*best) < area(o) / 2) return false;
  o = Opening(*best);
  return true;
}

/// Largest first. Who yields only gets smaller, and so stays apart from those it was compared with before.
std::vector<Opening> apart(std::vector<Opening> openings) {
  std::stable_sort(openings.begin(), openings.end(),
                   [](const Opening& a, const Opening& b) { return area(a) > area(b); });
  std::vector<Opening> out;
  for (Opening& o : openings)
    if (out.size() < kMostOwnOpenings &&
        std::all_of(out.begin(), out.end(), [&](const Opening& other) { return yields(o, other); }))
      out.push_back(o);
  return out;
}

/// Storeys from below, bays from the left.
void number(Facade& f) {
  auto& list = f.openings;
  const auto middle = [](const Opening& o) { return (o.z0 + o.z1) / 2; };
  std::stable_sort(list.begin(), list.end(), [&](const Opening& a, const Opening& b) { return middle(a) < middle(b); });
  int floor = 0, most = 0;
  double row = middle(list.front());
  std::map<int, int> in_row;
  for (Opening& o : list) {
    if (middle(o) > row + kStorey_m) row = middle(o), floor = std::min(floor + 1, kMostFloors - 1);
    o.floor = floor;
    most = std::max(most, ++in_row[floor]);
  }
  std::stable_sort(list.begin(), list.end(), [](const Opening& a, const Opening& b) {
    return std::pair(a.floor, a.x0) < std::pair(b.floor, b.x0);
  });
  f.floors = floor + 1;
  f.bays = std::min(most, kMostBays);
  f.repeats = 1;
  f.door_bay = -1;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Opening& o = list[i];
    o.bay = static_cast<int>(i);
    const bool is_door = o.kind == OpeningKind::house_door || o.kind == OpeningKind::church_door;
    if (is_door && f.door_bay < 0)
      f.door_bay = std::clamp(static_cast<int>((o.x0 + o.x1) / 2 / length_m(f) * f.bays), 0, f.bays - 1);
  }
}

}  // namespace

std::size_t hang_openings(const HouseModel& model, const std::vector<Facade*>& facades) {
  std::size_t count = 0;
  for (const ModelOpening& opening : model.openings) {
    std::optional<Lying> best;
    Facade* where = nullptr;
    for (const double reach_m : {kReach_m, kFarReach_m})
      for (Facade* f : facades) {
        if (where && reach_m > kReach_m) break;
        if (auto lying = lying_on(*f, opening, reach_m); lying && (!best || lying->behind < best->behind))
          best = lying, where = f;
      }
    if (!where) continue;
    best->opening.kind = kind_of(best->opening, opening.is_door, where->style);
    where->openings.push_back(best->opening);
    ++count;
  }
  for (Facade* f : facades) {
    if (f->openings.empty()) continue;
    f->openings = apart(std::move(f->openings));
    number(*f);
  }
  return count;
}

}  // namespace vicus
