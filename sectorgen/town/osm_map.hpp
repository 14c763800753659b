#pragma once
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sectorgen/town/plane.hpp"

/// The map being drawn: OSM nodes, ways and relations.
namespace vicus::town {

using Tags = std::vector<std::pair<std::string, std::string>>;
using NodeId = std::uint32_t;  ///< from 1

struct OsmNode {
  std::int32_t lat, lon;  ///< 1e-7 degrees
  std::uint32_t tags;     ///< index into OsmMap's tag lists; 0: none
};
struct OsmWay {
  std::vector<NodeId> nodes;
  Tags tags;
};
struct OsmMember {
  char kind;  ///< 'n' or 'w'
  std::uint32_t ref;
  const char* role;
};
struct OsmRelation {
  std::vector<OsmMember> members;
  Tags tags;
};

/// Invariant: every way and member refers to what exists; coordinates are legal (longitudes wrap at 180 degrees).
class OsmMap {
 public:
  OsmMap(double lat_deg, double lon_deg);

  /// The node at this place, made at the first call: equal places share one node.
  NodeId node(Vec at);
  /// A node of its own, even where another stands. The shift is in steps of 1e-7 degrees east.
  NodeId separate_node(Vec at, int steps_east = 0);
  NodeId point(Vec at, Tags tags);
  void tag_node(NodeId id, Tags tags);
  /// Consecutive equal nodes are dropped.
  std::uint32_t way(std::vector<NodeId> nodes, Tags tags);
  std::uint32_t closed_way(std::vector<NodeId> nodes, Tags tags);
  void relation(std::vector<OsmMember> members, Tags tags);
  std::vector<NodeId> nodes_of(const Polyline& line);

  std::string xml() const;
  std::size_t node_count() const { return nodes_.size(); }
  std::size_t way_count() const { return ways_.size(); }
  std::size_t relation_count() const { return relations_.size(); }

 private:
  std::pair<std::int32_t, std::int32_t> place(Vec at) const;
  double lat_deg_, lon_deg_, metres_per_lon_deg_;
  std::vector<OsmNode> nodes_;
  std::vector<OsmWay> ways_;
  std::vector<OsmRelation> relations_;
  std::vector<Tags> tags_{{}};
  std::unordered_map<std::uint64_t, NodeId> at_;
};

}  // namespace vicus::town
