#include "sectorgen/models/wall_lines.hpp"

#include <algorithm>
#include <map>

#include "city_db/facade_layout.hpp"
#include "city_db/segment.hpp"

namespace vicus {
namespace {

/// So that no straight wall is cut at the line's ends.
void begin_at_corner(std::vector<PlanPoint>& line) {
  line.pop_back();
  const std::size_t n = line.size();
  for (std::size_t i = 0; i < n; ++i)
    if (distance_to_segment_mm(line[i], line[(i + n - 1) % n], line[(i + 1) % n]) > kStraight_mm) {
      std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(i), line.end());
      break;
    }
  line.push_back(line.front());
}

}  // namespace

std::vector<std::vector<PlanPoint>> joined_lines(const std::vector<std::pair<PlanPoint, PlanPoint>>& edges) {
  std::map<PlanPoint, std::vector<std::size_t>> from, to;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    from[edges[i].first].push_back(i);
    to[edges[i].second].push_back(i);
  }
  const auto goes_on = [&](PlanPoint p) {
    const auto out = from.find(p), in = to.find(p);
    return out != from.end() && in != to.end() && out->second.size() == 1 && in->second.size() == 1;
  };
  std::vector<std::vector<PlanPoint>> lines;
  std::vector<bool> is_used(edges.size());
  const auto walk = [&](std::size_t first) {
    std::vector<PlanPoint> line{edges[first].first};
    for (std::size_t i = first;;) {
      is_used[i] = true;
      line.push_back(edges[i].second);
      if (!goes_on(edges[i].second)) break;
      i = from.at(edges[i].second).front();
      if (is_used[i]) break;
    }
    lines.push_back(std::move(line));
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (!goes_on(edges[i].first)) walk(i);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (!is_used[i]) {
      walk(i);
      begin_at_corner(lines.back());
    }
  return lines;
}

}  // namespace vicus
