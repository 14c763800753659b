#pragma once
#include <cmath>
#include <vector>

#include "city_db/city.hpp"

/// Roofs as sight over them needs them: heights in plan, and the edges that are seen first.
namespace vicus {

/// Plan frame, metres, doubles: for lengths and slopes, where lattice points do not suffice.
struct Spot {
  double x = 0, y = 0;
};
inline Spot spot_of(PlanPoint p) { return {metres(p.x), metres(p.y)}; }
/// Metres neither overflow nor vanish: what std::hypot guards against costs it ten times as much.
inline double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// A stretch of a line p -> q, as shares of its length; from > to: nothing of it.
struct Stretch {
  double from = 1, to = 0;
};

/// A part of a roof, seen from above. Heights above the house's own 0.
class RoofTriangle {
 public:
  /// Needs   corners counter-clockwise in plan.
  RoofTriangle(const RoofPoint& a, const RoofPoint& b, const RoofPoint& c);

  /// No point of it within `reach` of x is lower. Above all heights where none is so near.
  double least_within(Spot x, double reach) const;
  /// The stretch of p -> q over it.
  Stretch stretch(Spot p, Spot q) const;
  double height_at(Spot x) const { return up_ + slope_.x * (x.x - at_.x) + slope_.y * (x.y - at_.y); }
  double least_m() const { return least_m_; }
  double most_m() const { return most_m_; }
  Spot low_corner() const { return low_; }
  Spot high_corner() const { return high_; }

 private:
  Spot at_, slope_, low_, high_;  // low_, high_: its box in plan
  double up_ = 0, steepness_ = 0, least_m_ = 0, most_m_ = 0;
  Spot normal_[3];  // of its sides, inwards; a point is inside where all distances are positive
  double offset_[3] = {0, 0, 0};
};

/// The triangles that cover the footprint; none where the roof is missing, does not cover it, or does
/// not stand between the house's eave and its height.
///
/// Error   upright facets are left out, and what rounding to the lattice makes of them: slits less than 2 mm wide.
std::vector<RoofTriangle> roof_triangles(const Building& building);

/// A straight edge of a roof, or of a flat cover at its height.
struct RoofEdge {
  Spot a, b;
  double up_a = 0, up_b = 0;
};

/// Whoever sees some point of the roof's facets sees some point of these edges: on the way up the facet, seen from
/// above its plane, points rise in the eye until an edge. So is it for a gable, upwards. With `from_above_too` false
/// only for eyes below the eave: then edges at the eave are left out.
/// Without triangles the house counts as covered flat at its height: the footprint's edges there.
std::vector<RoofEdge> roof_edges(const Building& building, bool has_triangles, bool from_above_too);

}  // namespace vicus
