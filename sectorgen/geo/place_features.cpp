#include "sectorgen/geo/place_features.hpp"

#include <algorithm>
#include <cmath>

#include "sectorgen/geo/osm_rules.hpp"
#include "sectorgen/geo/repair.hpp"
#include "sectorgen/geo/ring_check.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

// Below these a house is a drawing error, not a house. Parts may be columns and ledges.
constexpr double kLeastAreaM2 = 1, kLeastPartAreaM2 = 0.01;
constexpr double kLeastThicknessM = 0.05, kLeastPartThicknessM = 0.01;
constexpr double kLeastStreetM = 0.1;
// No city is wider; a box beyond it holds a feature that is far off.
constexpr double kWidestCityDeg = 3;

bool is_polygon(Theme theme) {
  return theme != Theme::street && theme != Theme::barrier && theme != Theme::track && theme != Theme::object;
}
bool is_house(Theme theme) { return theme == Theme::building || theme == Theme::part; }

struct DegreeBox {
  double south = 91, north = -91, west = 1e9, east = -1e9;
  std::vector<LatLon> firsts;  // one point per feature

  void add(const RawFeature& feature) {
    if (feature.lines.empty() || feature.lines[0].empty()) return;
    if (firsts.empty()) near_lon_ = feature.lines[0][0].lon_deg;
    for (LatLon p : feature.lines[0]) {
      const double lon = unwrapped_lon(p.lon_deg, near_lon_);
      south = std::min(south, p.lat_deg);
      north = std::max(north, p.lat_deg);
      west = std::min(west, lon);
      east = std::max(east, lon);
    }
    firsts.push_back({feature.lines[0][0].lat_deg, unwrapped_lon(feature.lines[0][0].lon_deg, near_lon_)});
  }
  /// Degrees of longitude count by their length on the ground.
  bool is_city() const {
    const double shrink = std::cos((south + north) / 2 * std::acos(-1.0) / 180);
    return north - south <= kWidestCityDeg && (east - west) * shrink <= kWidestCityDeg;
  }

 private:
  double near_lon_ = 0;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double rounded_degrees(double degrees) { return std::round(degrees * 1e5) / 1e5; }

class Placer {
 public:
  Placer(const PlanFrame& frame, SourceMap& map, std::vector<bool>& is_cut, std::vector<Issue>& issues)
      : frame_(frame), map_(map), is_cut_(is_cut), issues_(issues) {}

  void place(RawFeature& feature) {
    std::vector<Ring> lines;
    for (const std::vector<LatLon>& line : feature.lines) {
      lines.emplace_back();
      lines.back().reserve(line.size());
      for (LatLon p : line) {
        const auto at = frame_.plan_from_latlon(p);
        if (!at) {
          issue(IssueCode::outside_limits, "Too far from the city's origin; left out.", feature.source_id, {});
          return;
        }
        lines.back().push_back(*at);
      }
    }
    if (is_polygon(feature.theme)) return place_polygon(feature, std::move(lines));
    if (lines.empty() || lines[0].empty()) return;
    if (feature.theme == Theme::object) return place_object(feature, lines[0][0]);
    place_line(feature, lines[0]);
  }

 private:
  void issue(IssueCode code, const std::string& message, const std::string& source_id, PlanPoint at) {
    issues_.push_back({code, message, source_id, at});
  }

  void place_polygon(RawFeature& feature, std::vector<Ring> rings) {
    const PlanPoint first = rings.empty() || rings[0].empty() ? PlanPoint{} : rings[0][0];
    Repaired repaired = repaired_polygons(std::move(rings));
    const bool has_none = repaired.polygons.empty();
    if (repaired.fault) {
      RingFault& fault = *repaired.fault;
      if (has_none && fault.code == IssueCode::ring_self_intersection)
        fault = {IssueCode::sliver, "it has no area", first};
      issue(fault.code, "Faulty outline: " + fault.what + (has_none ? "; left out." : "; repaired."), feature.source_id,
            fault.at);
    }
    bool has_kept = false;
    std::size_t last = repaired.polygons.size();
    for (std::size_t i = 0; i < last; ++i) {
      Polygon& polygon = repaired.polygons[i];
      if (is_sliver(polygon, feature.theme)) continue;
      has_kept = true;
      add_polygon(feature, std::move(polygon), i + 1 == last);
    }
    if (!has_none && !has_kept)
      issue(IssueCode::sliver, "Smaller than 1 m² or thinner than 5 cm; left out.", feature.source_id, first);
  }

