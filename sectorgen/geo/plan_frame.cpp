#include "sectorgen/geo/plan_frame.hpp"

#include <GeographicLib/TransverseMercator.hpp>
#include <cassert>
#include <cmath>

namespace vicus {

namespace {

// A point farther than this from the central meridian lies beyond the lattice anyway, and the projection's series
// would no longer converge there.
constexpr double kMaxLonDifferenceDeg = 80;

}  // namespace

struct PlanFrame::Projection {
  LatLon origin;
  GeographicLib::TransverseMercator mercator{GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(),
                                             1.0};
  double origin_east = 0, origin_north = 0;

  explicit Projection(LatLon at) : origin(at) {
    mercator.Forward(origin.lon_deg, origin.lat_deg, origin.lon_deg, origin_east, origin_north);
  }
};

PlanFrame::PlanFrame(LatLon origin) {
  assert(std::abs(origin.lat_deg) <= 90 && std::abs(origin.lon_deg) <= 360);
  origin.lon_deg = unwrapped_lon(origin.lon_deg, 0);
  projection_ = std::make_unique<Projection>(origin);
}

PlanFrame::~PlanFrame() = default;
PlanFrame::PlanFrame(PlanFrame&&) noexcept = default;
PlanFrame& PlanFrame::operator=(PlanFrame&&) noexcept = default;

LatLon PlanFrame::origin() const { return projection_->origin; }

std::optional<PlanPoint> PlanFrame::plan_from_latlon(LatLon position) const {
  const Projection& p = *projection_;
  if (!(std::abs(position.lat_deg) <= 90) || !std::isfinite(position.lon_deg)) return std::nullopt;
  const double lon = unwrapped_lon(position.lon_deg, p.origin.lon_deg);
  // Near a pole every meridian is close; elsewhere such a difference is out of reach.
  if (std::abs(lon - p.origin.lon_deg) > kMaxLonDifferenceDeg && std::abs(position.lat_deg) < 80) return std::nullopt;
  double east = 0, north = 0;
  p.mercator.Forward(p.origin.lon_deg, position.lat_deg, lon, east, north);
  east -= p.origin_east;
  north -= p.origin_north;
  constexpr double kReach = (kPlanLimit - 1) / kMmPerMetre;
  if (!(std::abs(east) < kReach && std::abs(north) < kReach)) return std::nullopt;
  return PlanPoint{lattice_mm(east), lattice_mm(north)};
}

LatLon PlanFrame::latlon_from_plan(PlanPoint point) const {
  const Projection& p = *projection_;
  LatLon position;
  p.mercator.Reverse(p.origin.lon_deg, metres(point.x) + p.origin_east, metres(point.y) + p.origin_north,
                     position.lat_deg, position.lon_deg);
  return position;
}

double unwrapped_lon(double lon_deg, double near_lon_deg) {
  const double difference = lon_deg - near_lon_deg;
  if (difference >= -180 && difference <= 180) return lon_deg;
  return near_lon_deg + std::remainder(difference, 360.0);
}

}  // namespace vicus
