#pragma once
#include "city_db/city.hpp"

/// Triangles for cities made by hand. Slow and obvious on purpose; the generator has its own.
namespace vicus::test {

/// Ear clipping; holes are joined to the outer ring by bridges first. Uses every point, so no T-vertex arises.
/// Needs   a simple polygon of < 1000 points, outer counter-clockwise, holes clockwise.
/// Cost    O(n^3).
Triangles triangulate(const Polygon& polygon);

}  // namespace vicus::test
