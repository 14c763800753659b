#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/city.hpp"

/// One GeoJSON Feature from its text, in one pass without a document tree.
namespace vicus {

/// Coordinates of one geometry in file order; ends are indices behind the last point of a line (or ring), and behind
/// the last line of a polygon.
struct JsonGeometry {
  std::string type;
  std::vector<LatLon> points;
  std::vector<std::size_t> line_ends, polygon_ends;
};

struct JsonFeature {
  Tags properties;                       ///< scalars only, as text; true -> yes, false -> no, null left out
  std::vector<JsonGeometry> geometries;  ///< a GeometryCollection, however nested, gives several
  bool is_feature = false;
};

/// Fails   nothing for text that is no JSON object; `problem` says why.
std::optional<JsonFeature> parse_geojson_feature(std::string_view text, std::string& problem);

/// The geometry's polygons as rings in degrees, not closed by a repeated point.
std::vector<std::vector<std::vector<LatLon>>> polygons_of(const JsonGeometry& geometry);

}  // namespace vicus
