#pragma once
#include <string>
#include <vector>

#include "sectorgen/geo/layer_choice.hpp"
#include "sectorgen/geo/raw_map.hpp"

/// Turns the features of one layer, in degrees, into classified raw features.
namespace vicus {

class FeatureAdder {
 public:
  FeatureAdder(const LayerChoice& choice, RawMap& map);

  void unreadable(long long fid, const std::string& problem);  ///< issue 101
  /// The feature that the following geometries belong to.
  void begin(long long fid, Tags attributes);
  /// Rings, outer first, each closed by its repeated first point (issue 201 where not).
  void polygon(std::vector<std::vector<LatLon>> rings);
  void line(std::vector<LatLon> points);
  void point(LatLon at);
  /// Fails   CityError: most positions are no degrees.
  void finish();
  bool has_tile_attributes() const { return has_tile_attributes_; }

 private:
  bool are_degrees(const std::vector<LatLon>& points);

  const LayerChoice& choice_;
  RawMap& map_;
  std::string source_id_;
  Tags tags_;
  bool is_cut_ = false, has_tile_attributes_ = false;
  std::size_t lines_seen_ = 0, lines_off_ = 0;
};

}  // namespace vicus
