#pragma once
#include <cstdint>
#include <vector>

#include "city_db/boxes.hpp"
#include "city_db/city.hpp"
#include "sectorgen/geom/predicates.hpp"

/// Rings and polygons on the lattice.
namespace vicus {

enum class Side { outside, boundary, inside };

/// Twice the signed area in mm2, > 0 for counter-clockwise.   Error  none.
Int128 area2(const Ring& ring);
Int128 area2(const Polygon& polygon);  ///< outer less holes
double area_m2(const Polygon& polygon);

/// Exact; even-odd over all rings.
Side locate(const Polygon& polygon, PlanPoint p);

/// Metres of the segment inside the polygon, and the middle of the longest piece inside (rounded).
double inside_length_m(PlanPoint a, PlanPoint b, const Polygon& polygon, PlanPoint& middle);
/// Metres of a closed ring.
double perimeter_m(const Ring& ring);

/// Convex hull, counter-clockwise, no collinear points (Andrew's monotone chain).
Ring convex_hull(std::vector<PlanPoint> points);
/// Largest distance of two points of a convex ring, metres.
double diameter_m(const Ring& hull);

/// A walk along a boundary (inside on the left) that may pass a vertex or an edge several times, taken apart into
/// simple rings: counter-clockwise ones are outer, clockwise ones holes. Edges walked both ways cancel.
std::vector<Ring> simple_rings(const Ring& walk);

/// The same for all walks of one polygon: rounding may have laid a hole's edge on the outer ring, or on another hole's.
std::vector<Ring> simple_rings(const std::vector<Ring>& walks);

/// Polygons from simple rings: every hole goes to the smallest outer ring around it. Order: by smallest vertex.
std::vector<Polygon> assemble(std::vector<Ring> rings);

/// Rotates the ring so that it begins at its smallest point: equal rings get equal bytes.
void canonicalise(Ring& ring);

/// Counter-clockwise triangles of a valid polygon (holes may touch the outer ring in points), as city_db's Triangles.
/// Cocircular ties are broken by coordinates.
Triangles triangulate(const Polygon& polygon);

}  // namespace vicus
