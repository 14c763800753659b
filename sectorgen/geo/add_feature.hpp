#pragma once
#include <string>
#include <vector>

#include "sectorgen/geo/layer_choice.hpp"
#include "sectorgen/geo/raw_map.hpp"

/// Turns the features of one layer, in degrees, into classified raw features.
namespace vicus {

/// Where the degrees come from, and where they may lie.
struct CoordinateSystem {
  std::string name = "WGS84";
  bool is_declared = false;
  double west = -180, south = -90, east = 180, north = 90;  ///< area of use; west > east: across 180 degrees
};

class FeatureAdder {
 public:
  FeatureAdder(const LayerChoice& choice, RawMap& map, CoordinateSystem system);

  void unreadable(long long fid, const std::string& problem);  ///< issue 101
  /// The feature that the following geometries belong to.
  void begin(long long fid, Tags attributes);
  /// Rings, outer first, each closed by its repeated first point (issue 201 where not).
  void polygon(std::vector<std::vector<LatLon>> rings);
  void line(std::vector<LatLon> points);
  void point(LatLon at);
  /// Fails   CityError: most features lie outside of the system's area of use.
  void finish();
  /// Vector tiles of OpenStreetMap, or features with its ids.
  bool is_from_osm() const { return is_from_osm_; }

 private:
  bool are_in_reach(const std::vector<LatLon>& points);
  bool is_in_area_of_use(LatLon p) const;

  const LayerChoice& choice_;
  RawMap& map_;
  CoordinateSystem system_;
  std::string source_id_;
  Tags tags_;
  bool is_cut_ = false, is_from_osm_ = false;
  std::size_t lines_seen_ = 0, lines_off_ = 0;
  double south_ = 90, north_ = -90;
};

std::string unstated_licence(const std::filesystem::path& file);

}  // namespace vicus
