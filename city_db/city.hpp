#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "city_db/colour.hpp"
#include "city_db/issues.hpp"
#include "city_db/units.hpp"

/// The records of a city (DESIGN §4): what the generator writes and everybody else reads. Nouns only.
///
/// Frame   plan lattice (mm) for everything in plan, metres above ground for heights.
/// Rings   closed implicitly (last point differs from the first), outer counter-clockwise, holes clockwise:
///         the inside is always on the left of a ring's edges.
namespace vicus {

using Ring = std::vector<PlanPoint>;
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};
/// Triangles of a polygon: three indices each, counter-clockwise seen from above, into the polygon's points counted
/// through the outer ring, then each hole.
using Triangles = std::vector<std::uint32_t>;
using Tags = std::map<std::string, std::string>;

/// interior: a room behind a door, of no street (Interior).
enum class SectorKind { street, crossroads, square, yard, passage, open, interior };

/// Is the sector worth keeping loaded all around it? Proposed: found so by measure, only a mark; author: said so by a
/// person, and listed in L_vis of the sectors of its vicinity (paper 004 §4.1.7).
enum class Importance { none, proposed, author };

/// Paper 004 §4.1: ground + border + gates + objects + viewpoints + L_vis. The lists live in City, by sector id.
struct Sector {
  std::string id;  ///< unique and stable; [A-Za-z0-9_-]+
  SectorKind kind = SectorKind::street;
  std::string name;                ///< the street's or square's name, may be empty
  std::vector<std::string> names;  ///< every street name it bears (a crossroads bears all its streets')
  Polygon ground;                  ///< walkable; holes are islands, houses standing in a square, ...
  Triangles ground_triangles;
  PlanPoint origin;         ///< of the sector frame
  std::uint64_t bytes = 0;  ///< as sent (brotli), without textures shared by the city
  Importance importance = Importance::none;
  double vicinity_m = 0;  ///< around the sector, where it is important
};

enum class GateKind { street, yard, kerb, passage, end_of_city };

/// A stretch of ground edge one can walk (or, out of the city, only look) through.
struct Gate {
  std::string id;
  std::string sector_id;
  std::string to_sector_id;  ///< empty: out of the city
  std::string twin_id;       ///< empty: out of the city
  GateKind kind = GateKind::street;
  std::vector<PlanPoint> line;  ///< >= 2 points, sector_id's ground on the left; the twin has them reversed
};

/// A room behind a door (paper 004 §5.2.3): a sector of its own, and no part of the walkable ground between the houses.
struct Interior {
  Sector sector;  ///< kind interior; ground: the room with its half of each doorway, inside the house
  std::string building_id, source_id;
  double floor_m = 0;   ///< above the plan frame's 0
  double height_m = 0;  ///< of the ceiling above the floor
};

/// One side of a door between an interior and the street before its house, or another interior; the twin is the other.
/// The ends of its line are corners of each interior, and lie on a facade border of the street's sector within 2 mm.
/// The leaf hangs at `a` of the side with the smaller id, and opens away from it.
struct Door {
  std::string id, twin_id, sector_id, to_sector_id, building_id;
  PlanPoint a, b;       ///< sector_id's ground on the left of a -> b; the twin has them reversed
  double sill_m = 0;    ///< above the plan frame's 0
  double height_m = 0;  ///< of the opening
  double recess_m = 0;  ///< of the leaf's middle beyond a-b, seen from sector_id; below 0: before it
};

enum class BorderKind { facade, wall, fence, bank, edge };

/// A stretch of ground edge that stops a walker; ground on the left. One building and one kind each.
struct Border {
  std::string sector_id;
  std::string building_id;  ///< facade only
  BorderKind kind = BorderKind::facade;
  double height_m = 0;  ///< wall, fence: top above ground; facade: see the building; bank, edge: 0
  std::vector<PlanPoint> line;
};

enum class HeightSource { measured, levels, guessed };

/// A wall of a house that bounds no sector's ground and yet may be seen: the part of a party wall above a lower
/// neighbour, or a wall to ground that was closed off. House on the left.
struct SideWall {
  PlanPoint a, b;
  double bottom_m = 0;
};

/// Where a house's roof shape comes from; the first that has something to say, in this order. flat_fallback: what was
/// asked for could not be built on this footprint (issue roof_flattened). model: the house came with it.
enum class RoofSource { tagged, neighbours, rule, preset, flat_fallback, model };