  static bool is_sliver(const Polygon& polygon, Theme theme) {
    const double area = area_m2(polygon);
    // A strip's area over half its outline is its thickness.
    const double thickness = 2 * area / perimeter_m(polygon.outer);
    return theme == Theme::part ? area < kLeastPartAreaM2 || thickness < kLeastPartThicknessM
                                : area < kLeastAreaM2 || thickness < kLeastThicknessM;
  }

  void add_polygon(RawFeature& feature, Polygon polygon, bool is_last) {
    if (feature.theme == Theme::boundary) {
      map_.boundary.push_back(std::move(polygon));
    } else if (is_house(feature.theme)) {
      Footprint footprint;
      footprint.source_id = feature.source_id;
      footprint.name = tag(feature.tags, "name");
      footprint.area = std::move(polygon);
      footprint.is_part = feature.theme == Theme::part;
      footprint.tags = is_last ? std::move(feature.tags) : feature.tags;
      map_.footprints.push_back(std::move(footprint));
      is_cut_.push_back(feature.is_cut);
    } else if (feature.theme == Theme::room) {
      Room room;
      room.source_id = feature.source_id;
      room.name = tag(feature.tags, "name");
      room.area = std::move(polygon);
      room.height_m = parse_metres(tag(feature.tags, "height")).value_or(0);
      room.is_on_ground_floor = is_on_ground_floor(feature.tags);
      map_.rooms.push_back(std::move(room));
    } else if (feature.theme == Theme::cover) {
      map_.covers.push_back({feature.source_id, surface_of(feature.tags), std::move(polygon)});
    } else {
      map_.areas.push_back(
          {feature.source_id, tag(feature.tags, "name"), area_kind(feature.theme), std::move(polygon)});
    }
  }

  static AreaKind area_kind(Theme theme) {
    if (theme == Theme::water) return AreaKind::water;
    if (theme == Theme::park) return AreaKind::park;
    if (theme == Theme::deck) return AreaKind::deck;
    return theme == Theme::plot ? AreaKind::plot : AreaKind::square;
  }

  void place_line(const RawFeature& feature, const Ring& points) {
    Ring line;
    double length = 0;
    for (PlanPoint p : points) {
      if (!line.empty() && line.back() == p) continue;
      if (!line.empty()) length += std::hypot(metres(p.x) - metres(line.back().x), metres(p.y) - metres(line.back().y));
      line.push_back(p);
    }
    if (line.size() < 2 || length < kLeastStreetM) {
      if (feature.theme == Theme::street)
        issue(IssueCode::street_too_short, "Shorter than 10 cm; left out.", feature.source_id, line[0]);
      return;
    }
    if (feature.theme == Theme::track)
      map_.tracks.push_back(
          {feature.source_id, surface_of(feature.tags), track_width_m(feature.tags), std::move(line)});
    else
      feature.theme == Theme::street ? add_axis(feature, std::move(line)) : add_barrier(feature, std::move(line));
  }

  void add_axis(const RawFeature& feature, Ring line) {
    const Tags& tags = feature.tags;
    for (const char* key : {"width", "lanes", "layer"}) {
      const bool is_read = std::string_view(key) == "width" ? parse_metres(tag(tags, key)).has_value()
                                                            : parse_number(tag(tags, key)).has_value();
      if (has_tag(tags, key) && !is_read)
        issue(IssueCode::unknown_attribute_value,
              std::string(key) + "=" + tag(tags, key) + " was not understood; ignored.", feature.source_id, line[0]);
    }
    Axis axis;
    axis.source_id = feature.source_id;
    axis.name = tag(tags, "name");
    axis.kind = has_tag(tags, "highway") ? tag(tags, "highway") : "unknown";
    axis.width_m = axis_width_m(tags);
    axis.carriageway_m = carriageway_m(tags);
    axis.is_passage = is_passage(tags);
    axis.is_bridge = is_yes(tags, "bridge");
    axis.is_steps = axis.kind == "steps";
    axis.level = axis_level(tags);
    axis.line = std::move(line);
    map_.axes.push_back(std::move(axis));
  }

