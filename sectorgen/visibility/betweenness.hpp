#pragma once
#include <cstdint>
#include <utility>
#include <vector>

/// How often a node lies on the shortest ways between others.
namespace vicus {

/// Undirected; no edge twice, none from a node to itself.
struct Graph {
  std::size_t nodes = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
};

/// Sum over all pairs {s, t} of other nodes of the share of the shortest ways from s to t, counted in edges, that pass
/// through the node. From more than `most_sources` nodes it is estimated: that many sources, drawn with a fixed seed.
///
/// Error   exact up to rounding for nodes <= most_sources; else unbiased.
/// Cost    O(sources * (nodes + edges)).
/// Source  Brandes, A Faster Algorithm for Betweenness Centrality, J. Math. Sociology 25(2), 2001.
std::vector<double> betweenness(const Graph& graph, std::size_t most_sources);

}  // namespace vicus
