#include "tests/support/walk_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>

#include "sectorgen/geom/predicates.hpp"

namespace vicus::test {
namespace {

constexpr std::int32_t kScale = 1024;  // so that points beside a point can be told apart

using Direction = std::pair<std::int64_t, std::int64_t>;
std::int64_t cross(Direction a, Direction b) { return a.first * b.second - a.second * b.first; }
std::int64_t dot(Direction a, Direction b) { return a.first * b.first + a.second * b.second; }
Direction from_to(PlanPoint a, PlanPoint b) { return {std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y}; }
PlanPoint scaled(PlanPoint p) { return {p.x * kScale, p.y * kScale}; }

class Brute {
 public:
  explicit Brute(const WalkGround& ground) : ground_(ground) {}

  /// Of a point scaled up.
  bool is_ground(PlanPoint p) const {
    return std::any_of(ground_.triangles.begin(), ground_.triangles.end(), [&](const auto& t) {
      for (std::size_t k = 0; k < 3; ++k)
        if (orient(scaled(t[k]), scaled(t[(k + 1) % 3]), p) < 0) return false;
      return true;
    });
  }

  /// Directions of the walls that leave p, by angle.
  const std::vector<Direction>& walls_at(PlanPoint p) {
    const auto [at, is_new] = walls_at_.try_emplace(p);
    if (!is_new) return at->second;
    auto& directions = at->second;
    for (const auto& w : ground_.walls) {
      if (!on_segment(w.a, w.b, p)) continue;
      if (w.a != p) directions.push_back(from_to(p, w.a));
      if (w.b != p) directions.push_back(from_to(p, w.b));
    }
    std::sort(directions.begin(), directions.end(),
              [](Direction a, Direction b) { return std::atan2(a.second, a.first) < std::atan2(b.second, b.first); });
    const auto is_same = [](Direction a, Direction b) { return cross(a, b) == 0 && dot(a, b) > 0; };
    directions.erase(std::unique(directions.begin(), directions.end(), is_same), directions.end());
    if (directions.size() > 1 && is_same(directions.front(), directions.back())) directions.pop_back();
    return directions;
  }

  /// The piece of ground at p that one is in who goes off in that direction, just left of it, or right. Piece i lies
  /// left of wall i; without walls piece 0 is all round.
  std::size_t piece(PlanPoint p, Direction d, bool is_left) {
    const auto& walls = walls_at(p);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const Direction right = walls[i], left = walls[(i + 1) % walls.size()];
      if (is_along(right, d)) return is_left ? i : (i + walls.size() - 1) % walls.size();
      if (!is_along(left, d) && is_between(right, d, left)) return i;
    }
    return 0;
  }
  std::set<std::size_t> all_pieces(PlanPoint p) {
    const auto& walls = walls_at(p);
    if (walls.empty()) return {0};
    std::set<std::size_t> found;
    for (std::size_t i = 0; i < walls.size(); ++i)
      if (is_ground(beside(p, walls[i], walls[(i + 1) % walls.size()]))) found.insert(i);
    return found;
  }

  /// Can one go straight from a to b, just left of the line (it may run along a wall), or right? Without a wall's end
  /// between: there the way is taken up anew.
  bool is_sight(PlanPoint a, PlanPoint b, bool is_left) {
    bool is_along_wall = false;
    for (const auto& w : ground_.walls) {
      if (cross_properly(a, b, w.a, w.b)) return false;
      for (const PlanPoint p : {w.a, w.b})
        if (p != a && p != b && on_segment(a, b, p)) return false;
      is_along_wall |= on_segment(w.a, w.b, a) && on_segment(w.a, w.b, b);
    }
    const PlanPoint middle{(a.x + b.x) * (kScale / 2), (a.y + b.y) * (kScale / 2)};
    if (!is_along_wall) return is_ground(middle);
    const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y), step = is_left ? 300 : -300;
    return is_ground({middle.x - static_cast<std::int32_t>(std::lround(step * (b.y - a.y) / length)),
                      middle.y + static_cast<std::int32_t>(std::lround(step * (b.x - a.x) / length))});
  }

