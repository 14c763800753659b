#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// What the file readers hand on: classified features in degrees, with OSM-like tags, not yet projected or checked.
namespace vicus {

enum class Theme {
  building,
  part,
  square,
  park,
  water,
  plot,
  deck,
  street,
  barrier,
  object,
  boundary,
  cover,
  track,
  room
};

/// One feature of one theme. `lines` is, by theme: a polygon's rings, outer first; one centre line or wall; one point.
struct RawFeature {
  Theme theme = Theme::building;
  std::string source_id;
  Tags tags;
  std::vector<std::vector<LatLon>> lines;
  std::vector<LatLon> openings;  ///< barrier only
  bool is_cut = false;           ///< a piece cut off at a tile border: its size says nothing about the house
};

/// A fault found while reading, its place still in degrees.
struct RawIssue {
  IssueCode code = IssueCode::unreadable_feature;
  std::string message, source_id;
  LatLon at;
  bool has_place = false;
};

/// A house's own roof, as in HouseModel, its places still in degrees.
struct RawModelPoint {
  LatLon at;
  double up_m = 0;
};
using RawModelFace = std::vector<std::vector<RawModelPoint>>;
/// A window or door: corners of all that it is made of, frame and panes.
struct RawModelOpening {
  bool is_door = false;
  std::vector<RawModelPoint> corners;
};
/// A wall with an image on it; places: of its corners in the image, 0 to 1 from its bottom left.
struct RawModelPhoto {
  std::filesystem::path image;
  std::vector<RawModelPoint> corners;
  std::vector<std::array<double, 2>> places;
};
struct RawModel {
  std::string source_id;
  std::vector<RawModelFace> tops;
  std::vector<RawModelOpening> openings;
  std::vector<RawModelPhoto> photos;
};

struct RawMap {
  std::vector<RawFeature> features;
  std::vector<RawModel> models;
  std::vector<RawIssue> issues;
  std::vector<std::string> licences;
};

/// What `vicus town` calls itself in its files: nobody's map, so nobody to name.
inline constexpr const char* kTownGenerator = "vicus town";
inline constexpr const char* kTownLicence = "Invented town, made by Vicus (CC0 1.0)";
inline constexpr const char* kOsmLicence = "© OpenStreetMap contributors, ODbL 1.0";

}  // namespace vicus
