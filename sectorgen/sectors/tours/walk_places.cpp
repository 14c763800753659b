#include "sectorgen/sectors/tours/walk_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_set>

#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

constexpr double kTrianglesPerCell = 8;
constexpr double kIntoTriangle = 3;  // mm: how far towards the middle a point on the rim is moved before it is rounded

struct Foot {
  double x = 0, y = 0, distance_mm = 0;
};

Foot foot_on(PlanPoint a, PlanPoint b, PlanPoint p) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length2 = dx * dx + dy * dy;
  const double along = ((double(p.x) - a.x) * dx + (double(p.y) - a.y) * dy) / length2;
  const double share = std::clamp(along, 0.0, 1.0);
  const Foot foot{a.x + share * dx, a.y + share * dy, 0};
  return {foot.x, foot.y, std::hypot(foot.x - p.x, foot.y - p.y)};
}

bool holds(const WalkMesh& walk, std::uint32_t t, PlanPoint p) {
  for (int k = 0; k < 3; ++k)
    if (orient(walk.at(t, k + 1), walk.at(t, k + 2), p) < 0) return false;
  return true;
}

Foot nearest_in(const WalkMesh& walk, std::uint32_t t, PlanPoint p) {
  if (holds(walk, t, p)) return {double(p.x), double(p.y), 0};
  Foot best{0, 0, std::numeric_limits<double>::max()};
  for (int k = 0; k < 3; ++k)
    if (const Foot foot = foot_on(walk.at(t, k), walk.at(t, k + 1), p); foot.distance_mm < best.distance_mm)
      best = foot;
  return best;
}

/// A lattice point in the triangle's closure next to a point on its rim.
PlanPoint rounded_into(const WalkMesh& walk, std::uint32_t t, Foot foot) {
  const auto lattice = [](double x, double y) {
    return PlanPoint{static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
  };
  double x = 0, y = 0;
  for (int k = 0; k < 3; ++k) {
    x += walk.at(t, k).x / 3.0;
    y += walk.at(t, k).y / 3.0;
  }
  const double length = std::hypot(x - foot.x, y - foot.y);
  for (const double step : {0.0, 1.0, kIntoTriangle}) {
    const double share = length > 0 ? std::min(1.0, step / length) : 0;
    const PlanPoint p = lattice(foot.x + share * (x - foot.x), foot.y + share * (y - foot.y));
    if (holds(walk, t, p)) return p;
  }
  PlanPoint best = walk.at(t, 0);  // a sliver without lattice points but its corners
  for (int k = 1; k < 3; ++k)
    if (std::hypot(walk.at(t, k).x - foot.x, walk.at(t, k).y - foot.y) < std::hypot(best.x - foot.x, best.y - foot.y))
      best = walk.at(t, k);
  return best;
}

}  // namespace

WalkPlaces::WalkPlaces(const WalkMesh& walk) : walk_(walk) {
  for (const PlanPoint p : walk.mesh.points) box_.add(p);
  if (box_.is_empty() || walk.mesh.triangles.empty()) return;
  const double width = double(box_.max.x) - box_.min.x + 1, height = double(box_.max.y) - box_.min.y + 1;
  cell_mm_ = std::sqrt(width * height * kTrianglesPerCell / static_cast<double>(walk.mesh.triangles.size())) + 1;
  columns_ = static_cast<std::size_t>(width / cell_mm_) + 1;
  rows_ = static_cast<std::size_t>(height / cell_mm_) + 1;
  near_.assign(columns_ * rows_, kNone);
  for (std::uint32_t t = 0; t < walk.mesh.triangles.size(); ++t) {
    const PlanPoint p = walk.at(t, 0);
    near_[static_cast<std::size_t>((double(p.y) - box_.min.y) / cell_mm_) * columns_ +
          static_cast<std::size_t>((double(p.x) - box_.min.x) / cell_mm_)] = t;
  }
  std::uint32_t last = 0;
  for (auto& t : near_) t = t == kNone ? last : (last = t);
}

std::uint32_t WalkPlaces::triangle_at(PlanPoint p) const {
  if (near_.empty() || !box_.contains(p)) return kNone;
  return walk_from(near_[static_cast<std::size_t>((double(p.y) - box_.min.y) / cell_mm_) * columns_ +
                         static_cast<std::size_t>((double(p.x) - box_.min.x) / cell_mm_)],
                   p);
}

/// Over the first side that has p beyond it; which side is first changes, so that no cycle lasts.
std::uint32_t WalkPlaces::walk_from(std::uint32_t t, PlanPoint p) const {
  const std::size_t limit = 4 * walk_.mesh.triangles.size() + 64;
  for (std::size_t step = 0; step < limit; ++step) {
    bool has_moved = false;
    for (int i = 0; i < 3 && !has_moved; ++i) {
      const int k = static_cast<int>((static_cast<std::size_t>(i) + step * 7919 / 3) % 3);
      if (orient(walk_.at(t, k + 1), walk_.at(t, k + 2), p) >= 0) continue;
      t = walk_.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
      if (t == kNone) return kNone;
      has_moved = true;
    }
    if (!has_moved) return t;
  }
  return kNone;
}

std::vector<std::uint32_t> WalkPlaces::standing_at(PlanPoint p) const {
  std::vector<std::uint32_t> around, standing;
  if (const std::uint32_t t = triangle_at(p); t != kNone) around.push_back(t);
  // Triangles that share p are neighbours of each other over sides through p, or all the way round a corner.
  for (std::size_t i = 0; i < around.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = walk_.mesh.triangles[around[i]].neighbour[static_cast<std::size_t>(k)];
      if (n != kNone && holds(walk_, n, p) && std::find(around.begin(), around.end(), n) == around.end())
        around.push_back(n);
    }
  std::copy_if(around.begin(), around.end(), std::back_inserter(standing),
               [&](std::uint32_t t) { return walk_.sector[t] != kNone; });
  return standing;
}

std::optional<Standing> WalkPlaces::nearest(PlanPoint p, double within_mm) const {
  if (near_.empty()) return std::nullopt;
  // Triangles that a growing disc round p meets are joined by their sides: nearest first, the first to stand on is it.
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::unordered_set<std::uint32_t> seen;
  const auto push = [&](std::uint32_t t) {
    if (!seen.insert(t).second) return;
    const double distance = nearest_in(walk_, t, p).distance_mm;
    if (distance <= within_mm) queue.emplace(distance, t);
  };
  if (const std::uint32_t t = triangle_at(p); t != kNone)
    push(t);
  else
    for (std::uint32_t u = 0; u < walk_.mesh.triangles.size(); ++u)
      if (walk_.sector[u] != kNone) push(u);
  while (!queue.empty()) {
    const auto [distance, t] = queue.top();
    queue.pop();
    if (walk_.sector[t] != kNone) return Standing{rounded_into(walk_, t, nearest_in(walk_, t, p)), t};
    for (const std::uint32_t n : walk_.mesh.triangles[t].neighbour)
      if (n != kNone) push(n);
  }
  return std::nullopt;
}

}  // namespace vicus
