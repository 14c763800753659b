#include "cli/measure_paths.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <random>

#include "city_db/boxes.hpp"
#include "city_db/terrain.hpp"
#include "x3d_export/city_index.hpp"

namespace vicus::measure {
namespace {

constexpr double kAhead_m = 6;                     // a walker looks at where he will be
constexpr double kLeastCircle_m = 200;             // a town smaller than this is flown round
constexpr double kInwards = std::numbers::pi / 3;  // of the flight
constexpr double kRadian = std::numbers::pi / 180;
constexpr int kTries = 24;
constexpr double kMiddleShare = 0.7;  // of the city's box, where a walk may begin and end

PlanBox houses_box(const City& city) {
  PlanBox box;
  for (const Building& house : city.buildings)
    for (const PlanPoint p : house.footprint.outer) box.add(p);
  for (const Sector& sector : city.sectors)
    if (city.buildings.empty())
      for (const PlanPoint p : sector.ground.outer) box.add(p);
  return box;
}

double ground_m(const City& city, double east, double north) {
  return height_m(city.terrain, {lattice_mm(east), lattice_mm(north)});
}

struct Spot {
  double east, north, up;
};

/// The place on the tour; beyond its ends straight on.
Spot spot_at(const Tour& tour, double along_m) {
  const auto& points = tour.points;
  std::size_t i = 1;
  while (i + 1 < points.size() && points[i].walked_m < along_m) ++i;
  const TourPoint &a = points[i - 1], &b = points[i];
  const double share = (along_m - a.walked_m) / std::max(1e-9, b.walked_m - a.walked_m);
  const auto between = [&](double from, double to) { return from + share * (to - from); };
  return {between(metres(a.at.x), metres(b.at.x)), between(metres(a.at.y), metres(b.at.y)),
          between(a.ground_m, b.ground_m)};
}

}  // namespace

const char* name_of(Path path) { return path == Path::walk ? "walk" : path == Path::fly ? "fly" : "overview"; }

Tour walk_tour(const Guide& guide, const City& city, std::uint64_t seed) {
  const PlanBox box = houses_box(city);
  const double half = (1 - kMiddleShare) / 2;
  const auto inside = [&](PlanPoint p) {
    const double x = double(p.x - box.min.x) / std::max(1, box.max.x - box.min.x),
                 y = double(p.y - box.min.y) / std::max(1, box.max.y - box.min.y);
    return x >= half && x <= 1 - half && y >= half && y <= 1 - half;
  };
  std::vector<const Sector*> streets, squares;
  for (const Sector& s : city.sectors) {
    if (s.kind == SectorKind::square) squares.push_back(&s);
    if (s.kind == SectorKind::street && inside(point_inside(s))) streets.push_back(&s);
  }
  if (streets.size() < 2) {
    streets.clear();
    for (const Sector& s : city.sectors) streets.push_back(&s);
  }
  std::mt19937_64 random(seed);
  const double middle_east = metres((std::int64_t{box.min.x} + box.max.x) / 2),
               middle_north = metres((std::int64_t{box.min.y} + box.max.y) / 2);
  const auto farthest = [&](const Tour& tour) {  // from the middle, of the first kWalk_m
    double most = 0;
    for (const TourPoint& p : tour.points)
      if (p.walked_m <= kWalk_m)
        most = std::max(most, std::hypot(metres(p.at.x) - middle_east, metres(p.at.y) - middle_north));
    return most;
  };
  Tour best;
  for (int i = 0; i < kTries && streets.size() >= 2; ++i) {
    const Sector &from = *streets[random() % streets.size()], &to = *streets[random() % streets.size()];
    TourQuery query;
    query.from = from.id;
    query.to = to.id;
    const auto away = [&](const Sector* s) {
      const PlanPoint a = point_inside(*s), b = point_inside(from);
      return std::hypot(double(a.x) - b.x, double(a.y) - b.y);
    };
    const auto nearer = [&](const Sector* a, const Sector* b) { return away(a) < away(b); };
    if (!squares.empty()) query.via.push_back((*std::min_element(squares.begin(), squares.end(), nearer))->id);
    query.via.push_back(streets[random() % streets.size()]->id);  // or a small town's walks are too short
    const TourAnswer answer = guide.tour(query);
    const Tour* tour = std::get_if<Tour>(&answer);
    if (tour == nullptr || tour->points.size() < 2) continue;
    const bool is_long = tour->length_m >= kWalk_m, was_long = best.length_m >= kWalk_m;
    if (is_long != was_long ? is_long : is_long ? farthest(*tour) < farthest(best) : tour->length_m > best.length_m)
      best = *tour;
  }
  if (best.points.size() < 2) throw CityError("the city has no two places to walk between: nothing to measure");
  best.length_m = std::min(best.length_m, kWalk_m);
  return best;
}

Pose walk_pose(const Tour& tour, double along_m) {
  assert(along_m >= 0 && along_m <= tour.length_m + 1e-6);
  const Spot at = spot_at(tour, along_m);
  Spot ahead = spot_at(tour, along_m + kAhead_m);
  if (std::hypot(ahead.east - at.east, ahead.north - at.north) < 0.5) {  // he turns back there
    const Spot near = spot_at(tour, along_m + 0.5), before = spot_at(tour, along_m - 0.5);
    ahead = {at.east + near.east - before.east, at.north + near.north - before.north, at.up};
    if (std::hypot(ahead.east - at.east, ahead.north - at.north) < 0.1) ahead.north += 1;
  }
  Pose pose{
      Path::walk, along_m, {at.east, at.north, at.up + kTourEye_m}, {ahead.east, ahead.north, at.up + kTourEye_m}, {}};
  for (const TourSector& s : tour.sectors)
    if (s.walked_m <= along_m || pose.sector_id.empty()) pose.sector_id = s.id;
  return pose;
}

FlyPath::FlyPath(const City& city) : city_(&city) {
  const PlanBox box = houses_box(city);
  east_ = metres((std::int64_t{box.min.x} + box.max.x) / 2);
  north_ = metres((std::int64_t{box.min.y} + box.max.y) / 2);
  const double half = metres(std::min(box.max.x - box.min.x, box.max.y - box.min.y)) / 2;
  radius_m_ = std::clamp(half, kLeastCircle_m, kFly_m / (2 * std::numbers::pi));
}

Pose FlyPath::at(double along_m) const {
  const double turn = along_m / radius_m_;
  const double out_east = std::cos(turn), out_north = std::sin(turn);
  const double ahead_east = -out_north * std::cos(kInwards) - out_east * std::sin(kInwards),
               ahead_north = out_east * std::cos(kInwards) - out_north * std::sin(kInwards);
  const double east = east_ + radius_m_ * out_east, north = north_ + radius_m_ * out_north;
  const double up = ground_m(*city_, east, north) + kFlyUp_m;
  const double level = std::cos(kFlyDown_deg * kRadian), down = std::sin(kFlyDown_deg * kRadian);
  return {
      Path::fly, along_m, {east, north, up}, {east + level * ahead_east, north + level * ahead_north, up - down}, {}};
}

Pose overview_pose(const City& city, double field_of_view) {
  const PlanBox box = houses_box(city);
  const double east = metres((std::int64_t{box.min.x} + box.max.x) / 2),
               north = metres((std::int64_t{box.min.y} + box.max.y) / 2);
  const double radius = std::hypot(metres(box.max.x - box.min.x), metres(box.max.y - box.min.y)) / 2;
  const double away = std::max(100.0, radius / std::tan(field_of_view / 2)), down = kOverviewDown_deg * kRadian;
  const double ground = ground_m(city, east, north);
  return {Path::overview,
          0,
          {east, north - away * std::cos(down), ground + away * std::sin(down)},
          {east, north, ground},
          {}};
}

std::vector<double> key_places(double length_m, std::size_t count) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(count == 1 ? length_m / 2 : length_m * static_cast<double>(i) / static_cast<double>(count - 1));
  return out;
}

}  // namespace vicus::measure
