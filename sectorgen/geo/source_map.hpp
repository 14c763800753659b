#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// The map as read: every feature valid by itself, in the plan frame, on the 1 mm lattice. Not yet noded with its
/// neighbours: features may overlap, touch and cross each other.
namespace vicus {

/// One simple polygon per row: a multipolygon becomes several footprints with the same source_id.
struct Footprint {
  std::string source_id;  ///< way/123, relation/45, or LAYER#FID
  std::string name;
  Polygon area;         ///< valid: simple rings, outer counter-clockwise, holes clockwise inside it
  double base_m = 0;    ///< min_height, or min_level x storey height; building=roof, canopy: > 0
  double height_m = 0;  ///< top, > base_m
  double eave_m = 0;
  std::string roof_shape = "flat";
  HeightSource height_source = HeightSource::guessed;
  bool is_part = false;  ///< building:part
  Tags tags;
};

/// A centre line that makes the ground walkable: street, square's path, passage, steps.
struct Axis {
  std::string source_id, name;
  std::string kind;          ///< highway value; "unknown" where the source names none
  double width_m = 0;        ///< carriageway and pavements as tagged, or typical for the kind; > 0
  bool is_passage = false;   ///< tunnel=building_passage (or covered)
  double carriageway_m = 0;  ///< from kerb to kerb; 0: walkers and vehicles share the ground
  bool is_bridge = false, is_steps = false;
  int level = 0;  ///< layer, or 1 for a bridge without one: who passes over whom where two cross without a junction
  std::vector<PlanPoint> line;  ///< >= 2 points, consecutive ones differ
};

/// deck: the outline of a bridge (man_made=bridge), walkable where a street leads over it.
enum class AreaKind { square, park, water, plot, deck };

struct Area {
  std::string source_id, name;
  AreaKind kind = AreaKind::square;
  Polygon area;  ///< valid, as in Footprint
};

struct Barrier {
  std::string source_id;
  bool is_wall = true;  ///< else a fence
  double height_m = 2, thickness_m = 0.3;
  std::vector<PlanPoint> line;      ///< closed when the first and last point are equal
  std::vector<PlanPoint> openings;  ///< barrier=gate, entrance, ... on it
};

/// What the ground is made of, where the map says so; sectors do not depend on it.
struct GroundCover {
  std::string source_id;
  SurfaceKind kind = SurfaceKind::grass;
  Polygon area;  ///< valid, as in Footprint
};

/// The same for a line on the ground: a path that is no axis, the middle of a tram's rails.
struct Track {
  std::string source_id;
  SurfaceKind kind = SurfaceKind::path;  ///< path or rail
  double width_m = 0;
  std::vector<PlanPoint> line;
};

/// A room as mapped, inside a house.
struct Room {
  std::string source_id, name;
  std::string house;             ///< a building's id or its source's; empty: the one around it
  Polygon area;                  ///< valid, as in Footprint; no outline: all of the house
  std::vector<PlanPoint> doors;  ///< places on or near its outline; none: the doors mapped there
  double height_m = 0;           ///< 0: unknown
  bool is_on_ground_floor = true;
};

struct PointObject {
  std::string source_id, kind, name;  ///< kind: tree, street_lamp, fountain, bench, door, indoor_door, ...
  PlanPoint at;
  double height_m = 0;
  Tags tags;
};

/// A corner of a modelled house, above the model's own foot.
struct ModelPoint {
  PlanPoint at;
  double up_m = 0;
};
struct ModelFace {
  std::vector<std::vector<ModelPoint>> rings;  ///< outer first; closed implicitly
};

/// A window or door of a modelled house: corners of all that it is made of, frame and panes.
struct ModelOpening {
  bool is_door = false;
  std::vector<ModelPoint> corners;
};

/// A wall of a modelled house with an image on it; places: of its corners in the image, 0 to 1 from its bottom left.
struct ModelPhoto {
  std::filesystem::path image;
  std::vector<ModelPoint> corners;
  std::vector<std::array<double, 2>> places;
};

/// A house that came as a model (CityJSON, CityGML).
struct HouseModel {
  std::vector<ModelFace>
      tops;  ///< what looks up: may stick out over the footprint, overlap in plan, not be quite planar
  std::vector<ModelOpening> openings = {};  ///< on its walls or near them
  std::vector<ModelPhoto> photos = {};
};

struct SourceMap {
  LatLon origin;
  std::vector<Footprint> footprints;
  std::vector<Axis> axes;
  std::vector<Area> areas;
  std::vector<Barrier> barriers;
  std::vector<GroundCover> covers;
  std::vector<Track> tracks;
  std::vector<PointObject> objects;
  std::vector<Room> rooms;
  std::map<std::string, HouseModel> models;  ///< by source_id of the footprint
  std::vector<Polygon> boundary;             ///< --boundary; empty: the domain is derived
  std::string name;                          ///< what the map calls the place; empty: nothing, or several things
  std::vector<std::string>
      licences;  ///< attribution lines, deduplicated, e.g. "© OpenStreetMap contributors, ODbL 1.0"
};

struct LoadOptions {
  std::vector<std::filesystem::path> inputs;
  std::optional<std::string> buildings_layer, streets_layer;  ///< FILE or FILE:LAYER, else recognised
  std::optional<std::filesystem::path> boundary;
  std::string assumed_system;    ///< --crs: of 3D models whose file names no coordinate system, such as EPSG:28992
  std::optional<LatLon> origin;  ///< else the centre of the footprints' box
};

/// Reads every input into one plan frame (GeographicLib transverse Mercator, scale 1 at the origin).
/// Faults of single features become issues; the feature is repaired or left out.
/// Fails   CityError: a file that cannot be opened or is no map, a missing or absurd CRS, no feature at all (exit 4).
SourceMap load_source_map(const LoadOptions& options, std::vector<Issue>& issues);

}  // namespace vicus
