#pragma once
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// A city as convex cells and the portals between them, for other programs that compute visibility: Quake's PRT1.
///
/// Frame   plan lattice; cells are prisms over the ground of sectors.
/// Exact   cells are made of the sectors' triangles, joined where that stays convex (integer predicates); no vertex is
///         made, moved or lost, so neighbours meet edge by edge.
namespace vicus {

struct ConvexCell {
  std::uint32_t sector = 0;  ///< index into City::sectors
  Ring ring;                 ///< counter-clockwise, convex; may have vertices in the middle of a straight side
};

/// Cell `a` is on the left of from -> to, cell `b` on the right. a != b.
struct Portal {
  std::uint32_t a = 0, b = 0;
  PlanPoint from, to;
};

struct PortalGraph {
  std::vector<ConvexCell> cells;  ///< in the order of the sectors
  std::vector<Portal> portals;    ///< one for each edge common to two cells of a sector, then one for each gate edge
};

/// Inside a sector every edge between two cells is a portal; between sectors only edges of gates are.
/// Fails   CityError: a gate that is not made of ground edges of both its sectors, triangles that are none of their
///         ground (vicus check names what is wrong).
PortalGraph portal_graph(const City& city, bool keeps_triangles);

inline constexpr int kPortalUnits_per_m = 1000;  ///< the lattice itself: every number is whole
inline constexpr int kPortalHeight_m = 3;

/// PRT1: cell and portal counts, then `4 a b (x y z ) (x y z ) (x y z ) (x y z ) `. By the right-hand rule the corners
/// turn about a normal that points from a to b; programs of that line take the opposite turn, so theirs points from b
/// to a, as they expect.
std::string prt_text(const PortalGraph& graph);
/// What PRT1 has no words for: units, counts, and the sector of each cell.
std::string prt_json(const PortalGraph& graph, const City& city);

}  // namespace vicus
