#include "x3d_export/earth_frame.hpp"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace vicus {

std::array<double, 3> Placement::operator()(const std::array<double, 3>& p) const {
  std::array<double, 3> out = columns[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 3; ++i) out[i] += columns[axis][i] * p[axis];
  return out;
}

Placement earth_from_plan(LatLon origin, PlanPoint at, double height_m) {
  using namespace GeographicLib;
  const TransverseMercator mercator(Constants::WGS84_a(), Constants::WGS84_f(), 1.0);
  double x0 = 0, y0 = 0, lat = 0, lon = 0, convergence = 0, scale = 1;
  mercator.Forward(origin.lon_deg, origin.lat_deg, origin.lon_deg, x0, y0);
  mercator.Reverse(origin.lon_deg, x0 + metres(at.x), y0 + metres(at.y), lat, lon, convergence, scale);
  Placement out;
  std::vector<double> m(9);  // rows: earth axes; columns: east, north, up
  Geocentric::WGS84().Forward(lat, lon, height_m, out.columns[3][0], out.columns[3][1], out.columns[3][2], m);
  const double turn = convergence * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
  for (std::size_t i = 0; i < 3; ++i) {
    const double east = m[3 * i], north = m[3 * i + 1];
    out.columns[0][i] = c * east - s * north;  // plan north has the bearing `convergence`
    out.columns[1][i] = c * north + s * east;
    out.columns[2][i] = m[3 * i + 2];
  }
  return out;
}

Placement relative(const Placement& a, const Placement& b) {
  const auto turned_back = [&](const std::array<double, 3>& v) {
    std::array<double, 3> out{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < 3; ++i) out[axis] += b.columns[axis][i] * v[i];
    return out;
  };
  Placement out;
  for (std::size_t axis = 0; axis < 3; ++axis) out.columns[axis] = turned_back(a.columns[axis]);
  std::array<double, 3> shift{};
  for (std::size_t i = 0; i < 3; ++i) shift[i] = a.columns[3][i] - b.columns[3][i];
  out.columns[3] = turned_back(shift);
  return out;
}

}  // namespace vicus