/// top: level; gable: upright over an edge of the footprint, above the eave; step: upright between two parts of the
/// roof.
enum class FacetKind { slope, top, gable, step };
inline bool is_upright(FacetKind kind) { return kind == FacetKind::gable || kind == FacetKind::step; }

inline constexpr double kRoofStepsPerMetre = 10'000;  ///< heights of a roof are whole numbers of 0.1 mm

struct RoofPoint {
  PlanPoint at;
  std::int32_t up = 0;  ///< above ground, 0.1 mm: finer than the plan, or rounding would bend the facets
  friend auto operator<=>(const RoofPoint&, const RoofPoint&) = default;
};

/// A planar polygon of a roof. Rings are counter-clockwise seen from outside, holes clockwise.
struct RoofFacet {
  FacetKind kind = FacetKind::top;
  std::vector<std::vector<std::uint32_t>> rings;  ///< outer, then holes: indices of points
  Triangles triangles;                            ///< of the facet: indices of points, counter-clockwise from outside
  friend bool operator==(const RoofFacet&, const RoofFacet&) = default;
};

/// What closes a house above its walls: with the walls from base to eave over every edge of the footprint, and the
/// footprint as underside, the facets are a closed solid. Every edge of the footprint is an edge of one facet, at the
/// eave. Facets are planar within 1 mm as stored, and do not meet but in edges and points.
struct Roof {
  std::vector<RoofPoint> points;
  std::vector<RoofFacet> facets;
  friend bool operator==(const Roof&, const Roof&) = default;
};

struct Building {
  std::string id, source_id, name;
  std::string sector_id;   ///< the sector that sends its roof and side walls
  Polygon footprint;       ///< as noded with its neighbours
  double ground_m = 0;     ///< above the plan frame's 0: the level that its other heights count from
  double foot_m = 0;       ///< its walls reach down this far below ground_m, where the ground around is lower
  double base_m = 0;       ///< underside above ground; > 0: one walks below, the footprint blocks nothing
  double height_m = 0;     ///< top of the roof above ground
  double eave_m = 0;       ///< top of the facades above ground
  std::string roof_shape;  ///< as built, OSM roof:shape
  RoofSource roof_source = RoofSource::rule;
  HeightSource height_source = HeightSource::guessed;
  Roof roof;
  std::vector<SideWall> side_walls;
  Colour wall_colour, roof_colour;
  Tags tags;  ///< building:colour, building:material, roof:colour, addr:*, ... for the models
};

enum class FacadeStyle { plaster, stone, brick, modern, church, shed };

enum class OpeningKind { tall_window, window, wide_window, church_window, house_door, church_door, gate_door, shop };
inline constexpr std::size_t kOpeningKinds = 8;

/// A window, door or shop front.
/// Frame   x in metres from the facade's left end (its point b) seen from outside, z in metres above its bottom.
struct Opening {
  OpeningKind kind = OpeningKind::window;
  double x0 = 0, x1 = 0, z0 = 0, z1 = 0;
  int floor = 0;
  int bay = 0;       ///< of the whole facade
  double depth = 0;  ///< metres behind the facade in the fourth level of detail
  friend bool operator==(const Opening&, const Opening&) = default;
};

/// A straight stretch of a facade border with openings: how they are laid out (facade_layout.hpp says where each is).
/// One with openings of its own has one repeat, floors and bays only count them.
/// Stretches of borders without one are blind. Paper 004 §4.2.
struct Facade {
  std::string sector_id, building_id;
  PlanPoint a, b;  ///< ground on the left of a -> b, as in the border
  double bottom_m = 0, top_m = 0;
  FacadeStyle style = FacadeStyle::plaster;
  int floors = 1;
  int bays = 1;       ///< of the pattern, >= 1
  int repeats = 1;    ///< of the pattern along the facade, >= 1
  int door_bay = -1;  ///< of the pattern, from the left seen from outside; -1: no door
  bool has_shop = false;
  std::string texture;  ///< id of the image of one pattern, for the third level of detail
  /// As the house's own model has them, apart from each other, floor by floor from the left; none: by the pattern.
  std::vector<Opening> openings;
};

/// An image under textures/ID.png; its id is a hash of its content.
struct Texture {
  std::string id;
  int width = 0, height = 0;
  std::string png;
};

