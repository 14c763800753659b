#include "sectorgen/sectors/tours/corner_caps.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/sectors/tours/walk_places.hpp"

namespace vicus {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostTurn = kPi / 4;   // of the rim at one point: the point stands 1.08 radii off
constexpr double kBesideArc = kPi / 6;  // how far beside the arc room is looked for
constexpr std::int32_t kLeast_mm = 10;  // smaller caps are left out
constexpr int kRounds = 6;              // of making caps smaller; in the last they go

struct Vec {
  double x = 0, y = 0;
};
Vec minus(PlanPoint a, PlanPoint b) { return {double(a.x) - b.x, double(a.y) - b.y}; }
double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
Vec unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// From the origin to the segment ab.
double distance_to(Vec a, Vec b) {
  const Vec along{b.x - a.x, b.y - a.y};
  const double length2 = dot(along, along);
  const double share = length2 > 0 ? std::clamp(-dot(a, along) / length2, 0.0, 1.0) : 0;
  return std::hypot(a.x + share * along.x, a.y + share * along.y);
}

/// The triangles round a corner from wall to wall.
struct Fan {
  double begin = 0, span = 0;                            ///< angle of the wall on its right; how far round to the other
  std::vector<std::pair<std::uint32_t, int>> triangles;  ///< and the corner's number in each
};

Fan fan_of(const WalkMesh& walk, std::uint32_t t, int j) {
  Fan fan;
  const PlanPoint v = walk.at(t, j);
  const Vec first = minus(walk.at(t, j + 1), v);
  fan.begin = std::atan2(first.y, first.x);
  while (t != kNone) {
    fan.triangles.emplace_back(t, j);
    const Vec right = minus(walk.at(t, j + 1), v), left = minus(walk.at(t, j + 2), v);
    fan.span += std::atan2(cross(right, left), dot(right, left));
    t = turned_left(walk, t, j);
  }
  return fan;
}

/// Way from a corner to the nearest wall that is seen from it.
class Room {
 public:
  Room(const WalkMesh& walk, PlanPoint v, double reach) : walk_(walk), v_(v), least_(reach) {}

  /// Through side k of t, out of t, between the rays.
  void look(std::uint32_t t, int k, Vec right, Vec left) {
    const Vec at_right = minus(walk_.at(t, k + 1), v_), at_left = minus(walk_.at(t, k + 2), v_);
    const Vec a = cross(at_right, right) > 0 ? hit(right, at_right, at_left) : at_right;
    const Vec b = cross(at_left, left) < 0 ? hit(left, at_right, at_left) : at_left;
    const double distance = distance_to(a, b);
    if (distance >= least_) return;
    if (!walk_.is_open(t, k)) {
      least_ = distance;
      return;
    }
    const int twin = walk_.mesh.twin_side(t, k);
    const std::uint32_t n = walk_.mesh.triangles[t].neighbour[static_cast<std::size_t>(k % 3)];
    const Vec apex = minus(walk_.at(n, twin), v_);
    if (cross(right, apex) > 0) look(n, (twin + 1) % 3, right, cross(apex, left) < 0 ? left : apex);
    if (cross(apex, left) > 0) look(n, (twin + 2) % 3, cross(right, apex) < 0 ? right : apex, left);
  }
  double least() const { return least_; }

 private:
  static Vec hit(Vec ray, Vec a, Vec b) {
    const Vec along{b.x - a.x, b.y - a.y};
    const double slope = cross(ray, along);
    const double s = slope != 0 ? cross(a, along) / slope : 1;
    return {ray.x * s, ray.y * s};
  }

