#include "httpd/geo_json.hpp"

#include <GeographicLib/TransverseMercator.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace vicus {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kReach_deg = 60;     // of longitude from the origin: at 85 degrees north 580 km, a city has < 100
constexpr double kLatReach_deg = 12;  // 1300 km; the lattice reaches 1074
constexpr int kEdgeSteps = 16;        // samples of a box's edge, a curve in plan
constexpr double kMargin = 0.02;      // of the sampled box's size: the curve leaves its samples by less

/// Relative to the origin's meridian, as every comparison here is made.
struct Degrees {
  double lon = 0, lat = 0;
};
struct Window {
  double west, south, east, north;
  bool contains(Degrees p) const { return p.lon >= west && p.lon <= east && p.lat >= south && p.lat <= north; }
};

double within_180(double degrees) { return std::remainder(degrees, 360.0); }
double rounded(double degrees) { return std::round(degrees * 1e9) / 1e9; }

const GeographicLib::TransverseMercator& mercator() {
  static const GeographicLib::TransverseMercator projection(6378137.0, 1 / 298.257223563, 1.0);
  return projection;
}

double northing_of(LatLon origin) {
  double x = 0, y = 0;
  mercator().Forward(origin.lon_deg, origin.lat_deg, origin.lon_deg, x, y);
  return y;
}

/// The box as seen from the origin's meridian, and once more a turn away: a wide box may reach the city both ways.
std::array<Window, 3> windows_of(const GeoBox& box, LatLon origin) {
  const double west = within_180(box.west - origin.lon_deg);
  const double width = box.east >= box.west ? box.east - box.west : box.east - box.west + 360;
  std::array<Window, 3> windows{};
  for (int turn = -1; turn <= 1; ++turn)
    windows[static_cast<std::size_t>(turn + 1)] = {west + 360 * turn, box.south, west + width + 360 * turn, box.north};
  return windows;
}

/// Liang and Barsky: does any point of the segment lie in the closed window?
bool segment_meets(Degrees a, Degrees b, const Window& w) {
  double from = 0, to = 1;
  const auto clip = [&](double step, double room) {
    if (step == 0) return room >= 0;
    const double t = room / step;
    if (step < 0)
      from = std::max(from, t);
    else
      to = std::min(to, t);
    return from <= to;
  };
  return clip(a.lon - b.lon, a.lon - w.west) && clip(b.lon - a.lon, w.east - a.lon) &&
         clip(a.lat - b.lat, a.lat - w.south) && clip(b.lat - a.lat, w.north - a.lat);
}

bool is_inside(Degrees p, const std::vector<Degrees>& ring) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const auto a = ring[i], b = ring[j];
    if ((a.lat > p.lat) != (b.lat > p.lat) && p.lon < (b.lon - a.lon) * (p.lat - a.lat) / (b.lat - a.lat) + a.lon)
      inside = !inside;
  }
  return inside;
}

Json position_of(const GeoFrame& frame, PlanPoint p) {
  const auto at = frame.lat_lon_from_plan(p);
  return Json::array({rounded(at.lon_deg), rounded(at.lat_deg)});
}

Json positions_of(const GeoFrame& frame, const std::vector<PlanPoint>& points, bool closes) {
  Json positions = Json::array();
  for (const auto p : points) positions.push_back(position_of(frame, p));
  if (closes && !points.empty()) positions.push_back(positions.front());
  return positions;
}

}  // namespace

std::optional<GeoBox> parse_geo_box(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    double value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    if (rest == end) break;
    if (*rest != ',' || numbers.size() == 6) return std::nullopt;
    at = rest + 1;
  }
  if (numbers.size() == 6) numbers = {numbers[0], numbers[1], numbers[3], numbers[4]};
  if (numbers.size() != 4) return std::nullopt;
  const GeoBox box{numbers[0], numbers[1], numbers[2], numbers[3]};
  if (std::abs(box.west) > 180 || std::abs(box.east) > 180 || box.south < -90 || box.north > 90 ||
      box.south > box.north)
    return std::nullopt;
  return box;
}

