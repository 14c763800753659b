#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A synthetic old town as OSM XML: for demos, and as the generator of property tests.
namespace vicus {

/// What makes a town hard. All off: a handsome one.
struct TownFeatures {
  bool collinear_fronts = false;  ///< straight streets along the axes: fronts in line across every junction
  bool zero_width_alley = false;  ///< houses that touch without a shared node, or stand one coordinate step apart
  bool t_junctions = false;       ///< no four-way crossroads, and a comb of side streets
  bool touching_gates = false;    ///< star crossroads between sharp corners: gates would meet in a point
  bool parallel_streets = false;  ///< long streets at one or two degrees to each other, thin houses between
  bool concave_square = false;    ///< concave squares with islands of houses, whatever the size
  bool detached = false;          ///< detached houses with gaps only
  bool dead_end = false;          ///< streets that end in nothing
  bool no_streets = false;        ///< not one highway
  bool antimeridian = false;      ///< on both sides of 180 degrees
  bool arctic = false;            ///< at 85 degrees north
  bool huge = false;              ///< villages up to 60 km apart, joined by roads
};

inline constexpr int kMinHouses = 20, kMaxHouses = 200'000;

struct TownOptions {
  int houses = 300;
  std::uint64_t seed = 1;
  double lat_deg = 50.087, lon_deg = 14.421;  ///< the town's centre; antimeridian and arctic move it
  TownFeatures features;
};

struct TownCounts {
  std::size_t houses = 0;     ///< as asked for: rows, detached, palaces; not churches, towers, sheds
  std::size_t buildings = 0;  ///< every building=*
  std::size_t streets = 0;    ///< ways with highway=*
  std::size_t nodes = 0, ways = 0, relations = 0;
};

struct Town {
  std::string osm;  ///< OSM XML 0.6, ids ascending from 1, no time stamps
  TownCounts counts;
};

/// From 300 houses on, without features, a town has at least: a market square with a church, a concave square with an
/// island, rows, courtyards, building passages, an alley, a park, a river with bridge, a wall with gate, an avenue.
/// Frame   WGS84 in steps of 1e-7 degrees, the finest that OSM keeps (11 mm north, 7 mm east at 50 degrees).
/// Needs   kMinHouses <= houses <= kMaxHouses; |lat_deg| <= 85, |lon_deg| <= 180.
/// Error   equal options give equal bytes on every machine: only + - * / and sqrt of IEEE doubles, no libm.
/// Fails   never.   Cost  linear in houses.
Town make_town(const TownOptions& options);
std::string make_town_osm(const TownOptions& options);

/// A town of 20 to 120 houses with a mixture of features drawn by the seed.
TownOptions random_town_options(std::uint64_t seed);
std::string make_random_town(std::uint64_t seed);

struct TownPreset {
  std::string name, what;
};
/// Every feature by its name, and "random".
const std::vector<TownPreset>& town_presets();
/// Switches the feature on ("random": draws the mixture by options.seed, keeps options.houses).
/// Returns false, and changes nothing, for an unknown name.
bool apply_town_preset(const std::string& name, TownOptions& options);

}  // namespace vicus
