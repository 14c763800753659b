#include "sectorgen/sectors/tours/sight_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <queue>

#include "city_db/run_parallel.hpp"

namespace vicus {
namespace {

constexpr std::size_t kBatch = 256;  // corners that one thread takes at a time
constexpr double kFar = std::numeric_limits<double>::infinity();

/// Per node, the nodes from which it is met head on: no edge leads there, but a shortest walk may end there.
struct HeadOn {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> from_to;
};

/// Lengths of the shortest walks from a corner to all others.
std::vector<double> walks_from(const WalkMesh& walk, const SightGraph& graph, const HeadOn& head_on,
                               std::uint32_t node) {
  std::vector<double> least(graph.point.size(), kFar);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](std::uint32_t n, double mm) {
    if (mm >= least[n]) return;
    least[n] = mm;
    queue.emplace(mm, n);
  };
  const auto at = [&](std::uint32_t n) { return walk.mesh.points[graph.point[n]]; };
  std::vector<std::uint32_t> standing;  // on the corner's own ground
  int j = walk.corners[node].corner;
  for (std::uint32_t t = walk.corners[node].triangle; t != kNone; t = turned_left(walk, t, j)) standing.push_back(t);
  Sight sight(walk);
  sight.look_round(at(node), standing);
  for (const std::uint32_t c : sight.corners()) reach(graph.node_of[c], straight_mm(at(node), walk.mesh.points[c]));
  while (!queue.empty()) {
    const auto [mm, n] = queue.top();
    queue.pop();
    if (mm > least[n]) continue;
    for (std::uint32_t e = graph.begin[n]; e < graph.begin[n + 1]; ++e)
      reach(graph.neighbour[e], mm + straight_mm(at(n), at(graph.neighbour[e])));
  }
  const auto touched = least;
  for (const auto& [from, to] : head_on.from_to)
    least[to] = std::min(least[to], touched[from] + straight_mm(at(from), at(to)));
  for (const std::uint32_t c : sight.met_head_on())
    least[graph.node_of[c]] = std::min(least[graph.node_of[c]], straight_mm(at(node), walk.mesh.points[c]));
  least[node] = 0;
  return least;
}

/// The corners farthest out in kLandmarks directions, of the largest part of the ground.
std::vector<std::uint32_t> rim_of(const WalkMesh& walk, const SightGraph& graph) {
  std::vector<std::size_t> corners_of(walk.part_count, 0);
  for (const auto& c : walk.corners) ++corners_of[walk.part[c.triangle]];
  const auto largest =
      static_cast<std::uint32_t>(std::max_element(corners_of.begin(), corners_of.end()) - corners_of.begin());
  std::vector<std::uint32_t> rim;
  for (std::size_t l = 0; l < kLandmarks; ++l) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(l) / kLandmarks;
    std::uint32_t best = kNone;
    double farthest = 0;
    for (std::uint32_t n = 0; n < walk.corners.size(); ++n) {
      if (walk.part[walk.corners[n].triangle] != largest) continue;
      const PlanPoint p = walk.mesh.points[graph.point[n]];
      const double out = p.x * std::cos(angle) + p.y * std::sin(angle);
      if (best != kNone && out <= farthest) continue;
      best = n;
      farthest = out;
    }
    if (best != kNone && std::find(rim.begin(), rim.end(), best) == rim.end()) rim.push_back(best);
  }
  return rim;
}

void find_landmarks(const WalkMesh& walk, const HeadOn& head_on, SightGraph& graph) {
  graph.from_landmark.assign(graph.point.size(), {});
  const auto rim = rim_of(walk, graph);
  graph.landmarks = rim.size();
  run_parallel(rim.size(), thread_count(0), [&](std::size_t l, unsigned) {
    const auto from = walks_from(walk, graph, head_on, rim[l]);
    for (std::size_t n = 0; n < from.size(); ++n) graph.from_landmark[n][l] = from[n];
  });
}