LatLon GeoFrame::lat_lon_from_plan(PlanPoint p) const {
  LatLon at;
  mercator().Reverse(origin_.lon_deg, metres(p.x), metres(p.y) + northing_of(origin_), at.lat_deg, at.lon_deg);
  at.lon_deg = origin_.lon_deg + within_180(at.lon_deg - origin_.lon_deg);
  return at;
}

PlanBox GeoFrame::plan_box_around(const GeoBox& box) const {
  PlanBox out;
  const double northing = northing_of(origin_);
  for (auto window : windows_of(box, origin_)) {
    window.west = std::max(window.west, -kReach_deg);
    window.east = std::min(window.east, kReach_deg);
    window.south = std::max(window.south, origin_.lat_deg - kLatReach_deg);
    window.north = std::min(window.north, origin_.lat_deg + kLatReach_deg);
    if (window.west > window.east || window.south > window.north) continue;
    double min_x = INFINITY, min_y = INFINITY, max_x = -INFINITY, max_y = -INFINITY;
    for (int i = 0; i <= kEdgeSteps; ++i) {
      const double lon = window.west + (window.east - window.west) * i / kEdgeSteps;
      const double lat = window.south + (window.north - window.south) * i / kEdgeSteps;
      for (const auto p : {Degrees{lon, window.south}, Degrees{lon, window.north}, Degrees{window.west, lat},
                           Degrees{window.east, lat}}) {
        double x = 0, y = 0;
        mercator().Forward(0, p.lat, p.lon, x, y);
        min_x = std::min(min_x, x), max_x = std::max(max_x, x);
        min_y = std::min(min_y, y - northing), max_y = std::max(max_y, y - northing);
      }
    }
    const double margin = 1 + kMargin * std::max(max_x - min_x, max_y - min_y);
    const double limit = metres(kPlanLimit);
    if (min_x - margin > limit || max_x + margin < -limit || min_y - margin > limit || max_y + margin < -limit)
      continue;
    out.add({lattice_mm(std::max(min_x - margin, -limit)), lattice_mm(std::max(min_y - margin, -limit))});
    out.add({lattice_mm(std::min(max_x + margin, limit)), lattice_mm(std::min(max_y + margin, limit))});
  }
  return out;
}

bool GeoFrame::meets(const std::vector<PlanPoint>& line, const GeoBox& box) const {
  std::vector<Degrees> points;
  for (const auto p : line) {
    const auto at = lat_lon_from_plan(p);
    points.push_back({at.lon_deg - origin_.lon_deg, at.lat_deg});
  }
  for (const auto& window : windows_of(box, origin_))
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (segment_meets(points[i], points[i + 1], window)) return true;
  return false;
}

bool GeoFrame::meets(const Polygon& polygon, const GeoBox& box) const {
  const auto closed = [](Ring ring) {
    if (!ring.empty()) ring.push_back(ring.front());
    return ring;
  };
  if (meets(closed(polygon.outer), box)) return true;
  for (const auto& hole : polygon.holes)
    if (meets(closed(hole), box)) return true;
  // No edge meets the box: it lies inside, or outside, as a whole.
  std::vector<std::vector<Degrees>> rings;
  const auto add = [&](const Ring& ring) {
    rings.emplace_back();
    for (const auto p : ring) {
      const auto at = lat_lon_from_plan(p);
      rings.back().push_back({at.lon_deg - origin_.lon_deg, at.lat_deg});
    }
  };
  add(polygon.outer);
  for (const auto& hole : polygon.holes) add(hole);
  for (const auto& window : windows_of(box, origin_)) {
    const Degrees corner{window.west, window.south};
    bool inside = is_inside(corner, rings.front());
    for (std::size_t i = 1; i < rings.size() && inside; ++i) inside = !is_inside(corner, rings[i]);
    if (inside) return true;
  }
  return false;
}

Json GeoFrame::geometry_of(const Polygon& polygon) const {
  Json rings = Json::array({positions_of(*this, polygon.outer, true)});
  for (const auto& hole : polygon.holes) rings.push_back(positions_of(*this, hole, true));
  return {{"type", "Polygon"}, {"coordinates", std::move(rings)}};
}

Json GeoFrame::geometry_of(const std::vector<PlanPoint>& line) const {
  return {{"type", "LineString"}, {"coordinates", positions_of(*this, line, false)}};
}

}  // namespace vicus
