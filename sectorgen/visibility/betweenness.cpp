#include "sectorgen/visibility/betweenness.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <random>

namespace vicus {
namespace {

/// Neighbours of node i: ends[starts[i]] ... ends[starts[i + 1] - 1].
struct Adjacency {
  std::vector<std::uint32_t> starts, ends;

  explicit Adjacency(const Graph& graph) : starts(graph.nodes + 1, 0) {
    for (const auto& [a, b] : graph.edges) {
      assert(a < graph.nodes && b < graph.nodes && a != b);
      ++starts[a + 1];
      ++starts[b + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    ends.resize(starts.back());
    auto next = starts;
    for (const auto& [a, b] : graph.edges) {
      ends[next[a]++] = b;
      ends[next[b]++] = a;
    }
  }
};

/// One breadth-first search, and what it adds to each node's sum.
class Sweep {
 public:
  explicit Sweep(std::size_t nodes) : depth_(nodes), ways_(nodes), share_(nodes) { order_.reserve(nodes); }

  void add_from(std::uint32_t source, const Adjacency& adjacency, std::vector<double>& sums) {
    constexpr std::uint32_t kUnseen = 0xffffffffu;
    std::fill(depth_.begin(), depth_.end(), kUnseen);
    order_.assign(1, source);
    depth_[source] = 0;
    ways_[source] = 1;
    for (std::size_t head = 0; head < order_.size(); ++head) {
      const auto node = order_[head];
      share_[node] = 0;
      for (auto e = adjacency.starts[node]; e < adjacency.starts[node + 1]; ++e) {
        const auto other = adjacency.ends[e];
        if (depth_[other] == kUnseen) {
          depth_[other] = depth_[node] + 1;
          ways_[other] = 0;
          order_.push_back(other);
        }
        if (depth_[other] == depth_[node] + 1) ways_[other] += ways_[node];
      }
    }
    for (auto i = order_.size(); i-- > 1;) {
      const auto node = order_[i];
      for (auto e = adjacency.starts[node]; e < adjacency.starts[node + 1]; ++e) {
        const auto before = adjacency.ends[e];
        if (depth_[before] + 1 == depth_[node]) share_[before] += ways_[before] / ways_[node] * (1 + share_[node]);
      }
      sums[node] += share_[node];
    }
  }

 private:
  std::vector<std::uint32_t> depth_, order_;
  std::vector<double> ways_, share_;  // of shortest ways from the source; what depends on the node
};

/// All nodes, or some of them drawn without return.
std::vector<std::uint32_t> sources_of(std::size_t nodes, std::size_t most) {
  std::vector<std::uint32_t> sources(nodes);
  std::iota(sources.begin(), sources.end(), 0u);
  if (nodes <= most) return sources;
  std::mt19937 random(20010217);  // its numbers are the same everywhere, std::shuffle's use of them is not
  for (std::size_t i = 0; i < most; ++i) std::swap(sources[i], sources[i + random() % (nodes - i)]);
  sources.resize(most);
  std::sort(sources.begin(), sources.end());
  return sources;
}

}  // namespace

std::vector<double> betweenness(const Graph& graph, std::size_t most_sources) {
  const Adjacency adjacency(graph);
  const auto sources = sources_of(graph.nodes, most_sources);
  std::vector<double> sums(graph.nodes, 0.0);
  Sweep sweep(graph.nodes);
  for (const auto source : sources) sweep.add_from(source, adjacency, sums);
  // Each pair was met from both of its ends.
  const double scale = sources.empty() ? 0 : static_cast<double>(graph.nodes) / static_cast<double>(sources.size()) / 2;
  for (auto& sum : sums) sum *= scale;
  return sums;
}

}  // namespace vicus