/// Appends a corner's neighbours, wedge by wedge; returns how many are in the first.
std::uint32_t append_by_wedge(const SightGraph& graph, const SightGraph::Corner& corner,
                              const std::vector<std::uint32_t>& points, std::vector<std::uint32_t>& out) {
  const PlanPoint at = corner.at;
  // The first wedge begins along the right wall (sign 1), the second opposite to it (-1). One may be a half turn wide.
  const auto append = [&](auto is_in, int sign) {
    const std::size_t first = out.size();
    for (const std::uint32_t p : points)
      if (const std::uint32_t n = graph.node_of[p]; is_in(graph.corner[n].at)) out.push_back(n);
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), [&](std::uint32_t m, std::uint32_t n) {
      const PlanPoint p = graph.corner[m].at, q = graph.corner[n].at;
      if (const auto turn = orient(at, p, q); turn != 0) return turn > 0;
      return dot(at, p, q) < 0 && sign * dot(at, p, corner.right_wall) > 0;
    });
    return static_cast<std::uint32_t>(out.size() - first);
  };
  const std::uint32_t count = append([&](PlanPoint p) { return corner.has_in_first(p); }, 1);
  append([&](PlanPoint p) { return corner.has_in_second(p); }, -1);
  return count;
}

}  // namespace

SightGraph make_sight_graph(const WalkMesh& walk) {
  SightGraph graph;
  graph.node_of.assign(walk.mesh.points.size(), kNone);
  for (const auto& c : walk.corners) {
    const std::uint32_t point = walk.mesh.corner(c.triangle, c.corner);
    graph.node_of[point] = static_cast<std::uint32_t>(graph.point.size());
    graph.point.push_back(point);
    SightGraph::Corner corner{walk.mesh.points[point], walk.right_wall[point], walk.left_wall[point], true};
    int j = c.corner;
    for (std::uint32_t t = c.triangle; t != kNone; t = turned_left(walk, t, j))
      corner.is_blind &= walk.way_out[t] != kNone;
    graph.corner.push_back(corner);
  }
  const std::size_t batches = (walk.corners.size() + kBatch - 1) / kBatch;
  const unsigned threads = thread_count(0);
  std::vector<std::unique_ptr<Sight>> sights(threads);
  std::vector<std::vector<std::uint32_t>> seen(batches), ends(batches), seconds(batches);
  std::vector<HeadOn> met(batches);
  run_parallel(batches, threads, [&](std::size_t b, unsigned thread) {
    if (!sights[thread]) sights[thread] = std::make_unique<Sight>(walk);
    for (std::size_t c = b * kBatch; c < std::min(walk.corners.size(), (b + 1) * kBatch); ++c) {
      sights[thread]->look_on(walk.corners[c].triangle, walk.corners[c].corner);
      const auto begin = static_cast<std::uint32_t>(seen[b].size());
      seconds[b].push_back(begin + append_by_wedge(graph, graph.corner[c], sights[thread]->corners(), seen[b]));
      ends[b].push_back(static_cast<std::uint32_t>(seen[b].size()));
      for (const std::uint32_t point : sights[thread]->met_head_on())
        met[b].from_to.emplace_back(static_cast<std::uint32_t>(c), graph.node_of[point]);
    }
  });
  graph.begin.push_back(0);
  for (std::size_t b = 0; b < batches; ++b) {
    const auto before = static_cast<std::uint32_t>(graph.neighbour.size());
    for (const std::uint32_t end : ends[b]) graph.begin.push_back(before + end);
    for (const std::uint32_t second : seconds[b]) graph.second.push_back(before + second);
    graph.neighbour.insert(graph.neighbour.end(), seen[b].begin(), seen[b].end());
    seen[b] = {};
  }
  HeadOn head_on;
  for (const auto& m : met) head_on.from_to.insert(head_on.from_to.end(), m.from_to.begin(), m.from_to.end());
  find_landmarks(walk, head_on, graph);
  return graph;
}

}  // namespace vicus
