#pragma once
#include <map>
#include <utility>
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/facade_levels.hpp"
#include "x3d_export/writers.hpp"

/// The facades of a near sector file: for each house, one LOD node (several for a long one) with the four levels of
/// paper 004 §4.2, nearest first.
namespace vicus {

/// m at which the next coarser level takes over, from 4 to 3, 3 to 2, 2 to 1. docs/houses.md has the measures.
inline constexpr double kLevelRanges_m[] = {30, 130, 250};

/// A sector with more openings leaves the fourth level out, to stay below 200 kB as sent: all that a sector sends is
/// 116 bytes an opening (in the middle of 3,016 sectors of Paris with 600 and more) to 188 (the most); without the
/// fourth level, in Montmartre, 45.
inline constexpr int kMostDeepOpenings = 1050;
/// One with even more has the first level in place of the second: all that it sends is some 33 bytes an opening, half
/// of them in the second level.
inline constexpr int kMostQuads = 5000;
/// 4, or 3 in a sector of more than kMostDeepOpenings.
int finest_level(const CityIndex& index, const Sector& sector);

/// Stretches of the sector's border, from a to b, whose walls come as LOD nodes: the facades with openings; and at
/// which height over the house's ground they begin, m. All other walls and the roofs look the same in every level, so
/// they are sent once, in the sector's layers (sector_mesh.hpp).
using LeveledStretches = std::map<std::pair<PlanPoint, PlanPoint>, double>;
LeveledStretches stretches_with_levels(const CityIndex& index, const Sector& sector);

/// What one LOD node has.
struct LevelPiece {
  X3dPoint centre;       ///< distances count from here
  LevelFaces levels[4];  ///< levels[0] is level 1
};
/// In the order of the nodes.   Frame   the sector's own.
std::vector<LevelPiece> sector_pieces(const CityIndex& index, const Sector& sector);
/// The level, 1 ... finest, that an LOD node shows at a distance.
int level_at(double distance_m, int finest);

/// All facades of a sector in one of the levels, 1 ... 4, for formats that choose the level otherwise.
/// Frame   the sector's own.
LevelFaces sector_facades(const CityIndex& index, const Sector& sector, int level);

/// Frame   the sector's own.   Urls  "../textures/ID.png".
/// Differs VRML97 gets the second level alone, as Groups: its LOD names the levels `level`, which view3dscene 4.2, the
///         independent reader of our files, does not know.
/// `only_level`: 1 ... 4: Groups of that level in place of LOD nodes.
std::vector<Node> house_nodes(const CityIndex& index, const Sector& sector, SceneFormat format, int only_level = 0);

/// Shape nodes below a node, all levels counted.
int count_shapes(const Node& node);

}  // namespace vicus
