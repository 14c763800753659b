#pragma once
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

/// Plane geometry of the town's plan: metres, x = east, y = north. Needs no libm beyond sqrt and floor, which are
/// exact.
namespace vicus::town {

struct Vec {
  double x = 0, y = 0;
  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator*(Vec a, double k) { return {a.x * k, a.y * k}; }
  friend bool operator==(Vec, Vec) = default;
};
using Polyline = std::vector<Vec>;
using Ring = std::vector<Vec>;  ///< without repeating the first point

inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline double distance(Vec a, Vec b) { return length(b - a); }
inline Vec unit(Vec a) {
  const double l = length(a);
  return l > 0 ? a * (1 / l) : Vec{1, 0};
}
inline Vec left_of(Vec a) { return {-a.y, a.x}; }
inline Vec mix(Vec a, Vec b, double t) { return a + (b - a) * t; }

/// Sine of a part of the full turn. Error < 1e-9, equal on every machine.
double sine_of_turn(double turn);
inline Vec direction_of_turn(double turn) { return {sine_of_turn(turn + 0.25), sine_of_turn(turn)}; }

double area_of(const Ring& ring);  ///< positive: counter-clockwise
Vec centroid_of(const Ring& ring);
bool contains(const Ring& ring, Vec p);
double distance_to_segment(Vec p, Vec a, Vec b);
double distance_to_ring(Vec p, const Ring& ring);
/// Inside and at least `margin` from the ring.
bool contains_with_margin(const Ring& ring, Vec p, double margin);
/// Brute force over all pairs of edges: no crossing, no touching but of neighbours.
bool is_simple(const Ring& ring);
bool segments_meet(Vec a, Vec b, Vec c, Vec d);
bool meets_ring(const Ring& ring, Vec a, Vec b);
/// Parameter on a..b (unbounded) where it meets the line c..d; none when parallel.
std::optional<double> meeting_on_line(Vec a, Vec b, Vec c, Vec d);
/// Least extent of a convex ring; `along` is the direction of the side it was measured from.
double width_of_convex(const Ring& ring, Vec& along);

/// Parallel to the left at the given distance, mitred.
Polyline offset_left(const Polyline& line, double by);
double length_of(const Polyline& line);
/// Point at a length along the line; `forward` gets the direction there, smoothed over a few metres.
Vec point_along(const Polyline& line, double at, Vec* forward = nullptr);
/// Rectangle by its centre, its long axis and half sizes; counter-clockwise.
Ring rectangle(Vec centre, Vec along, double half_long, double half_wide);
/// Do two convex rings have a common point (separating axes)?
bool convex_rings_meet(const Ring& a, const Ring& b);

}  // namespace vicus::town
