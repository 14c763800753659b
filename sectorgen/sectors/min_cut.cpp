#include "sectorgen/sectors/min_cut.hpp"

#include <algorithm>
#include <cassert>

namespace vicus {

void MinCut::add_arc(std::uint32_t a, std::uint32_t b, std::int64_t capacity) {
  arcs_.push_back({b, first_[a], capacity});
  first_[a] = static_cast<std::int32_t>(arcs_.size()) - 1;
}

void MinCut::join(std::uint32_t a, std::uint32_t b, std::int64_t cost) {
  assert(cost > 0 && a != b);
  add_arc(a, b, cost);
  add_arc(b, a, cost);
}

bool MinCut::find_levels(std::uint32_t source, std::uint32_t sink) {
  level_.assign(first_.size(), -1);
  level_[source] = 0;
  std::vector<std::uint32_t> queue{source};
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (std::int32_t e = first_[queue[i]]; e >= 0; e = arcs_[static_cast<std::size_t>(e)].next) {
      const Arc& arc = arcs_[static_cast<std::size_t>(e)];
      if (arc.left == 0 || level_[arc.to] >= 0) continue;
      level_[arc.to] = level_[queue[i]] + 1;
      queue.push_back(arc.to);
    }
  return level_[sink] >= 0;
}

/// One path along rising levels, by an explicit stack: meshes are deep.
std::int64_t MinCut::push(std::uint32_t source, std::uint32_t sink) {
  std::vector<std::int32_t> path;
  std::uint32_t node = source;
  while (node != sink) {
    std::int32_t& e = current_[node];
    while (e >= 0) {
      const Arc& arc = arcs_[static_cast<std::size_t>(e)];
      if (arc.left > 0 && level_[arc.to] == level_[node] + 1) break;
      e = arc.next;
    }
    if (e >= 0) {
      path.push_back(e);
      node = arcs_[static_cast<std::size_t>(e)].to;
      continue;
    }
    if (path.empty()) return 0;
    const std::int32_t back = path.back();
    path.pop_back();
    node = arcs_[static_cast<std::size_t>(back ^ 1)].to;
    current_[node] = arcs_[static_cast<std::size_t>(back)].next;  // a dead end
  }
  std::int64_t flow = INT64_MAX;
  for (std::int32_t e : path) flow = std::min(flow, arcs_[static_cast<std::size_t>(e)].left);
  for (std::int32_t e : path) {
    arcs_[static_cast<std::size_t>(e)].left -= flow;
    arcs_[static_cast<std::size_t>(e ^ 1)].left += flow;
  }
  return flow;
}

std::vector<char> MinCut::source_side(const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& to,
                                      std::int64_t limit) {
  const std::size_t nodes = first_.size();
  const auto source = static_cast<std::uint32_t>(nodes), sink = source + 1;
  first_.resize(nodes + 2, -1);
  const auto tie = [&](std::uint32_t a, std::uint32_t b) {
    add_arc(a, b, limit);
    add_arc(b, a, 0);
  };
  for (std::uint32_t i : from) tie(source, i);
  for (std::uint32_t i : to) tie(i, sink);
  std::int64_t cost = 0;
  while (find_levels(source, sink)) {
    current_ = first_;
    while (const std::int64_t flow = push(source, sink)) {
      cost += flow;
      if (cost >= limit) return {};
    }
  }
  std::vector<char> side(nodes);
  for (std::size_t i = 0; i < nodes; ++i) side[i] = level_[i] >= 0;
  return side;
}

}  // namespace vicus