enum class ObstacleKind { water, wall, fence, island, yard, courtyard };

/// Ground inside the domain that is neither house nor walkable: W = domain - buildings on the ground - obstacles.
struct Obstacle {
  ObstacleKind kind = ObstacleKind::water;
  std::string source_id;
  double height_m = 0;
  Polygon area;
};

/// A street's, path's or square's centre line as it was used: for names, maps and checks.
struct Street {
  std::string source_id, name, kind;  ///< kind: OSM highway value
  double width_m = 0;
  bool is_passage = false, is_bridge = false, is_steps = false;
  std::vector<PlanPoint> line;
};

struct StandaloneObject {
  std::string id, sector_id, kind, name;  ///< kind: tree, street_lamp, fountain, bench, sign, ...
  PlanPoint at;
  double ground_m = 0;     ///< of the ground it stands on, above the plan frame's 0
  double height_m = 0;     ///< sign: of its middle above ground_m; 0: unknown
  double heading_deg = 0;  ///< where its front looks, clockwise from north
  std::string url;         ///< web address of who is behind a sign: http or https, checked; else empty
  Tags tags;
};

/// What the ground is made of. kerb: upright faces where one surface lies higher than the next.
enum class SurfaceKind { pavement, carriageway, paving, path, grass, earth, water, steps, rail, kerb };

/// A place in the plan with a height above the plan frame's 0.
struct GroundPoint {
  PlanPoint at;
  std::int32_t up_mm = 0;
  friend auto operator<=>(const GroundPoint&, const GroundPoint&) = default;
};

/// The ground of one kind that one sector sends: its own, and of the ground around that nobody walks on (water, yards)
/// what lies nearest to it. All surfaces of a city are parts of one triangulation: they meet in whole edges, overlap
/// nowhere, and upright faces (kerb) close every edge where two of them differ in height.
struct Surface {
  std::string sector_id;
  SurfaceKind kind = SurfaceKind::pavement;
  std::vector<GroundPoint> points;
  Triangles triangles;  ///< counter-clockwise from above; of kerbs, from the lower side
};

struct RidePoint {
  PlanPoint at;
  double ground_m = 0;
  double time_s = 0;  ///< since the ride began
};

/// A vehicle's way through one sector, begun again each cycle_s at whole multiples of it since 1970: a tram that leaves
/// one sector comes into the next in the same moment, though nobody tells either.
struct Ride {
  std::string sector_id, kind;  ///< kind: tram
  double cycle_s = 0;
  std::vector<RidePoint> points;  ///< times ascend within 0 ... cycle_s
};

/// An author's model that stands for every object of a kind. Frame: x east, y north, up, from the object's foot; its
/// front looks south.
struct Prototype {
  std::string kind;
  std::vector<GroundPoint> points;
  Triangles triangles;          ///< counter-clockwise from outside
  std::vector<Colour> colours;  ///< one each triangle
};

struct Viewpoint {
  std::string id, sector_id, kind, name;  ///< kind: start, gate, square
  PlanPoint at;
  double ground_m = 0;     ///< of the ground there, above the plan frame's 0
  double eye_m = 1.7;      ///< above ground_m
  double heading_deg = 0;  ///< clockwise from north
};

/// Why a sector stands in the list of another; the first that holds, in this order.
enum class VisibleReason { self, gate, line_of_sight, over_roofs, important };

/// A picture of what lies beyond a gate, shown there until that has come (paper 004 §4.1.7): an upright rectangle.
/// Frame   heights above the plan frame's 0.
struct GateImpostor {
  std::string gate_id, sector_id;  ///< the gate's own
  PlanPoint eye;                   ///< where it was taken from, in the sector
  double eye_up_m = 0;
  PlanPoint left, right;  ///< of the picture, seen from the eye
  double bottom_m = 0, top_m = 0;
  double near_m = 0, far_m = 0;  ///< what it shows is so far before the eye; 0, 0: nothing but ground and sky
  double plane_m = 0;            ///< so far stands the picture
  double radius_m = 0;           ///< an eye so far from `eye` sees nothing displaced by more than 2 px of 579 px a unit
  bool is_solid = false;         ///< at an end of the city: it stays, and its sky is painted
  std::uint32_t width_px = 0, height_px = 0;
  std::string png;  ///< as made; in the file it is the artefact impostors/GATE.png
};

