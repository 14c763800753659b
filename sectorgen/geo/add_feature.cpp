#include "sectorgen/geo/add_feature.hpp"

#include <cmath>

#include "sectorgen/geo/osm_rules.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

FeatureAdder::FeatureAdder(const LayerChoice& choice, RawMap& map) : choice_(choice), map_(map) {}

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
  if (has_tag(attributes, "tile") || has_tag(attributes, "render_height")) has_tile_attributes_ = true;
  tags_ = tags_from_attributes(std::move(attributes));
  tags_.erase("tile");
  tags_.erase("edge");
}

bool FeatureAdder::are_degrees(const std::vector<LatLon>& points) {
  ++lines_seen_;
  for (LatLon p : points) {
    if (std::abs(p.lat_deg) <= 90 && std::abs(p.lon_deg) <= 180) continue;
    ++lines_off_;
    map_.issues.push_back({IssueCode::unreadable_feature,
                           "The feature was left out: a position of it is not in degrees of latitude and longitude.",
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
    if (!are_degrees(ring)) return;
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
  if (!theme || !are_degrees(points)) return;
  map_.features.push_back({*theme, source_id_, tags_, {std::move(points)}, {}, is_cut_});
}

void FeatureAdder::point(LatLon at) {
  if (choice_.use == LayerUse::ignored || !are_degrees({at})) return;
  Tags tags = tags_;
  if (choice_.use == LayerUse::objects && kind_of_point(tags).empty())
    tags.emplace(contains_word_part(choice_.layer.name, "lamp") ? "highway" : "natural",
                 contains_word_part(choice_.layer.name, "lamp") ? "street_lamp" : "tree");
  if (kind_of_point(tags).empty()) return;
  map_.features.push_back({Theme::object, source_id_, std::move(tags), {{at}}, {}, false});
}

void FeatureAdder::finish() {
  if (lines_seen_ > 0 && lines_off_ * 2 >= lines_seen_)
    throw CityError(choice_.layer.file.string() + ", layer " + choice_.layer.name +
                        ": the file declares no coordinate system, so degrees (WGS84) were expected, but most "
                        "positions lie outside of +-180, +-90; declare the system, or convert the file to EPSG:4326 "
                        "(ogr2ogr -s_srs ... -t_srs EPSG:4326)",
                    4);
}

}  // namespace vicus
