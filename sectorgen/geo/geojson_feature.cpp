#include "sectorgen/geo/geojson_feature.hpp"

#include <nlohmann/json.hpp>

namespace vicus {

namespace {

/// The parser's events. `keys_` holds the key of each open object, `arrays_` the arrays open below "coordinates".
class FeatureEvents : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonFeature feature;
  std::string problem;

  bool null() override { return true; }
  bool boolean(bool value) override { return scalar(value ? "yes" : "no"); }
  bool number_integer(number_integer_t value) override {
    return in_coordinates() ? number(static_cast<double>(value)) : is_property() ? scalar(std::to_string(value)) : true;
  }
  bool number_unsigned(number_unsigned_t value) override {
    return in_coordinates() ? number(static_cast<double>(value)) : is_property() ? scalar(std::to_string(value)) : true;
  }
  bool number_float(number_float_t value, const string_t& text) override {
    return in_coordinates() ? number(value) : scalar(text);
  }
  bool string(string_t& value) override {
    if (keys_.size() == 1 && keys_[0] == "type") feature.is_feature = value == "Feature";
    if (is_in_geometry() && keys_.back() == "type" && !open_.empty()) feature.geometries[open_.back()].type = value;
    return scalar(value);
  }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    // A Feature's geometry, or a member of a GeometryCollection's "geometries".
    const bool is_geometry =
        !keys_.empty() && !in_coordinates() && (is_geometry_key(keys_.back()) && keys_[0] == "geometry");
    opens_geometry_.push_back(is_geometry);
    if (is_geometry) {
      open_.push_back(feature.geometries.size());
      feature.geometries.emplace_back();
    }
    keys_.emplace_back();
    return keys_.size() < kDeepest;
  }
  bool key(string_t& name) override {
    keys_.back() = name;
    return true;
  }
  bool end_object() override {
    keys_.pop_back();
    if (opens_geometry_.back()) open_.pop_back();
    opens_geometry_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override {
    if (!in_coordinates() && is_in_geometry() && keys_.back() == "coordinates") depth_ = 0;
    if (depth_ >= 0) {
      ++depth_;
      numbers_ = 0;
    }
    return depth_ < static_cast<int>(kDeepest);
  }
  bool end_array() override {
    if (depth_ < 0) return true;
    JsonGeometry& geometry = feature.geometries[open_.back()];
    if (numbers_ >= 2) {
      geometry.points.push_back({ordinates_[1], ordinates_[0]});
      point_depth_ = depth_;
    } else if (depth_ == point_depth_ - 1) {
      geometry.line_ends.push_back(geometry.points.size());
    } else if (depth_ == point_depth_ - 2) {
      geometry.polygon_ends.push_back(geometry.line_ends.size());
    }
    numbers_ = 0;
    if (--depth_ == 0) {
      depth_ = -1;
      point_depth_ = 0;
    }
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
    problem = error.what();
    return false;
  }

 private:
  static constexpr std::size_t kDeepest = 64;

  static bool is_geometry_key(const std::string& key) { return key == "geometry" || key == "geometries"; }
  bool in_coordinates() const { return depth_ >= 0; }
  bool is_in_geometry() const { return !open_.empty() && opens_geometry_.back(); }
  bool is_property() const { return keys_.size() == 2 && keys_[0] == "properties"; }

  bool scalar(const std::string& text) {
    if (is_property()) feature.properties.emplace(keys_[1], text);
    return true;
  }
  bool number(double value) {
    if (numbers_ < 2) ordinates_[numbers_] = value;
    ++numbers_;
    return true;
  }

  std::vector<std::string> keys_;
  std::vector<bool> opens_geometry_;
  std::vector<std::size_t> open_;
  int depth_ = -1, point_depth_ = 0;
  std::size_t numbers_ = 0;
  double ordinates_[2] = {0, 0};
};

std::vector<LatLon> opened_ring(const JsonGeometry& geometry, std::size_t begin, std::size_t end) {
  std::vector<LatLon> ring(geometry.points.begin() + static_cast<std::ptrdiff_t>(begin),
                           geometry.points.begin() + static_cast<std::ptrdiff_t>(end));
  return ring;
}

}  // namespace

std::optional<JsonFeature> parse_geojson_feature(std::string_view text, std::string& problem) {
  FeatureEvents events;
  if (!nlohmann::json::sax_parse(text.data(), text.data() + text.size(), &events)) {
    problem = events.problem.empty() ? "nested too deep" : events.problem;
    return std::nullopt;
  }
  return std::move(events.feature);
}

std::vector<std::vector<std::vector<LatLon>>> polygons_of(const JsonGeometry& geometry) {
  std::vector<std::vector<std::vector<LatLon>>> polygons;
  std::size_t line = 0, point = 0;
  for (std::size_t polygon_end : geometry.polygon_ends) {
    polygons.emplace_back();
    for (; line < polygon_end && line < geometry.line_ends.size(); ++line) {
      polygons.back().push_back(opened_ring(geometry, point, geometry.line_ends[line]));
      point = geometry.line_ends[line];
    }
  }
  return polygons;
}

}  // namespace vicus
