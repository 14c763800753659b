#include "sectorgen/sectors/tours/shortest_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

constexpr double kFollowed = -1;
constexpr double kFar = std::numeric_limits<double>::infinity();

double length(PlanPoint a, PlanPoint b) {  // squares of lattice differences are far from overflow: no hypot
  const double x = double(b.x) - a.x, y = double(b.y) - a.y;
  return std::sqrt(x * x + y * y);
}

/// Where the line a -> b crosses the side p -> q, as a share of the way; between 0 and 1.
double share_at(PlanPoint a, PlanPoint b, PlanPoint p, PlanPoint q) {
  const double before = static_cast<double>(orient(p, q, a)), beyond = static_cast<double>(orient(p, q, b));
  return before != beyond ? std::clamp(before / (before - beyond), 0.0, 1.0) : 0;
}

}  // namespace

ShortestWalk::ShortestWalk(const WalkMesh& walk, const WalkPlaces& places, const SightGraph& graph)
    : walk_(walk), places_(places), graph_(graph), sight_(walk), reached_(graph.point.size()) {}

/// No walk from there to `to` is shorter.
double ShortestWalk::rest_from(std::uint32_t node) const {
  double rest = length(graph_.corner[node].at, to_);
  const auto& from = graph_.from_landmark[node];
  for (std::size_t l = 0; l < graph_.landmarks; ++l) {
    const double beyond = to_landmark_[l] - static_cast<double>(from[l]);
    const double differ = (is_whole_ ? std::abs(beyond) : beyond) - kLandmarkSlack_mm;
    if (differ > rest && differ < kFar) rest = differ;
  }
  return rest;
}

void ShortestWalk::reach(std::uint32_t node, double mm, std::uint32_t before) {
  Reached& r = reached_[node];
  if (r.query == query_ && r.mm <= mm) return;
  const double f = mm + rest_from(node);
  if (f >= best_mm_) return;
  r.query = query_;
  r.before = before;
  r.mm = mm;
  r.least_mm = f;
  queue_.emplace_back(-f, node);
  std::push_heap(queue_.begin(), queue_.end());
  if (r.sees_to != query_) return;
  if (const double whole = mm + length(graph_.corner[node].at, to_); whole < best_mm_) {
    best_mm_ = whole;
    last_ = node;
  }
}

/// Is the ground at `to` in one piece? If not (a corner where walls meet), no walk goes over `to` from piece to piece.
bool ShortestWalk::is_one_piece(const std::vector<std::uint32_t>& standing) const {
  std::vector<std::uint32_t> joined{standing.front()};
  for (std::size_t i = 0; i < joined.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = walk_.mesh.triangles[joined[i]].neighbour[static_cast<std::size_t>(k)];
      if (walk_.is_open(joined[i], k) && std::find(standing.begin(), standing.end(), n) != standing.end() &&
          std::find(joined.begin(), joined.end(), n) == joined.end())
        joined.push_back(n);
    }
  return joined.size() == standing.size();
}

/// Corners on the way out of the alleys that these triangles are in.
void ShortestWalk::let_into_alleys(const std::vector<std::uint32_t>& triangles) {
  for (const std::uint32_t first : triangles)
    for (std::uint32_t t = first; walk_.way_out[t] != kNone; t = walk_.way_out[t])
      for (int k = 0; k < 3; ++k)
        if (const std::uint32_t node = graph_.node_of[walk_.mesh.corner(t, k)]; node != kNone)
          reached_[node].let_in = query_;
}

