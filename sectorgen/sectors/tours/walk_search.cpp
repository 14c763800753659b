#include "sectorgen/sectors/tours/walk_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vicus {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

void WalkSearch::begin() {
  if (++query_ != 0) return;
  std::fill(nodes_.begin(), nodes_.end(), Node{});  // the counter has gone round
  query_ = 1;
}

/// No walk from there to the side's goal is shorter.
double WalkSearch::rest(const Side& side, std::uint32_t node) const {
  const WalkEnd& goal = *side.goal;
  double rest = straight_mm(graph_.corner[node].at, goal.at);
  const auto& from = graph_.from_landmark[node];
  for (std::size_t l = 0; l < graph_.landmarks; ++l) {
    const double beyond = goal.from_landmark[l] - from[l];
    const double differ = goal.is_whole ? std::abs(beyond) : beyond;
    if (differ > rest && differ < kFar) rest = differ;
  }
  return rest;
}

void WalkSearch::reach(std::size_t s, std::uint32_t node, double mm, std::uint32_t before) {
  Node& n = nodes_[node];
  Label& mine = n.of[s];
  const Label& other = n.of[1 - s];
  const bool is_new = mine.query != query_;
  if (!is_new && mine.mm <= mm) return;
  const double rest_mm = is_new ? rest(side_[s], node) : mine.rest_mm;
  if (mm + rest_mm >= best_mm_) return;
  mine = {query_, before, mm, rest_mm};
  side_[s].queue.emplace_back(-mine.whole(), node);
  std::push_heap(side_[s].queue.begin(), side_[s].queue.end());
  if (other.query != query_ || mm + other.mm >= best_mm_) return;
  best_mm_ = mm + other.mm;
  meeting_ = node;
}

/// On from a node, straight or round its wall, to all that one may go to from where one came.
void WalkSearch::follow(std::size_t s, std::uint32_t node) {
  const Label& reached = nodes_[node].of[s];
  const double mm = reached.mm;
  const auto& corner = graph_.corner[node];
  const PlanPoint in = reached.before == kNone ? side_[s].end->at : graph_.corner[reached.before].at, at = corner.at;
  const auto follow_all = [&](std::uint32_t first, std::uint32_t end) {
    steps_ += end - first;
    for (std::uint32_t e = first; e < end; ++e) {
      const std::uint32_t n = graph_.neighbour[e];
      const Node& there = nodes_[n];
      if (there.followed == query_ || (there.of[s].query == query_ && there.of[s].mm <= mm) || is_shut(n)) continue;
      reach(s, n, mm + straight_mm(at, graph_.corner[n].at), node);
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
    follow_all(first_of(std::partition_point(edge(second), edge(end), [&](std::uint32_t n) { return !is_on(n, 1); })),
               end);
  if (corner.has_in_second(in))
    follow_all(first, first_of(std::partition_point(edge(first), edge(second),
                                                    [&](std::uint32_t n) { return is_on(n, -1); })));
}

/// The side's next node. false: no walk over any node that is left is shorter than the best.
bool WalkSearch::advance(std::size_t s) {
  auto& queue = side_[s].queue;
  while (!queue.empty()) {
    const auto [minus_whole, node] = queue.front();
    if (-minus_whole >= best_mm_) return false;
    std::pop_heap(queue.begin(), queue.end());
    queue.pop_back();
    Node& n = nodes_[node];
    if (n.followed == query_ || -minus_whole > n.of[s].whole()) continue;  // reached on a shorter way since
    n.followed = query_;
    side_[s].least_mm = -minus_whole;
    // The walk on from here is no shorter than the least that the other side has left, less its way from there.
    const Side& other = side_[1 - s];
    const double back_mm = n.of[1 - s].query == query_ ? n.of[1 - s].rest_mm : rest(other, node);
    if (n.of[s].mm + other.least_mm - back_mm < best_mm_) follow(s, node);
    return true;
  }
  return false;
}

std::vector<std::uint32_t> WalkSearch::find(const WalkEnd& from, const WalkEnd& to) {
  best_mm_ = kFar;
  meeting_ = kNone;
  steps_ = 0;
  for (std::size_t s = 0; s < 2; ++s) {
    side_[s].end = s == 0 ? &from : &to;
    side_[s].goal = s == 0 ? &to : &from;
    side_[s].queue.clear();
  }
  for (std::size_t s = 0; s < 2; ++s) {
    for (const std::uint32_t n : side_[s].end->seen)
      if (!is_shut(n)) reach(s, n, straight_mm(side_[s].end->at, graph_.corner[n].at), kNone);
    side_[s].least_mm = side_[s].queue.empty() ? kFar : -side_[s].queue.front().first;
  }
  for (std::size_t s = 0; advance(s);) s = side_[0].queue.size() <= side_[1].queue.size() ? 0 : 1;
  std::vector<std::uint32_t> nodes;
  if (meeting_ == kNone) return nodes;
  for (std::uint32_t n = meeting_; n != kNone; n = nodes_[n].of[0].before) nodes.push_back(n);
  std::reverse(nodes.begin(), nodes.end());
  for (std::uint32_t n = nodes_[meeting_].of[1].before; n != kNone; n = nodes_[n].of[1].before) nodes.push_back(n);
  return nodes;
}

}  // namespace vicus
