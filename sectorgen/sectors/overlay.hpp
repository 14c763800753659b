#pragma once
#include <vector>

#include "city_db/city.hpp"

/// Plan operations that make new points, by GEOS, before noding: what they construct is rounded to the lattice, and
/// sectorgen/geom/noding.hpp makes it consistent with its neighbours. Nothing after noding may call these, but what
/// is noded again by itself (models/ground_mesh).
///
/// Frame   plan lattice in and out.   Error  0.71 mm (rounding).
/// Fails   never: a result that GEOS cannot make is empty.
namespace vicus {

using Line = std::vector<PlanPoint>;

struct Stroke {
  Line line;
  double radius_m = 1;
};

/// Union of the strokes' outlines. Flat caps end at the line's ends, square ones a radius later; round otherwise.
enum class Cap { round, flat, square };
std::vector<Polygon> stroke_outlines(const std::vector<Stroke>& strokes, Cap cap);

/// `area` less the strokes' outlines: subtract(area, stroke_outlines(strokes, cap)), but only those near it are made.
std::vector<Polygon> keep_off(const std::vector<Polygon>& area, const std::vector<Stroke>& strokes, Cap cap);

/// Outlines grown, then shrunk (closing), so that gaps narrower than twice the distance fill.
std::vector<Polygon> close_gaps(const std::vector<Polygon>& polygons, double distance_m);

/// Grown by `distance_m`, or shrunk where it is negative; corners mitred, or rounded in steps of 45 degrees.
std::vector<Polygon> offset(const std::vector<Polygon>& polygons, double distance_m, bool is_rounded);

std::vector<Polygon> subtract(const Polygon& from, const std::vector<Polygon>& what);
std::vector<Polygon> subtract(const std::vector<Polygon>& from, const std::vector<Polygon>& what);
std::vector<Polygon> intersect(const Polygon& a, const std::vector<Polygon>& b);
std::vector<Polygon> intersect(const std::vector<Polygon>& a, const std::vector<Polygon>& b);
std::vector<Polygon> unite(const std::vector<Polygon>& polygons);

/// Douglas-Peucker, keeps the ends.
Line simplify(const Line& line, double tolerance_m);

}  // namespace vicus