/// Sides of the prism that a panorama stands on: 22.5 degrees each.
inline constexpr int kPanoramaSides = 16;

/// What an open sector sees of the city beyond its L_vis, above nearer roofs, as a picture far behind all that L_vis
/// names (paper 004 §4.1.7 and §6): sides of an upright prism around `eye`. Side 0 begins in the north; on clockwise.
/// Seen from the eye, side k reaches from k to k + 1 sixteenths of a turn, its left and right edges `radius_m` from the
/// eye.
///
/// Frame   heights above the plan frame's 0.
struct Panorama {
  std::string sector_id;
  PlanPoint eye;  ///< where it was taken from
  double eye_up_m = 0;
  double radius_m = 0;
  double bottom_m = 0, top_m = 0;
  double near_m = 0, far_m = 0;  ///< what it shows is so far from the eye
  std::uint32_t sides = 0;       ///< bit k: side k shows something; those stand in the image in order, from the left
  std::uint32_t width_px = 0, height_px = 0;
  std::string png;  ///< as made; in the file it is the artefact panoramas/SECTOR.png
};

/// One row of L_vis: some eye in `sector_id` may see `visible_sector_id`.
struct Visible {
  std::string sector_id, visible_sector_id;
  VisibleReason reason = VisibleReason::self;
  bool is_proven = true;                  ///< over_roofs: by a witness ray; false: undecided, kept. Others: true
  std::vector<std::string> building_ids;  ///< over_roofs: houses of the visible sector that may be seen, sorted
};

/// Heights of the ground at the nodes of a grid, in mm above the plan frame's 0; row by row from the south-west corner
/// eastwards. No nodes: flat ground at 0.
struct Terrain {
  PlanPoint corner;  ///< south-west
  std::int32_t step_mm = 0;
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::int32_t> height_mm;  ///< columns * rows
};

/// Bytes under a URL path. One row per coding of the same path; `coding` is "identity", "gzip" or "br".
struct Artefact {
  std::string path, media_type, coding, hash, body;
};

struct City {
  std::map<std::string, std::string> meta;  ///< keys: see city_db/FORMAT.md
  LatLon origin;
  std::vector<Sector> sectors;
  std::vector<Gate> gates;
  std::vector<Border> borders;
  std::vector<Building> buildings;
  std::vector<Facade> facades;    ///< by sector, building, border
  std::vector<Texture> textures;  ///< as made; in the file they are artefacts. meta["atlas"]: windows and doors
  std::vector<Obstacle> obstacles;
  std::vector<Polygon> domain;
  std::vector<Street> streets;
  std::vector<StandaloneObject> objects;
  std::vector<Surface> surfaces;  ///< by sector, kind
  std::vector<Ride> rides;
  std::vector<Prototype> prototypes;
  std::vector<Viewpoint> viewpoints;
  std::vector<Interior> interiors;  ///< by id
  std::vector<Door> doors;          ///< by id
  std::vector<Visible> visible;
  std::vector<GateImpostor> impostors;  ///< by gate; empty: none were baked
  std::vector<Panorama> panoramas;      ///< by sector; of some
  Terrain terrain;
  std::vector<Issue> issues;
};

/// Names as stored in the file and in JSON; the inverse returns false for an unknown name.
const char* name_of(SectorKind);
const char* name_of(GateKind);
const char* name_of(BorderKind);
const char* name_of(ObstacleKind);
const char* name_of(HeightSource);
const char* name_of(RoofSource);
const char* name_of(FacetKind);
const char* name_of(VisibleReason);
const char* name_of(Importance);
const char* name_of(FacadeStyle);
const char* name_of(SurfaceKind);
bool parse_name(const std::string&, SectorKind&);
bool parse_name(const std::string&, GateKind&);
bool parse_name(const std::string&, BorderKind&);
bool parse_name(const std::string&, ObstacleKind&);
bool parse_name(const std::string&, HeightSource&);
bool parse_name(const std::string&, RoofSource&);
bool parse_name(const std::string&, FacetKind&);
bool parse_name(const std::string&, VisibleReason&);
bool parse_name(const std::string&, Importance&);
bool parse_name(const std::string&, FacadeStyle&);
bool parse_name(const std::string&, SurfaceKind&);

}  // namespace vicus
