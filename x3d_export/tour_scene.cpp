#include "x3d_export/tour_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "x3d_export/frames.hpp"
#include "x3d_export/root_scene.hpp"

namespace vicus {
namespace {

constexpr double kSample_m = 0.25;
constexpr double kHalfTurn = std::numbers::pi;

/// Directions of the way at each sample's middle, as angles that never jump.
std::vector<double> directions_of(const Tour& tour, std::size_t samples) {
  std::vector<double> angles;
  std::size_t leg = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double at = (static_cast<double>(i) + 0.5) * kSample_m;
    while (leg + 2 < tour.points.size() && tour.points[leg + 1].walked_m <= at) ++leg;
    const auto &a = tour.points[leg].at, &b = tour.points[leg + 1].at;
    double angle = std::atan2(double(b.x) - a.x, double(b.y) - a.y);
    if (!angles.empty()) angle = angles.back() + std::remainder(angle - angles.back(), 2 * kHalfTurn);
    angles.push_back(angle);
  }
  return angles;
}

std::vector<double> position(const TourPoint& p) {
  const X3dPoint at = x3d_from_plan(p.at, height_mm(p.ground_m + kTourEye_m), {0, 0});
  return {metres(at.x), metres(at.y), metres(at.z)};
}

double share(double walked_m, const Tour& tour) {
  return tour.length_m > 0 ? std::round(walked_m / tour.length_m * 1e6) / 1e6 : 0;
}

Node positions_node(const Tour& tour) {
  std::vector<double> keys, values;
  for (const auto& p : tour.points) {
    keys.push_back(share(p.walked_m, tour));
    for (const double v : position(p)) values.push_back(v);
  }
  Node node("PositionInterpolator", "TOUR_WAY");
  node.set("key", keys).set("keyValue", values);
  return node;
}

Node headings_node(const Tour& tour) {
  std::vector<double> keys, values;
  for (const auto& look : tour_looks(tour)) {
    keys.push_back(share(look.walked_m, tour));
    const double yaw = std::remainder(-look.heading_rad, 2 * kHalfTurn);
    for (const double v : {0.0, 1.0, 0.0, std::round(yaw * 1e4) / 1e4}) values.push_back(v);
  }
  Node node("OrientationInterpolator", "TOUR_HEADING");
  node.set("key", keys).set("keyValue", values);
  return node;
}

/// Sectors that the tour's sectors see, from its beginning on, but its own.
std::vector<std::string> seen_on(const RecordSource& source, const Tour& tour) {
  std::vector<std::string> seen;
  std::set<std::string> known;
  for (const auto& s : tour.sectors) known.insert(s.id);
  for (const auto& s : tour.sectors)
    for (const auto& v : source.visible_from(s.id))
      if (v.building_ids.empty() && seen.size() < kMostFarSectors && known.insert(v.visible_sector_id).second)
        seen.push_back(v.visible_sector_id);
  return seen;
}

}  // namespace

std::vector<TourLook> tour_looks(const Tour& tour) {
  const auto samples = static_cast<std::size_t>(std::ceil(tour.length_m / kSample_m));
  if (samples == 0) {  // it goes nowhere: look where there is something to see
    const auto& stop = tour.stops.back();
    return {{0, std::atan2(double(stop.look.x) - stop.at.x, double(stop.look.y) - stop.at.y)}};
  }
  const auto directions = directions_of(tour, samples);
  std::vector<double> sums{0};
  for (const double d : directions) sums.push_back(sums.back() + d);
  const auto span = static_cast<std::size_t>(kLookSpan_m / kSample_m),
             step = static_cast<std::size_t>(kLookStep_m / kSample_m);
  std::vector<TourLook> looks;
  const auto add = [&](std::size_t i, double walked_m) {
    const std::size_t from = i > span ? i - span : 0, to = std::min(samples, i + span);
    looks.push_back({walked_m, (sums[to] - sums[from]) / static_cast<double>(to - from)});
  };
  for (std::size_t i = 0; i < samples; i += step) add(i, static_cast<double>(i) * kSample_m);
  add(samples, tour.length_m);
  return looks;
}

std::optional<Scene> tour_scene(const RecordSource& source, const Tour& tour) {
  RootOptions options;
  options.start = tour.sectors.front().id;
  options.is_static = true;
  for (const auto& s : tour.sectors) options.near.push_back(s.id);
  options.far = seen_on(source, tour);
  auto scene = root_scene(source, options);
  if (!scene) return std::nullopt;
  scene->title = "tour.x3d";
  scene->metas.emplace_back("description", tour.name + ", " + std::to_string(std::lround(tour.length_m)) + " m");
  Node eye("Viewpoint", "TOUR_EYE"), walker("Transform", "TOUR_WALKER"), clock("TimeSensor", "TOUR_CLOCK");
  eye.set("description", FieldValue(tour.name)).set("position", std::vector<double>{0, 0, 0});
  walker.set("translation", position(tour.points.front()));
  walker.set("rotation", std::vector<double>{0, 1, 0, -tour_looks(tour).front().heading_rad});
  walker.add(std::move(eye));
  clock.set("cycleInterval", std::max(1.0, std::round(tour.duration_s * 10) / 10));
  // The first Viewpoint of a world is bound; gravity and collision would pull at it.
  std::vector<Node> nodes;
  for (auto& node : scene->nodes) {
    if (node.type == "NavigationInfo")
      node = Node("NavigationInfo").set("headlight", false).set("type", std::vector<std::string>{"NONE", "ANY"});
    if (node.type == "Viewpoint" && !walker.type.empty()) {
      nodes.push_back(std::move(walker));
      walker.type.clear();
    }
    nodes.push_back(std::move(node));
  }
  nodes.push_back(std::move(clock));
  nodes.push_back(positions_node(tour));
  nodes.push_back(headings_node(tour));
  scene->nodes = std::move(nodes);
  for (auto route : {Route{"TOUR_EYE", "bindTime", "TOUR_CLOCK", "startTime"},
                     Route{"TOUR_CLOCK", "fraction_changed", "TOUR_WAY", "set_fraction"},
                     Route{"TOUR_CLOCK", "fraction_changed", "TOUR_HEADING", "set_fraction"},
                     Route{"TOUR_WAY", "value_changed", "TOUR_WALKER", "translation"},
                     Route{"TOUR_HEADING", "value_changed", "TOUR_WALKER", "rotation"}})
    scene->routes.push_back(std::move(route));
  return scene;
}

}  // namespace vicus