  void add_barrier(const RawFeature& feature, Ring line) {
    Barrier barrier;
    barrier.source_id = feature.source_id;
    barrier.is_wall = is_wall(feature.tags) || !has_tag(feature.tags, "barrier");
    barrier.height_m = barrier_height_m(feature.tags);
    barrier.thickness_m = barrier_thickness_m(feature.tags);
    barrier.line = std::move(line);
    for (LatLon opening : feature.openings)
      if (const auto at = frame_.plan_from_latlon(opening);
          at && std::find(barrier.openings.begin(), barrier.openings.end(), *at) == barrier.openings.end())
        barrier.openings.push_back(*at);
    map_.barriers.push_back(std::move(barrier));
  }

  void place_object(RawFeature& feature, PlanPoint at) {
    PointObject object;
    object.source_id = feature.source_id;
    object.kind = kind_of_point(feature.tags);
    object.name = tag(feature.tags, "name");
    object.at = at;
    if (const auto height = parse_metres(tag(feature.tags, "height")); height && *height > 0) object.height_m = *height;
    object.tags = std::move(feature.tags);
    map_.objects.push_back(std::move(object));
  }

  const PlanFrame& frame_;
  SourceMap& map_;
  std::vector<bool>& is_cut_;
  std::vector<Issue>& issues_;
};

/// Faces and openings with a corner out of reach are left out: their footprint is, too.
void place_model(const RawModel& raw, const PlanFrame& frame, SourceMap& map) {
  HouseModel& model = map.models[raw.source_id];
  const auto place = [&](const std::vector<RawModelPoint>& from, std::vector<ModelPoint>& to) {
    for (const RawModelPoint& p : from)
      if (const auto at = frame.plan_from_latlon(p.at); at) to.push_back({*at, p.up_m});
    return to.size() == from.size();
  };
  for (const RawModelFace& raw_face : raw.tops) {
    ModelFace face;
    bool is_placed = true;
    for (const auto& raw_ring : raw_face) is_placed = place(raw_ring, face.rings.emplace_back()) && is_placed;
    if (is_placed) model.tops.push_back(std::move(face));
  }
  for (const RawModelOpening& raw_opening : raw.openings) {
    ModelOpening opening{raw_opening.is_door, {}};
    if (place(raw_opening.corners, opening.corners)) model.openings.push_back(std::move(opening));
  }
  for (const RawModelPhoto& raw_photo : raw.photos) {
    ModelPhoto photo{raw_photo.image, {}, raw_photo.places};
    if (place(raw_photo.corners, photo.corners)) model.photos.push_back(std::move(photo));
  }
}

}  // namespace

LatLon default_origin(const RawMap& raw) {
  DegreeBox box;
  for (const RawFeature& feature : raw.features)
    if (feature.theme == Theme::building) box.add(feature);
  if (box.firsts.empty())
    for (const RawFeature& feature : raw.features) box.add(feature);
  if (box.firsts.empty())
    throw CityError("nothing usable in the input: no building, street, square, park, water or wall was found", 4);
  LatLon centre{(box.south + box.north) / 2, (box.west + box.east) / 2};
  if (!box.is_city()) {
    std::vector<double> lats, lons;
    for (LatLon p : box.firsts) {
      lats.push_back(p.lat_deg);
      lons.push_back(p.lon_deg);
    }
    centre = {median(std::move(lats)), median(std::move(lons))};
  }
  return {rounded_degrees(centre.lat_deg), rounded_degrees(unwrapped_lon(centre.lon_deg, 0))};
}

void place_features(RawMap raw, const PlanFrame& frame, SourceMap& map, std::vector<bool>& is_cut,
                    std::vector<Issue>& issues) {
  for (RawIssue& issue : raw.issues) {
    const auto at = issue.has_place ? frame.plan_from_latlon(issue.at) : std::nullopt;
    issues.push_back({issue.code, std::move(issue.message), std::move(issue.source_id), at.value_or(PlanPoint{})});
  }
  Placer placer(frame, map, is_cut, issues);
  for (RawFeature& feature : raw.features) {
    placer.place(feature);
    feature.lines = {};
  }
  for (const RawModel& model : raw.models) place_model(model, frame, map);
}

}  // namespace vicus
