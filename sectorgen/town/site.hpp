#pragma once
#include <string>
#include <vector>

#include "sectorgen/town/facade.hpp"
#include "sectorgen/town/network.hpp"
#include "sectorgen/town/osm_map.hpp"
#include "sectorgen/town/random.hpp"
#include "sectorgen/town/town.hpp"

/// A town being built, and the crafts that build it. Order: lay_out, then everything that stands, then draw_streets.
namespace vicus::town {

/// Street, shop and house names, each street's once.
class Names {
 public:
  std::string street(Rng& rng);
  std::string lane(Rng& rng);

 private:
  std::string unused(std::string name);
  std::unordered_map<std::string, int> used_;
};

/// What a town of 200 houses must show; bits of Site::sights.
inline constexpr unsigned kChurch = 1, kIsland = 2, kPark = 4, kPalace = 8, kGate = 16, kPassage = 32, kAlley = 64,
                          kCrossroads = 128;
inline constexpr unsigned kAllSights = 255;

struct Site {
  OsmMap& map;
  Names& names;
  TownCounts& counts;
  TownFeatures features;
  Rng rng;
  Vec origin;
  int houses_left = 0;
  double scale = 1;            ///< of the ground, against what usually bears the houses
  bool is_whole_town = false;  ///< large enough for wall, avenue, park and river
  Network network;
  double river_north = 0;  ///< y of the embankment before bending; used when is_whole_town
  unsigned sights = 0;
  int interiors = 0, special_shops = 0;
};

/// Where a house stands: what its tags depend on.
struct Lot {
  std::size_t line = 0;
  int number = 0;
  bool is_core = true;
  bool is_long = false;  ///< a palace, not a dwelling
};

// layout.cpp
void lay_out(Site& site);

// houses.cpp
/// Draws the house and counts it; false when the town has all its houses. Ring counter-clockwise.
bool build_house(Site& site, const Ring& ring, const Lot& lot, const Ring& light_well = {});
/// Any other building.
std::uint32_t build_other(Site& site, const Ring& ring, Tags tags);
Tags house_tags(Site& site, const Lot& lot);
void furnish_house(Site& site, const Ring& quad, const Lot& lot);
void open_shop(Site& site, Vec at);

// rows.cpp
/// Houses wall to wall around a block, a courtyard in the middle. `face` is kNoFace for a block that is no face.
bool build_rows(Site& site, std::vector<Side> sides, std::size_t face);
/// For a block too narrow for a courtyard; false when it has not four corners of houses' size.
bool build_narrow_block(Site& site, std::size_t face);
/// Four corners, counter-clockwise: two rows of houses back to back.
void build_island(Site& site, const Ring& corners, std::size_t line);

// courtyard.cpp
struct Passage {
  Vec outer, inner, inward;
  std::size_t line = 0;
};
void lay_out_courtyard(Site& site, const Ring& court, const std::vector<Passage>& passages, std::size_t face);

// detached.cpp
void build_detached(Site& site, std::size_t face);
/// On both sides of a road through open land.
void build_along(Site& site, const Polyline& street, std::size_t line);

// squares.cpp, palace.cpp, park.cpp, river.cpp, wall.cpp, streets.cpp
void build_market(Site& site, std::size_t face);
void build_second_square(Site& site, std::size_t face);
void build_palace(Site& site, std::size_t face);
void build_church(Site& site, Vec at, Vec east, double scale);
void build_park(Site& site, std::size_t face);
void build_river(Site& site);
void build_wall(Site& site);
void draw_streets(Site& site);
Tags street_tags(const Line& line);
/// A street from the face's longest side into its middle, ending in nothing. Adds the ground it takes to `built`.
void draw_dead_end(Site& site, std::size_t face, const std::vector<Side>& sides, const Ring& outline,
                   std::vector<Ring>& built);
void draw_way(Site& site, std::vector<NodeId> nodes, Tags tags);
void draw_footway(Site& site, std::vector<NodeId> nodes, Tags more = {});

// outskirts.cpp
/// The end of the town's streets farthest in a direction.
struct Outlet {
  NodeId node = 0;
  Vec at;
};
Outlet outlet_of(const Site& site, Vec direction);
/// A country road between two towns.
void draw_country_road(Site& site, const Outlet& from, const Outlet& to);

// scenes.cpp
/// The hard geometry that the features ask for, along a road that leaves the town to the east.
void build_scenes(Site& site);

std::string number_text(double value);

}  // namespace vicus::town
