#pragma once
#include <cstdint>
#include <vector>

/// The cheapest way to part a graph in two.
namespace vicus {

class MinCut {
 public:
  explicit MinCut(std::size_t nodes) : first_(nodes, -1) {}

  /// An undirected edge.   Needs  cost > 0; every edge once.
  void join(std::uint32_t a, std::uint32_t b, std::int64_t cost);

  /// Marks the nodes on `from`'s side of the cheapest cut between the two sets, of all cheapest cuts the one nearest to
  /// `from` (so the result does not depend on the order of edges); empty when every cut costs `limit` or more.
  /// Needs   sets disjoint and not empty; called once.   Error  none: integers.   Cost  nodes^2 edges at worst, near
  /// linear on meshes.   Source  Dinic, Soviet Math. Doklady 11 (1970).
  std::vector<char> source_side(const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& to,
                                std::int64_t limit);

 private:
  struct Arc {
    std::uint32_t to;
    std::int32_t next;  // of the same node; -1: none
    std::int64_t left;  // capacity
  };
  bool find_levels(std::uint32_t source, std::uint32_t sink);
  std::int64_t push(std::uint32_t source, std::uint32_t sink);
  void add_arc(std::uint32_t a, std::uint32_t b, std::int64_t capacity);

  std::vector<std::int32_t> first_;  // arc of each node; arcs come in pairs, i ^ 1 is the twin
  std::vector<Arc> arcs_;
  std::vector<std::int32_t> level_, current_;
};

}  // namespace vicus
