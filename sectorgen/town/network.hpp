#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sectorgen/town/osm_map.hpp"
#include "sectorgen/town/plane.hpp"

/// The town's streets as a planar subdivision: convex faces, cut again and again by straight lines; each line is one
/// street. Bent afterwards as a whole (bend_network), so that it stays planar.
namespace vicus::town {

enum class StreetKind { border, lane, street, main, ring, avenue, embankment };

struct Line {
  StreetKind kind = StreetKind::street;
  double half_width = 4;  ///< centre line to facade, m
  std::string name;
  bool has_wall = false;  ///< the town wall stands along its left side
  bool is_steps = false;  ///< a lane of steps
  Vec from, to;           ///< before bending
};

/// A node put on an edge later: where a passage or path joins the street, or where a gatehouse begins.
struct Junction {
  double at = 0;  ///< length along Edge::centre
  NodeId node = 0;
  bool is_gatehouse = false;  ///< between two of these the street is a building passage
};

struct Edge {
  std::size_t from = 0, to = 0, line = 0;
  std::size_t left = kNoFace, right = kNoFace;
  Polyline centre;  ///< bent; from `from` to `to`
  std::vector<Junction> junctions;
  bool is_kept = false;  ///< drawn as a street
  static constexpr std::size_t kNoFace = static_cast<std::size_t>(-1);
};

struct HalfEdge {
  std::size_t edge = 0;
  bool is_forward = true;
};

enum class Zone { core, rim };
enum class Use { open, market, second_square, square, park, palace, rows, detached };

struct Face {
  std::vector<HalfEdge> ring;  ///< counter-clockwise, convex; T-junctions of the far side are vertices too
  Zone zone = Zone::core;
  Use use = Use::open;
  bool is_final = false;  ///< not to be cut again
};

struct Network {
  std::vector<Vec> vertices, straight;  ///< straight: before bending
  std::vector<Line> lines;
  std::vector<Edge> edges;
  std::vector<Face> faces;

  std::size_t start_of(HalfEdge h) const { return h.is_forward ? edges[h.edge].from : edges[h.edge].to; }
  Ring ring_of(std::size_t face) const;
};

/// The first face: a convex ring, counter-clockwise; line_of[i] is the line of the side from ring[i].
Network make_network(const Ring& ring, const std::vector<Line>& lines);

struct CutRules {
  double snap = 0;       ///< take a T-junction this near: a crossroads comes about
  double clear = 0;      ///< else no vertex may be nearer than this
  double min_sine = 0;   ///< of the angle with the streets it meets
  double min_width = 0;  ///< of both faces that come about
};

/// Cuts a face by the line through `at`; false, and nothing changes, when a rule forbids it or the line misses.
/// On success the face keeps what lies to the left of `along`, the new last face what lies to the right.
bool cut_face(Network& network, std::size_t face, Vec at, Vec along, const Line& line, const CutRules& rules);

/// Gives every edge its centre line through the bending of the plane: smooth, |displacement| about `amplitude`.
class Bend {
 public:
  Bend(double amplitude, std::uint64_t seed);
  Vec operator()(Vec p) const;

 private:
  struct Wave {
    Vec towards, shift;
    double phase;
  };
  std::vector<Wave> waves_;
};
void bend_network(Network& network, const Bend& bend);

/// Puts a node on the face's street of that line, at the place nearest to p.
NodeId join_street(Network& network, OsmMap& map, std::size_t face, std::size_t line, Vec p);

}  // namespace vicus::town
