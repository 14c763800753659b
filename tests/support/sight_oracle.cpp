#include "tests/support/sight_oracle.hpp"

#include <algorithm>

namespace vicus::test {
namespace {

/// A side as something to step over, going out of its cell: `right` and `left` as the walker sees its ends.
struct Step {
  std::uint32_t from_cell, to_cell, right, left;  // points by index; to_cell kWall and more: a wall
};

struct Graph {
  std::vector<PlanPoint> points;
  std::vector<Step> steps;  // by from_cell
};

Graph graph_of(const SightMap& map) {
  Graph graph;
  for (const auto& cell : map.cells) graph.points.insert(graph.points.end(), cell.corner.begin(), cell.corner.end());
  std::sort(graph.points.begin(), graph.points.end());
  graph.points.erase(std::unique(graph.points.begin(), graph.points.end()), graph.points.end());
  const auto index = [&](PlanPoint p) {
    return static_cast<std::uint32_t>(std::lower_bound(graph.points.begin(), graph.points.end(), p) -
                                      graph.points.begin());
  };
  for (std::uint32_t c = 0; c < map.cells.size(); ++c)
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::uint32_t side = map.cells[c].beyond[k]; side != kNowhere)
        graph.steps.push_back({c, side < kWall ? side / 4 : side, index(map.cells[c].corner[(k + 1) % 3]),
                               index(map.cells[c].corner[(k + 2) % 3])});
  return graph;
}

}  // namespace

Sights sights_by_brute_force(const SightMap& map) {
  const Graph graph = graph_of(map);
  const std::size_t points = graph.points.size(), cells = map.cells.size();
  std::vector<char> seen(map.sector_count() * map.sector_count(), 0);
  std::vector<char> met(map.sector_count() * map.groups.size(), 0);
  std::vector<double> x(points), y(points);  // exact: differences below 2^31, products below 2^53 by the assertion
  for (std::size_t i = 0; i < points; ++i) x[i] = graph.points[i].x, y[i] = graph.points[i].y;
  std::vector<signed char> side_of(points);
  std::vector<std::uint32_t> crossed_begin(cells + 1), crossed;
  std::vector<std::uint32_t> reached(cells, kNowhere), queue;
  std::uint32_t stamp = 0;
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t q = 0; q < points; ++q) {
      if (p == q) continue;
      const double dx = x[q] - x[p], dy = y[q] - y[p];
      for (std::size_t i = 0; i < points; ++i) {
        const double det = dx * (y[i] - y[p]) - dy * (x[i] - x[p]);
        side_of[i] = static_cast<signed char>((det > 0) - (det < 0));
      }
      crossed.clear();
      std::fill(crossed_begin.begin(), crossed_begin.end(), 0);
      for (std::uint32_t e = 0; e < graph.steps.size(); ++e) {
        const Step& step = graph.steps[e];
        if (side_of[step.right] > 0 || side_of[step.left] < 0) continue;
        crossed.push_back(e);
        ++crossed_begin[step.from_cell + 1];
      }
      for (std::size_t c = 0; c < cells; ++c) crossed_begin[c + 1] += crossed_begin[c];
      // From each sector once: everything that the line reaches after leaving it.
      for (const std::uint32_t first : crossed) {
        const Step& exit = graph.steps[first];
        const std::uint32_t source = map.cells[exit.from_cell].sector;
        if (source == kNowhere || exit.to_cell >= kWall || map.cells[exit.to_cell].sector == source) continue;
        ++stamp;
        reached[exit.to_cell] = stamp;
        queue.assign(1, exit.to_cell);
        while (!queue.empty()) {
          const std::uint32_t c = queue.back();
          queue.pop_back();
          if (map.cells[c].sector != kNowhere) seen[source * map.sector_count() + map.cells[c].sector] = 1;
          met[source * map.groups.size() + map.cells[c].group] = 1;
          for (std::uint32_t i = crossed_begin[c]; i < crossed_begin[c + 1]; ++i) {
            const std::uint32_t n = graph.steps[crossed[i]].to_cell;
            if (n >= kWall) met[source * map.groups.size() + n - kWall] = 1;
            if (n >= kWall || reached[n] == stamp) continue;
            reached[n] = stamp;
            queue.push_back(n);
          }
        }
      }
    }
  Sights sights;
  for (std::uint32_t a = 0; a < map.sector_count(); ++a) {
    for (std::uint32_t c = map.begin[a]; c < map.begin[a + 1]; ++c) {
      met[a * map.groups.size() + map.cells[c].group] = 1;
      for (const std::uint32_t side : map.cells[c].beyond)
        if (side >= kWall && side != kNowhere) met[a * map.groups.size() + side - kWall] = 1;
    }
    seen[a * map.sector_count() + a] = 1;
    for (std::uint32_t b = 0; b < map.sector_count(); ++b)
      if (seen[a * map.sector_count() + b]) sights.sectors.insert({a, b});
    for (std::uint32_t g = 0; g < map.groups.size(); ++g)
      for (const std::uint32_t house : map.groups[g])
        if (met[a * map.groups.size() + g] && !seen[a * map.sector_count() + map.owner[house]])
          sights.houses.insert({a, house});
  }
  return sights;
}

}  // namespace vicus::test
