#pragma once
#include "sectorgen/geom/polygon.hpp"

/// Exact facts about rings and polygons on the lattice, in integers.
namespace vicus {

/// Without consecutive equal points, the last against the first too.
Ring without_repeats(const Ring& ring);
/// Outer counter-clockwise, holes clockwise.
void orient_rings(Polygon& polygon);

Side side_of(PlanPoint point, const Ring& ring);

/// True where no edge touches another but its neighbour in their common point, every hole lies in the outer ring, and
/// none in another hole. Stricter than OGC validity, where two rings may touch in a point: false says "look closer".
/// Cost  edges are swept by x: near linear for houses.
bool is_strictly_simple(const Polygon& polygon);

}  // namespace vicus