/// false: no way. Fills best_mm_ and last_.
bool ShortestWalk::search(PlanPoint from, std::uint64_t& steps) {
  best_mm_ = kFar;
  last_ = kNone;
  queue_.clear();
  for (const std::uint32_t c : sight_.corners())
    if (const std::uint32_t n = graph_.node_of[c]; !graph_.corner[n].is_blind || reached_[n].let_in == query_)
      reach(n, length(from, walk_.mesh.points[c]), kNone);
  while (!queue_.empty()) {
    const auto [minus_f, node] = queue_.front();
    if (-minus_f >= best_mm_) break;
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    Reached& reached = reached_[node];
    if (-minus_f > reached.least_mm) continue;  // reached on a shorter way, or followed on, since
    reached.least_mm = kFollowed;
    const double mm = reached.mm;
    const auto& corner = graph_.corner[node];
    const std::uint32_t before = reached.before;
    const PlanPoint in = before == kNone ? from : graph_.corner[before].at, at = corner.at;
    const auto follow = [&](std::uint32_t first, std::uint32_t end) {
      steps += end - first;
      for (std::uint32_t e = first; e < end; ++e) {
        const std::uint32_t n = graph_.neighbour[e];
        const Reached& there = reached_[n];
        if (there.query == query_ && there.mm <= mm) continue;
        if (graph_.corner[n].is_blind && there.let_in != query_) continue;
        reach(n, mm + length(at, graph_.corner[n].at), node);
      }
    };
    // Straight on, or to that side of it; which may be back, along the other side of a wall without breadth.
    const auto is_on = [&](std::uint32_t n, int side) {
      const PlanPoint next = graph_.corner[n].at, wall = side > 0 ? corner.left_wall : corner.right_wall;
      const std::int64_t turn = side * orient(in, at, next);
      return turn > 0 || (turn == 0 && (dot(at, in, next) < 0 || dot(at, wall, next) > 0));
    };
    const auto edge = [&](std::uint32_t e) { return graph_.neighbour.begin() + e; };
    const auto first_of = [&](auto found) { return static_cast<std::uint32_t>(found - graph_.neighbour.begin()); };
    const std::uint32_t first = graph_.begin[node], second = graph_.second[node], end = graph_.begin[node + 1];
    if (corner.has_in_first(in))
      follow(first_of(std::partition_point(edge(second), edge(end), [&](std::uint32_t n) { return !is_on(n, 1); })),
             end);
    if (corner.has_in_second(in))
      follow(first,
             first_of(std::partition_point(edge(first), edge(second), [&](std::uint32_t n) { return is_on(n, -1); })));
  }
  return last_ != kNone;
}

std::optional<Walk> ShortestWalk::find(PlanPoint from, PlanPoint to) {
  const auto from_triangles = places_.standing_at(from), to_triangles = places_.standing_at(to);
  bool is_connected = false;
  for (const std::uint32_t f : from_triangles)
    for (const std::uint32_t t : to_triangles) is_connected |= walk_.part[f] == walk_.part[t];
  if (!is_connected) return std::nullopt;
  if (++query_ == 0) {  // the counter has gone round
    std::fill(reached_.begin(), reached_.end(), Reached{});
    query_ = 1;
  }
  to_ = to;
  is_whole_ = is_one_piece(to_triangles);
  let_into_alleys(from_triangles);
  let_into_alleys(to_triangles);
  // From the end: which corners see it, how far it is from the landmarks.
  sight_.watch_for(from, from_triangles);
  sight_.look_round(to, to_triangles);
  if (sight_.has_seen_goal() || from == to) return walk_along({from, to}, {});
  to_landmark_.fill(kFar);
  const auto tell_landmarks = [&](std::uint32_t c) {
    const double mm = length(walk_.mesh.points[c], to);
    for (std::size_t l = 0; l < graph_.landmarks; ++l)
      to_landmark_[l] = std::min(to_landmark_[l], static_cast<double>(graph_.from_landmark[graph_.node_of[c]][l]) + mm);
  };
  for (const std::uint32_t c : sight_.corners()) {
    reached_[graph_.node_of[c]].sees_to = query_;
    tell_landmarks(c);
  }
  for (const std::uint32_t c : sight_.met_head_on()) tell_landmarks(c);  // it may be a landmark
  for (const std::uint32_t t : to_triangles)
    for (int k = 0; k < 3; ++k)  // or `to` stands on one
      if (const std::uint32_t c = walk_.mesh.corner(t, k); walk_.mesh.points[c] == to && graph_.node_of[c] != kNone)
        tell_landmarks(c);
  sight_.look_round(from, from_triangles);
  std::uint64_t steps = 0;
  if (!search(from, steps)) return std::nullopt;
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = last_; n != kNone; n = reached_[n].before) nodes.push_back(n);
  std::reverse(nodes.begin(), nodes.end());
  std::vector<PlanPoint> points{from};
  for (const std::uint32_t n : nodes) points.push_back(walk_.mesh.points[graph_.point[n]]);
  points.push_back(to);
  Walk walk = walk_along(points, nodes);
  walk.steps = steps;
  return walk;
}