  const WalkMesh& walk_;
  PlanPoint v_;
  double least_;
};

/// mm to the nearest wall across the arc that a walk can lean on, at most `reach`.
double room_at(const WalkMesh& walk, PlanPoint v, const Fan& fan, double reach) {
  Room room(walk, v, reach);
  const double from = kPi / 2 - kBesideArc, to = fan.span - kPi / 2 + kBesideArc;
  double angle = 0;
  for (const auto& [t, j] : fan.triangles) {
    const Vec right = minus(walk.at(t, j + 1), v), left = minus(walk.at(t, j + 2), v);
    const double next = angle + std::atan2(cross(right, left), dot(right, left));
    if (next > from && angle < to)
      room.look(t, j, angle < from ? unit(fan.begin + from) : right, next > to ? unit(fan.begin + to) : left);
    angle = next;
  }
  return room.least();
}

void make_rim(CornerCap& cap, double begin, double turn) {
  cap.rim.clear();
  const int pieces = std::max(2, static_cast<int>(std::ceil(turn / kMostTurn - 1e-9)));
  const double each = turn / pieces, reach = cap.radius_mm / std::cos(each / 2);
  for (int i = 0; i < pieces; ++i) {
    const Vec d = unit(begin + (i + 0.5) * each);
    PlanPoint p{cap.corner.x + static_cast<std::int32_t>(std::lround(reach * d.x)),
                cap.corner.y + static_cast<std::int32_t>(std::lround(reach * d.y))};
    if (!cap.rim.empty() && orient(cap.corner, cap.rim.back(), p) <= 0) {  // a wall that hardly turns
      p = {cap.rim.back().x - static_cast<std::int32_t>(std::lround(3 * d.y)),
           cap.rim.back().y + static_cast<std::int32_t>(std::lround(3 * d.x))};
    }
    cap.rim.push_back(p);
  }
}

/// Half as wide.
void halve(CornerCap& cap) {
  cap.radius_mm /= 2;
  for (PlanPoint& p : cap.rim) {
    p.x = cap.corner.x + (p.x - cap.corner.x) / 2;
    p.y = cap.corner.y + (p.y - cap.corner.y) / 2;
  }
}

double area_m2_of(const WalkMesh& walk, std::uint32_t t) {
  return static_cast<double>(orient(walk.at(t, 0), walk.at(t, 1), walk.at(t, 2))) / 2 / kMmPerMetre / kMmPerMetre;
}

PlanPoint middle_of(const WalkMesh& walk, std::uint32_t t) {
  std::int64_t x = 0, y = 0;
  for (int k = 0; k < 3; ++k) {
    x += walk.at(t, k).x;
    y += walk.at(t, k).y;
  }
  return {static_cast<std::int32_t>(x / 3), static_cast<std::int32_t>(y / 3)};
}

/// Per part: is it cut off, by caps, from a larger one.
struct CutOff {
  std::vector<char> is_cut;
  std::vector<double> area_m2;
};

CutOff cut_off_parts(const WalkMesh& bare, const WalkPlaces& bare_places, const WalkMesh& walk) {
  std::vector<double> area(walk.part_count, 0), largest(walk.part_count, 0);
  std::vector<std::uint32_t> triangle(walk.part_count, kNone);
  for (std::uint32_t t = 0; t < walk.part.size(); ++t) {
    const std::uint32_t part = walk.part[t];
    if (part == kNone) continue;
    const double m2 = area_m2_of(walk, t);
    area[part] += m2;
    if (triangle[part] == kNone || m2 > largest[part]) {
      largest[part] = m2;
      triangle[part] = t;
    }
  }
  std::vector<std::uint32_t> home(walk.part_count, kNone), best(bare.part_count, kNone);
  for (std::uint32_t p = 0; p < walk.part_count; ++p) {
    const std::uint32_t t = bare_places.triangle_at(middle_of(walk, triangle[p]));
    if (t == kNone || bare.part[t] == kNone) continue;  // a sliver along a wall that moved by a millimetre
    home[p] = bare.part[t];
    if (best[home[p]] == kNone || area[p] > area[best[home[p]]]) best[home[p]] = p;
  }
  CutOff cut{std::vector<char>(walk.part_count, 0), area};
  for (std::uint32_t p = 0; p < walk.part_count; ++p) cut.is_cut[p] = home[p] == kNone || best[home[p]] != p;
  return cut;
}

/// Caps that have a point in common with a part to be joined again.
std::vector<std::size_t> caps_around(const WalkMesh& walk, const std::vector<CornerCap>& caps, const CutOff& cut) {
  std::vector<PlanPoint> points;
  for (std::uint32_t t = 0; t < walk.part.size(); ++t)
    if (const std::uint32_t part = walk.part[t]; part != kNone && cut.is_cut[part] && cut.area_m2[part] > kPocket_m2)
      for (int k = 0; k < 3; ++k) points.push_back(walk.at(t, k));
  std::sort(points.begin(), points.end());
  std::vector<std::size_t> found;
  const auto is_at = [&](PlanPoint p) { return std::binary_search(points.begin(), points.end(), p); };
  for (std::size_t i = 0; i < caps.size(); ++i)
    if (is_at(caps[i].corner) || std::any_of(caps[i].rim.begin(), caps[i].rim.end(), is_at)) found.push_back(i);
  return found;
}

void leave_out_pockets(WalkMesh& walk, const CutOff& cut) {
  for (std::uint32_t t = 0; t < walk.part.size(); ++t)
    if (walk.part[t] != kNone && cut.is_cut[walk.part[t]] && cut.area_m2[walk.part[t]] <= kPocket_m2) {
      walk.sector[t] = walk.part[t] = kNone;
      walk.open[t] = walk.bends[t] = 0;
    }
  std::erase_if(walk.corners, [&](const SideOfFan& c) { return walk.sector[c.triangle] == kNone; });
}

}  // namespace

std::vector<CornerCap> corner_caps(const WalkMesh& bare, std::int32_t clearance_mm) {
  assert(clearance_mm > 0);
  std::vector<CornerCap> caps;
  for (const auto& [t, k] : bare.corners) {
    const Fan fan = fan_of(bare, t, k);
    CornerCap cap;
    cap.corner = bare.at(t, k);
    const double room = room_at(bare, cap.corner, fan, clearance_mm / kRoomShare);
    cap.radius_mm = std::min(clearance_mm, static_cast<std::int32_t>(room * kRoomShare));
    if (cap.radius_mm < kLeast_mm) continue;
    make_rim(cap, fan.begin + kPi / 2, fan.span - kPi);
    caps.push_back(std::move(cap));
  }
  return caps;
}

WalkMesh make_clear_walk_mesh(const std::vector<Sector>& sectors, const std::vector<Gate>& gates,
                              std::int32_t clearance_mm) {
  WalkMesh bare = make_walk_mesh(sectors, gates);
  if (clearance_mm == 0) return bare;
  auto caps = corner_caps(bare, clearance_mm);
  const WalkPlaces bare_places(bare);
  for (int round = 0;; ++round) {
    WalkMesh walk = make_walk_mesh(sectors, gates, caps);
    const CutOff cut = cut_off_parts(bare, bare_places, walk);
    const auto around = caps_around(walk, caps, cut);
    if (around.empty() || round == kRounds) {
      leave_out_pockets(walk, cut);
      return walk;
    }
    for (const std::size_t i : around) halve(caps[i]);
    std::erase_if(caps, [&](const CornerCap& cap) { return cap.radius_mm < kLeast_mm; });
  }
}

}  // namespace vicus
