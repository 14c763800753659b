#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "sectorgen/sectors/tours/sight_graph.hpp"

/// The shortest way along the graph of corners, looked for from both ends.
namespace vicus {

/// Where a walk begins or ends.
struct WalkEnd {
  PlanPoint at;
  bool is_whole = true;                            ///< the ground there is one piece, so walks may lead over it
  std::vector<std::uint32_t> seen;                 ///< nodes that a straight walk from there touches
  std::array<double, kLandmarks> from_landmark{};  ///< mm; infinite where there is none
};

/// Keeps its tables between calls. One per thread.
///
/// Exact   lower bounds (straight line, landmarks) never exceed the walk still to go and are consistent: from node to
///         node they sink by no more than the edge is long.
/// Source  NBA*: Pijls & Post, "Yet another bidirectional algorithm for finding the shortest path", Erasmus University
///         Rotterdam, EI 2009-10. Either side follows a node that the other did not; it turns back where what is left
///         to the other end, by what the other side has ruled out so far, makes the walk longer than one known.
class WalkSearch {
 public:
  explicit WalkSearch(const SightGraph& graph) : graph_(graph), nodes_(graph.point.size()) {}

  void begin();  ///< before let_in and find, each time
  /// The node may be passed although all its ground is in blind alleys: the walk begins or ends in there.
  void let_in(std::uint32_t node) { nodes_[node].let_in = query_; }
  /// The nodes in order; empty: no way.
  std::vector<std::uint32_t> find(const WalkEnd& from, const WalkEnd& to);
  std::uint64_t steps() const { return steps_; }  ///< edges followed by the last find

 private:
  /// A node as one side has reached it. Of an earlier query than query_: nothing.
  struct Label {
    std::uint32_t query = 0, before = kNone;
    double mm = 0;       ///< from that side's end
    double rest_mm = 0;  ///< at least so far to the other end
    double whole() const { return mm + rest_mm; }
  };
  struct alignas(64) Node {
    std::array<Label, 2> of;
    std::uint32_t followed = 0;  ///< the query in which a side has followed it on
    std::uint32_t let_in = 0;
  };
  struct Side {
    const WalkEnd *end = nullptr, *goal = nullptr;
    std::vector<std::pair<double, std::uint32_t>> queue;  ///< -whole(), node; what is out of date stays in
    double least_mm = 0;                                  ///< of a whole walk over any node not followed yet
  };
  bool is_shut(std::uint32_t node) const { return graph_.corner[node].is_blind && nodes_[node].let_in != query_; }
  double rest(const Side& side, std::uint32_t node) const;
  void reach(std::size_t s, std::uint32_t node, double mm, std::uint32_t before);
  bool advance(std::size_t s);
  void follow(std::size_t s, std::uint32_t node);

  const SightGraph& graph_;
  std::vector<Node> nodes_;
  std::array<Side, 2> side_;
  std::uint32_t query_ = 0, meeting_ = kNone;
  double best_mm_ = 0;  // of a whole walk, over meeting_
  std::uint64_t steps_ = 0;
};

}  // namespace vicus