/// Lengths, radii, and the sectors: over each side in turn; round a bend through the triangles that are only touched.
Walk ShortestWalk::walk_along(const std::vector<PlanPoint>& points, const std::vector<std::uint32_t>& nodes) {
  Walk walk;
  walk.points = points;
  walk.radius_mm.assign(points.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) walk.radius_mm[i + 1] = walk_.radius_mm[graph_.point[nodes[i]]];
  const auto enter = [&](std::uint32_t t, double at_mm) {
    const std::uint32_t sector = walk_.sector[t];
    if (walk.sectors.empty() || walk.sectors.back().sector != sector) walk.sectors.push_back({sector, at_mm});
  };
  std::uint32_t in = kNone;  // the triangle that the last leg ended in
  // Round the bend, on the ground's side of it, to where the next leg begins.
  const auto turn_to = [&](std::uint32_t t, std::size_t bend) {
    if (in == kNone || in == t) return enter(t, walk.length_mm);
    const std::uint32_t point = graph_.point[nodes[bend - 1]];
    for (const bool is_left : {true, false}) {
      std::vector<std::uint32_t> round;
      std::uint32_t at = in;
      int j = 0;
      while (walk_.mesh.corner(at, j) != point) ++j;
      while (at != kNone && at != t) {
        round.push_back(at);
        at = is_left ? turned_left(walk_, at, j) : turned_right(walk_, at, j);
      }
      if (at != t) continue;
      for (const std::uint32_t r : round) enter(r, walk.length_mm);
      break;
    }
    enter(t, walk.length_mm);
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const PlanPoint a = points[i], b = points[i + 1];
    auto from = places_.standing_at(a), to = places_.standing_at(b);
    const auto bends = [&](std::size_t at, std::vector<std::uint32_t>& standing) {  // of a corner, its own ground only
      if (at == 0 || at + 1 == points.size()) return;
      const std::uint32_t point = graph_.point[nodes[at - 1]];
      std::erase_if(standing, [&](std::uint32_t t) {
        int j = 0;
        while (walk_.mesh.corner(t, j) != point) ++j;
        return !walk_.is_bend(t, j);
      });
    };
    bends(i, from);
    bends(i + 1, to);
    const auto way = sight_.way_to(a, from, b, to);
    if (way.empty()) {
      const auto shared = std::find_if(from.begin(), from.end(),
                                       [&](std::uint32_t t) { return std::find(to.begin(), to.end(), t) != to.end(); });
      if (shared != from.end()) {
        turn_to(*shared, i);
        in = *shared;
      }
    } else {
      const auto& first = way.front();
      turn_to(walk_.mesh.triangles[first.triangle].neighbour[static_cast<std::size_t>(first.side)], i);
      for (const auto& [t, side] : way)
        enter(t, walk.length_mm + share_at(a, b, walk_.at(t, side + 1), walk_.at(t, side + 2)) * length(a, b));
      in = way.back().triangle;
    }
    walk.length_mm += length(a, b);
  }
  return walk;
}

}  // namespace vicus
