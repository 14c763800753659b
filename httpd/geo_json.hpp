#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// The plan frame as WGS84 longitude and latitude, for maps and GIS (RFC 7946).
///
/// Frame   local transverse Mercator through the city's origin, scale 1 there (DESIGN §2), as sectorgen/geo made it.
/// Error   9 decimals: within 0.1 mm of the lattice point.
/// Differs a city on the antimeridian is not cut there (RFC 7946 §3.1.9): its longitudes run on past 180, so that rings
///         stay whole.
namespace vicus {

/// Degrees; west > east: over the antimeridian.
struct GeoBox {
  double west = 0, south = 0, east = 0, north = 0;
};

/// "W,S,E,N" or "W,S,min,E,N,max". Fails  nullopt: other than 4 or 6 finite numbers, beyond 180 or 90, south > north.
std::optional<GeoBox> parse_geo_box(const std::string& text);

class GeoFrame {
 public:
  explicit GeoFrame(LatLon origin) : origin_(origin) {}

  /// Longitude within 180 degrees of the origin's.
  LatLon lat_lon_from_plan(PlanPoint p) const;
  /// A box that holds every lattice point inside `box`; may be larger. Empty when none is.
  PlanBox plan_box_around(const GeoBox& box) const;
  /// True when the polygon (holes left out) or the line has a point in the closed box.
  bool meets(const Polygon& polygon, const GeoBox& box) const;
  bool meets(const std::vector<PlanPoint>& line, const GeoBox& box) const;

  nlohmann::ordered_json geometry_of(const Polygon& polygon) const;  ///< type Polygon, rings closed
  nlohmann::ordered_json geometry_of(const std::vector<PlanPoint>& line) const;

 private:
  LatLon origin_;
};

}  // namespace vicus
