#include "sectorgen/geo/add_feature.hpp"

#include <algorithm>
#include <cmath>

#include "sectorgen/geo/osm_rules.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

// Systems are used a little beyond their official borders.
constexpr double kBeyondAreaOfUseDeg = 2;
// Coordinates without a declared system that span more than this are not degrees but somebody's metres.
constexpr double kWidestUndeclaredDeg = 10;

}  // namespace

FeatureAdder::FeatureAdder(const LayerChoice& choice, RawMap& map, CoordinateSystem system)
    : choice_(choice), map_(map), system_(std::move(system)) {}

void FeatureAdder::unreadable(long long fid, const std::string& problem) {
  map_.issues.push_back({IssueCode::unreadable_feature,
                         "The feature was left out: " + problem + ".",
                         choice_.layer.name + "#" + std::to_string(fid),
                         {},
                         false});
}

void FeatureAdder::begin(long long fid, Tags attributes) {
  source_id_ = feature_source_id(attributes, choice_.layer.name, fid);
  is_cut_ = tag(attributes, "edge") == "1";
  if (has_tag(attributes, "brunnel") || has_tag(attributes, "render_height") || has_tag(attributes, "@id") ||
      (has_tag(attributes, "cls") && has_tag(attributes, "tile")))
    is_from_osm_ = true;
  tags_ = tags_from_attributes(std::move(attributes));
  tags_.erase("edge");
}

bool FeatureAdder::is_in_area_of_use(LatLon p) const {
  if (!(std::abs(p.lat_deg) <= 90 && std::abs(p.lon_deg) <= 180)) return false;
  if (p.lat_deg < system_.south - kBeyondAreaOfUseDeg || p.lat_deg > system_.north + kBeyondAreaOfUseDeg) return false;
  const bool is_east_enough = p.lon_deg >= system_.west - kBeyondAreaOfUseDeg;
  const bool is_west_enough = p.lon_deg <= system_.east + kBeyondAreaOfUseDeg;
  return system_.west <= system_.east ? is_east_enough && is_west_enough : is_east_enough || is_west_enough;
}

bool FeatureAdder::are_in_reach(const std::vector<LatLon>& points) {
  ++lines_seen_;
  for (LatLon p : points) {
    if (is_in_area_of_use(p)) {
      south_ = std::min(south_, p.lat_deg);
      north_ = std::max(north_, p.lat_deg);
      continue;
    }
    ++lines_off_;
    map_.issues.push_back(
        {IssueCode::unreadable_feature,
         "The feature was left out: it lies where its coordinate system (" + system_.name + ") is not defined.",
         source_id_,
         {},
         false});
    return false;
  }
  return true;
}

void FeatureAdder::polygon(std::vector<std::vector<LatLon>> rings) {
  const auto theme = polygon_theme(choice_, tags_);
  if (!theme || rings.empty()) return;
  for (std::vector<LatLon>& ring : rings) {
    if (!are_in_reach(ring)) return;
    if (ring.size() < 2) continue;
    const LatLon first = ring.front(), last = ring.back();
    if (first.lat_deg == last.lat_deg && first.lon_deg == last.lon_deg) {
      ring.pop_back();
    } else {
      map_.issues.push_back(
          {IssueCode::ring_open, "A ring is not closed; it was closed by a straight line.", source_id_, first, true});
    }
  }
  map_.features.push_back({*theme, source_id_, tags_, std::move(rings), {}, is_cut_});
}

void FeatureAdder::line(std::vector<LatLon> points) {
  const auto theme = line_theme(choice_, tags_);
  if (!theme || !are_in_reach(points)) return;
  map_.features.push_back({*theme, source_id_, tags_, {std::move(points)}, {}, is_cut_});
}

void FeatureAdder::point(LatLon at) {
  if (choice_.use == LayerUse::ignored || !are_in_reach({at})) return;
  Tags tags = tags_;
  tags.erase("tile");
  if (choice_.use == LayerUse::objects && kind_of_point(tags).empty())
    tags.emplace(contains_word_part(choice_.layer.name, "lamp") ? "highway" : "natural",
                 contains_word_part(choice_.layer.name, "lamp") ? "street_lamp" : "tree");
  if (kind_of_point(tags).empty()) return;
  map_.features.push_back({Theme::object, source_id_, std::move(tags), {{at}}, {}, false});
}

void FeatureAdder::finish() {
  const std::string layer = choice_.layer.file.string() + ", layer " + choice_.layer.name + ": ";
  const bool is_absurd = lines_seen_ > 0 && lines_off_ * 2 >= lines_seen_;
  if (!system_.is_declared && (is_absurd || north_ - south_ > kWidestUndeclaredDeg))
    throw CityError(
        layer +
            "no coordinate system is declared, so WGS84 degrees were expected, but the coordinates are none "
            "of one city; declare the system, or convert the file to degrees (ogr2ogr -s_srs EPSG:... -t_srs "
            "EPSG:4326)",
        4);
  if (is_absurd)
    throw CityError(layer + "expected coordinates in its declared system (" + system_.name +
                        "), but most lie outside of where that is defined; declare the right system (ogr2ogr -a_srs "
                        "EPSG:...)",
                    4);
}

std::string unstated_licence(const std::filesystem::path& file) {
  return "Source: " + file.filename().string() + " (licence not stated in the file)";
}

}  // namespace vicus
