#pragma once
#include <memory>
#include <optional>

#include "city_db/units.hpp"

/// WGS84 degrees <-> plan lattice: the only place that knows the map projection.
///
/// Frame   transverse Mercator on the WGS84 ellipsoid, central meridian and false origin at the city's origin, scale 1.
/// Error   plan -> degrees -> plan gives the same point; degrees -> plan -> degrees moves a point by at most 0.71 mm
///         (half a lattice diagonal), anywhere within 50 km of the origin.
/// Source  Karney, Transverse Mercator with an accuracy of a few nanometers, J. Geodesy 85(8), 2011.
namespace vicus {

class PlanFrame {
 public:
  /// Needs   |lat| <= 90, |lon| <= 360 (wrapped).
  explicit PlanFrame(LatLon origin);
  ~PlanFrame();
  PlanFrame(PlanFrame&&) noexcept;
  PlanFrame& operator=(PlanFrame&&) noexcept;

  LatLon origin() const;
  /// Nearest lattice point; nothing where the lattice does not reach (about 1,073 km) or the position is no number.
  std::optional<PlanPoint> plan_from_latlon(LatLon position) const;
  /// Longitude in [-180, 180].
  LatLon latlon_from_plan(PlanPoint point) const;

 private:
  struct Projection;
  std::unique_ptr<const Projection> projection_;
};

/// The longitude, moved by whole turns, that is nearest to `near_lon_deg`: keeps a city across 180 degrees in one
/// piece.
double unwrapped_lon(double lon_deg, double near_lon_deg);

}  // namespace vicus
