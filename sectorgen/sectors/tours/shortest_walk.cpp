#include "sectorgen/sectors/tours/shortest_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Where the line a -> b crosses the side p -> q, as a share of the way; between 0 and 1.
double share_at(PlanPoint a, PlanPoint b, PlanPoint p, PlanPoint q) {
  const double before = static_cast<double>(orient(p, q, a)), beyond = static_cast<double>(orient(p, q, b));
  return before != beyond ? std::clamp(before / (before - beyond), 0.0, 1.0) : 0;
}

}  // namespace

ShortestWalk::ShortestWalk(const WalkMesh& walk, const WalkPlaces& places, const SightGraph& graph)
    : walk_(walk), places_(places), graph_(graph), sight_(walk), search_(graph) {}

/// Is the ground at a place in one piece? If not (a corner where walls meet), no walk leads over it from piece to
/// piece.
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
        if (const std::uint32_t node = graph_.node_of[walk_.mesh.corner(t, k)]; node != kNone) search_.let_in(node);
}

/// Which corners see the end of a walk, how far it is from the landmarks.
void ShortestWalk::look_from(PlanPoint p, const std::vector<std::uint32_t>& triangles, WalkEnd& end) {
  end.at = p;
  end.is_whole = is_one_piece(triangles);
  end.seen.clear();
  end.from_landmark.fill(kFar);
  sight_.look_round(p, triangles);
  const auto tell_landmarks = [&](std::uint32_t c) {
    const double mm = straight_mm(walk_.mesh.points[c], p);
    for (std::size_t l = 0; l < graph_.landmarks; ++l)
      end.from_landmark[l] = std::min(end.from_landmark[l], graph_.from_landmark[graph_.node_of[c]][l] + mm);
  };
  for (const std::uint32_t c : sight_.corners()) {
    end.seen.push_back(graph_.node_of[c]);
    tell_landmarks(c);
  }
  for (const std::uint32_t c : sight_.met_head_on()) tell_landmarks(c);  // it may be a landmark
  for (const std::uint32_t t : triangles)
    for (int k = 0; k < 3; ++k)  // or `p` stands on one
      if (const std::uint32_t c = walk_.mesh.corner(t, k); walk_.mesh.points[c] == p && graph_.node_of[c] != kNone)
        tell_landmarks(c);
}

std::optional<Walk> ShortestWalk::find(PlanPoint from, PlanPoint to) {
  const auto from_triangles = places_.standing_at(from), to_triangles = places_.standing_at(to);
  bool is_connected = false;
  for (const std::uint32_t f : from_triangles)
    for (const std::uint32_t t : to_triangles) is_connected |= walk_.part[f] == walk_.part[t];
  if (!is_connected) return std::nullopt;
  search_.begin();
  let_into_alleys(from_triangles);
  let_into_alleys(to_triangles);
  sight_.watch_for(from, from_triangles);
  look_from(to, to_triangles, to_);
  if (sight_.has_seen_goal() || from == to) return walk_along({from, to}, {});
  look_from(from, from_triangles, from_);
  const auto nodes = search_.find(from_, to_);
  if (nodes.empty()) return std::nullopt;
  std::vector<PlanPoint> points{from};
  for (const std::uint32_t n : nodes) points.push_back(walk_.mesh.points[graph_.point[n]]);
  points.push_back(to);
  Walk walk = walk_along(points, nodes);
  walk.steps = search_.steps();
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
        enter(t, walk.length_mm + share_at(a, b, walk_.at(t, side + 1), walk_.at(t, side + 2)) * straight_mm(a, b));
      in = way.back().triangle;
    }
    walk.length_mm += straight_mm(a, b);
  }
  return walk;
}

}  // namespace vicus
