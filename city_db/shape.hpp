#pragma once
#include <cstddef>

#include "city_db/city.hpp"

/// Figures of how well a city was cut (end of DESIGN §3): judged, not proved, so in doubles.
namespace vicus {

/// Percentiles interpolate linearly between the two nearest ranks. All 0 when `count` is 0.
struct Spread {
  std::size_t count = 0;
  double median = 0, p05 = 0, p95 = 0, mean = 0;
};
Spread spread_of(std::vector<double> values);

/// Figures over one choice of sectors.
struct SectorFigures {
  Spread gates_per_sector;       ///< gates out of the city are not counted
  Spread convexity;              ///< ground area / area of its convex hull
  double convexity_by_area = 0;  ///< the same, each sector weighted by its area
  Spread sector_length_m;        ///< diameter of the ground
};

/// How much of the named streets' centre lines, inside of W, lies in a sector that bears the street's name.
/// A *core* is a sector of kind crossroads or square, or what is nearer to a crossing with a street of another name
/// than that crossing's street width.
struct NamedStreets {
  double length_m = 0;  ///< in W
  double outside_cores_m = 0;
  double share = 0;            ///< outside of cores: the figure DESIGN §3 aims at
  double share_strict = 0;     ///< all of W; a sector bears only `name`
  double share_all_names = 0;  ///< all of W; a sector bears all of `names`
  Spread by_street;            ///< `share`, street by street
};

struct ShapeReport {
  /// Street, crossroads and square sectors, and of their gates those of kind street and passage.
  SectorFigures streets;
  /// All sectors, all gates.
  SectorFigures all;
  /// Straight distance between the ends of a gate / street width there, which is twice the clearance of the gate's
  /// middle to the nearest edge that stops a walker (houses, walls, water, islands). Each pair of twins once.
  Spread gate_width_ratio;  ///< gates of kind street and passage
  Spread yard_gate_width_ratio, kerb_gate_width_ratio;
  NamedStreets named_streets;
};

/// Needs   a city whose rules 1 and 2 hold; of others the figures mean little, but nothing fails.
/// Cost    O(n log n) in ground edges, plus the cells that each street and gate passes.
ShapeReport measure_shape(const City& city);

}  // namespace vicus