 private:
  static bool is_along(Direction a, Direction b) { return cross(a, b) == 0 && dot(a, b) > 0; }
  /// Counter-clockwise from right to left, ends left out; right == left: all round.
  static bool is_between(Direction right, Direction d, Direction left) {
    if (is_along(right, left)) return true;
    const auto turn = cross(right, left);
    if (turn > 0 || (turn == 0 && dot(right, left) > 0)) return cross(right, d) > 0 && cross(d, left) > 0;
    if (turn == 0) return cross(right, d) > 0;
    return !(cross(left, d) > 0 && cross(d, right) > 0);
  }
  /// A point scaled up, close to p, between the two directions.
  static PlanPoint beside(PlanPoint p, Direction right, Direction left) {
    const double a = std::atan2(right.second, right.first);
    double b = std::atan2(left.second, left.first);
    if (b <= a) b += 2 * M_PI;
    const double angle = (a + b) / 2;
    return {static_cast<std::int32_t>(std::lround(p.x * double(kScale) + 300 * std::cos(angle))),
            static_cast<std::int32_t>(std::lround(p.y * double(kScale) + 300 * std::sin(angle)))};
  }

  const WalkGround& ground_;
  std::map<PlanPoint, std::vector<Direction>> walls_at_;
};

using Ends = std::pair<PlanPoint, PlanPoint>;
Ends sorted_ends(PlanPoint a, PlanPoint b) { return a < b ? Ends{a, b} : Ends{b, a}; }

}  // namespace

WalkGround walk_ground(const std::vector<Sector>& sectors, const std::vector<Gate>& gates) {
  WalkGround ground;
  std::set<Ends> open, walls;
  for (const auto& gate : gates)
    for (std::size_t i = 0; !gate.to_sector_id.empty() && i + 1 < gate.line.size(); ++i)
      open.insert(sorted_ends(gate.line[i], gate.line[i + 1]));
  for (const auto& sector : sectors) {
    std::vector<PlanPoint> points;
    std::vector<Ring> rings{sector.ground.outer};
    rings.insert(rings.end(), sector.ground.holes.begin(), sector.ground.holes.end());
    for (const auto& ring : rings) {
      points.insert(points.end(), ring.begin(), ring.end());
      for (std::size_t i = 0; i < ring.size(); ++i) walls.insert(sorted_ends(ring[i], ring[(i + 1) % ring.size()]));
    }
    const auto& corners = sector.ground_triangles;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      ground.triangles.push_back({points[corners[i]], points[corners[i + 1]], points[corners[i + 2]]});
  }
  for (const auto& [a, b] : walls)
    if (!open.count({a, b})) ground.walls.push_back({a, b});
  return ground;
}

std::optional<double> shortest_by_brute_force(const WalkGround& ground, PlanPoint from, PlanPoint to) {
  if (from == to) return 0;
  Brute brute(ground);
  std::vector<PlanPoint> points{from, to};
  for (const auto& w : ground.walls)
    for (const PlanPoint p : {w.a, w.b})
      if (p != from && p != to) points.push_back(p);
  std::sort(points.begin() + 2, points.end());
  points.erase(std::unique(points.begin() + 2, points.end()), points.end());
  // A node is a piece of ground at a point.
  using Node = std::pair<std::size_t, std::size_t>;
  std::map<Node, double> least;
  std::priority_queue<std::pair<double, Node>, std::vector<std::pair<double, Node>>, std::greater<>> queue;
  for (const std::size_t piece : brute.all_pieces(from)) queue.push({0, {0, piece}});
  while (!queue.empty()) {
    const auto [mm, node] = queue.top();
    queue.pop();
    if (!least.emplace(node, mm).second) continue;
    const PlanPoint a = points[node.first];
    if (node.first == 1) return mm;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PlanPoint b = points[i];
      if (b == a) continue;
      for (const bool is_left : {true, false}) {
        if (brute.piece(a, from_to(a, b), is_left) != node.second || !brute.is_sight(a, b, is_left)) continue;
        const Node next{i, brute.piece(b, from_to(b, a), !is_left)};
        if (!least.count(next)) queue.push({mm + std::hypot(double(b.x) - a.x, double(b.y) - a.y), next});
      }
    }
  }
  return std::nullopt;
}

double clearance_mm(const WalkGround& ground, double x, double y) {
  double least = std::numeric_limits<double>::max();
  for (const auto& w : ground.walls) {
    const double dx = double(w.b.x) - w.a.x, dy = double(w.b.y) - w.a.y;
    const double share = std::clamp(((x - w.a.x) * dx + (y - w.a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(w.a.x + share * dx - x, w.a.y + share * dy - y));
  }
  return least;
}

}  // namespace vicus::test
