#pragma once
#include <vector>

#include "city_db/rules_edges.hpp"

/// The plane cut along every ring edge: are the rings noded, which faces are there, and what covers each.
namespace vicus::rules {

/// Two edges that share more than an end point.
struct NodingFault {
  std::uint32_t edge = 0, other = 0;  ///< edge < other
  PlanPoint at;                       ///< the vertex inside an edge, or the lower end of a crossing edge
};

/// Every pair of ring edges that cross properly, or of which one has an end inside the other. Exact.
/// Cost    near linear: a grid of cells as large as the edges.
std::vector<NodingFault> noding_faults(const EdgeTable& table);

/// Per edge what lies on its left and right; face ids are dense, 0 is the unbounded face.
struct Plane {
  bool is_noded = false;
  std::vector<Cover> left, right;
  // only if noded:
  std::vector<std::uint32_t> left_face, right_face;  ///< of edges without a ring: 0
  std::vector<Cover> face_covers;
  std::vector<Int128> face_twice_mm2;  ///< exact; of face 0: less the whole drawn area
};

/// One sweep from west to east over edges that do not cross: the order of the edges above a vertex never changes, so
/// cover and face of each are known from its lower neighbour when it enters.
/// Needs   noding_faults(table) is empty.
Plane plane_of_faces(const EdgeTable& table);

/// What the rings along each edge say about its sides; all that can be said when rings cross.
Plane plane_of_rings(const EdgeTable& table);

}  // namespace vicus::rules
