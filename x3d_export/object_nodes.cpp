#include "x3d_export/object_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "x3d_export/door_nodes.hpp"
#include "x3d_export/prototypes.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr double kCrease = 2.6;                                    // rad: leaves are shaded as one ball
constexpr double kNear_m = 90, kNearTram_m = 300, kHeight_m = 60;  // boxes in which things move
constexpr double kJets_m = 1.64;                                   // where a fountain's water rises, as modelled
constexpr double kHidden_m = -60;     // a tram that is in another sector stands below the ground
constexpr std::size_t kGroupOf = 40;  // instances in one node: small enough to pack files well

Node model_shape(const ObjectModel& model) {
  Node shape = shape_of(model.name, Shading::solid, model.faces);
  if (model.is_smooth)
    for (auto& field : shape.nodes)
      if (field.name == "geometry") field.nodes.front().set("creaseAngle", kCrease);
  return shape;
}

/// A Shape that shines by itself and lets some light through.
Node glowing_shape(const ObjectModel& model, double transparency) {
  Node shape = shape_of(model.name, Shading::backdrop, model.faces);
  for (auto& field : shape.nodes)
    if (field.name == "appearance") field.nodes.front().nodes.front().nodes.front().set("transparency", transparency);
  return shape;
}

std::vector<double> place_of(PlanPoint at, double up_m, PlanPoint origin) {
  const X3dPoint p = x3d_from_plan(at, height_mm(up_m), origin);
  return {metres(p.x), metres(p.y), metres(p.z)};
}

/// Turn about up that lets a front that looks south look along the heading; trees and what has no heading stay.
double turn_of(const StandaloneObject& object) {
  if (object.kind == "tree" || object.heading_deg == 0) return 0;
  return (180 - object.heading_deg) * std::numbers::pi / 180;
}

Node placed(const StandaloneObject& object, const ObjectModel& model, PlanPoint origin) {
  Node place("Transform");
  place.set("translation", place_of(object.at, object.ground_m, origin));
  if (const double turn = turn_of(object); turn != 0) place.set("rotation", std::vector<double>{0, 1, 0, turn});
  if (const auto [across, up] = scale_of(model, object); across != 1 || up != 1)
    place.set("scale", std::vector<double>{across, up, across});
  return place;
}

class SectorObjects {
 public:
  SectorObjects(const CityIndex& index, const Sector& sector, SceneFormat format)
      : index_(index), sector_(sector), is_x3d_(format != SceneFormat::vrml) {}

  ObjectNodes run() {
    std::size_t count = 0;
    for (const StandaloneObject* object : index_.objects_of(sector_.id)) {
      const ObjectModel model = model_of(index_, *object);
      if (model.faces.empty()) continue;
      if (++count > kMostInstances) break;
      Node place = placed(*object, model, sector_.origin);
      place.add(model_shape(model));
      if (object->kind == "fountain") {
        add_fountain(*object, model, std::move(place));
      } else if (object->kind == "street_lamp" && is_x3d_) {
        add_lamp(model, std::move(place));
      } else {
        if (groups_.empty() || groups_.back().nodes.front().nodes.size() >= kGroupOf) groups_.emplace_back("Group");
        groups_.back().add(std::move(place));
      }
    }
    std::move(groups_.begin(), groups_.end(), std::back_inserter(out_.nodes));
    for (Node& sign : sign_nodes(index_, sector_)) out_.nodes.push_back(std::move(sign));
    for (const Ride* ride : index_.rides_of(sector_.id)) add_ride(*ride);
    return std::move(out_);
  }

 private:
  std::string next_name(const char* what) { return std::string(what) + "-" + std::to_string(++names_[what]); }
  void route(const std::string& from, const char* field, const std::string& to, const char* to_field) {
    out_.routes.push_back({from, field, to, to_field});
  }

  /// A touch switches its light on, the next one off.
  void add_lamp(const ObjectModel& model, Node place) {
    const std::string touch = next_name("TOUCH"), toggle = next_name("TOGGLE"), light = next_name("LIGHT");
    Node sensor("TouchSensor", touch), glow("Group", light);
    sensor.set("description", "Light on or off");
    glow.set("visible", false).add(glowing_shape(lamp_glow(model), 0.35));
    place.add(std::move(sensor)).add(std::move(glow));
    Node group("Group");
    group.add(std::move(place)).add(Node("BooleanToggle", toggle));
    route(touch, "isActive", toggle, "set_boolean");
    route(toggle, "toggle", light, "visible");
    out_.nodes.push_back(std::move(group));
  }

  /// Runs only while a visitor is near: a scene in which nothing moves is not drawn again.
  Node clock(const std::string& name, double cycle_s) {
    Node timer("TimeSensor", name);
    return timer.set("cycleInterval", cycle_s).set("loop", true).set("enabled", false);
  }
  Node near_sensor(const std::string& name, std::vector<double> centre, double side_m) {
    Node sensor("ProximitySensor", name);
    return sensor.set("center", std::move(centre)).set("size", std::vector<double>{side_m, kHeight_m, side_m});
  }

  void add_fountain(const StandaloneObject& object, const ObjectModel& model, Node place) {
    const std::string near = next_name("NEAR"), timer = next_name("TIMER"), rise = next_name("RISE"),
                      jets = next_name("JETS");
    Node water("Transform", jets), heights("PositionInterpolator", rise), group("Group");
    const double up_m = kJets_m / 2.2 * model.height_m;
    water.set("translation", std::vector<double>{0, up_m, 0}).add(glowing_shape(fountain_jets(), 0.3));
    place.add(std::move(water));
    heights.set("key", std::vector<double>{0, 0.25, 0.5, 0.75, 1})
        .set("keyValue", std::vector<double>{1, 1, 1, 1.05, 1.14, 1.05, 0.96, 0.92, 0.96, 1.05, 1.1, 1.05, 1, 1, 1});
    group.add(std::move(place)).add(near_sensor(near, place_of(object.at, object.ground_m, sector_.origin), kNear_m));
    group.add(clock(timer, 1.6)).add(std::move(heights));
    route(near, "isActive", timer, "set_enabled");
    route(timer, "fraction_changed", rise, "set_fraction");
    route(rise, "value_changed", jets, "set_scale");
    out_.nodes.push_back(std::move(group));
  }

  /// The clock counts from 1970, so that the same tram goes from sector to sector.
  void add_ride(const Ride& ride) {
    if (!is_x3d_ || ride.points.size() < 2) return;
    const std::string near = next_name("NEAR"), timer = next_name("TIMER"), way = next_name("WAY"),
                      turn = next_name("TURN"), car = next_name("TRAM-CAR");
    constexpr double kBlink = 1e-5;
    std::vector<double> keys, places, turns, turn_keys;
    const auto add_key = [&](double key, std::vector<double> at) {
      keys.push_back(key);
      places.insert(places.end(), at.begin(), at.end());
    };
    const auto hidden = place_of(ride.points.front().at, kHidden_m, sector_.origin);
    const double first = ride.points.front().time_s / ride.cycle_s, last = ride.points.back().time_s / ride.cycle_s;
    if (first > kBlink) {
      add_key(0, hidden);
      add_key(first - kBlink, hidden);
    }
    PlanBox box;
    for (std::size_t i = 0; i < ride.points.size(); ++i) {
      const RidePoint& p = ride.points[i];
      box.add(p.at);
      add_key(p.time_s / ride.cycle_s, place_of(p.at, p.ground_m, sector_.origin));
      const std::size_t from = i + 1 < ride.points.size() ? i : i - 1;
      const PlanPoint a = ride.points[from].at, b = ride.points[from + 1].at;
      const double heading = std::atan2(double(b.x) - a.x, double(b.y) - a.y);
      turn_keys.push_back(p.time_s / ride.cycle_s);
      for (const double v : {0.0, 1.0, 0.0, -heading}) turns.push_back(v);
    }
    if (last < 1 - kBlink) {
      add_key(last + kBlink, hidden);
      add_key(1, hidden);
    }
    Node group("Group"), along("PositionInterpolator", way), round("OrientationInterpolator", turn),
        body("Transform", car);
    body.set("translation", hidden).add(model_shape(model_of(index_, tram_object())));
    along.set("key", keys).set("keyValue", places);
    round.set("key", turn_keys).set("keyValue", turns);
    const PlanPoint middle{box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
    group.add(std::move(body))
        .add(near_sensor(near, place_of(middle, ride.points.front().ground_m, sector_.origin), kNearTram_m));
    group.add(clock(timer, ride.cycle_s)).add(std::move(along)).add(std::move(round));
    route(near, "isActive", timer, "set_enabled");
    route(timer, "fraction_changed", way, "set_fraction");
    route(timer, "fraction_changed", turn, "set_fraction");
    route(way, "value_changed", car, "set_translation");
    route(turn, "value_changed", car, "set_rotation");
    out_.nodes.push_back(std::move(group));
  }

  static StandaloneObject tram_object() {
    StandaloneObject object;
    object.kind = "tram";
    return object;
  }

  const CityIndex& index_;
  const Sector& sector_;
  bool is_x3d_;
  ObjectNodes out_;
  std::vector<Node> groups_;
  std::map<std::string, int> names_;
};

}  // namespace

ObjectNodes object_nodes(const CityIndex& index, const Sector& sector, SceneFormat format) {
  return SectorObjects(index, sector, format).run();
}

std::vector<const StandaloneObject*> plain_objects(const CityIndex& index, const Sector& sector) {
  std::vector<const StandaloneObject*> out;
  std::size_t count = 0;
  for (const StandaloneObject* object : index.objects_of(sector.id))
    if (!model_of(index, *object).faces.empty() && ++count > kMostInstances) out.push_back(object);
  return out;
}

std::vector<Face> object_faces(const CityIndex& index, const Sector& sector) {
  std::vector<Face> faces;
  std::size_t count = 0;
  for (const StandaloneObject* object : index.objects_of(sector.id)) {
    const ObjectModel model = model_of(index, *object);
    if (model.faces.empty()) continue;
    if (++count > kMostInstances) break;
    const auto [across, up] = scale_of(model, *object);
    const double yaw = turn_of(*object), c = std::cos(yaw), s = std::sin(yaw);
    const X3dPoint foot = x3d_from_plan(object->at, height_mm(object->ground_m), sector.origin);
    for (Face face : model.faces) {
      for (X3dPoint& p : face.corners) {
        const double x = metres(p.x) * across, z = metres(p.z) * across;
        p = {foot.x + lattice_mm(x * c + z * s), foot.y + lattice_mm(metres(p.y) * up),
             foot.z + lattice_mm(z * c - x * s)};
      }
      faces.push_back(face);
    }
  }
  for (const auto& [sign, board] : sign_faces(index, sector)) faces.insert(faces.end(), board.begin(), board.end());
  const auto doors = door_faces(index, sector);
  faces.insert(faces.end(), doors.begin(), doors.end());
  return faces;
}

}  // namespace vicus
