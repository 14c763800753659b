#pragma once
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/writers.hpp"

/// The houses of a near sector file: for each, one LOD node (several for a long one) with the four levels of paper 004
/// §4.2, nearest first.
namespace vicus {

/// m at which the next coarser level takes over, from 4 to 3, 3 to 2, 2 to 1. docs/houses.md has the measures.
inline constexpr double kLevelRanges_m[] = {30, 90, 250};

/// A sector with more openings leaves the fourth level out, to stay near 200 kB as sent: some 170 bytes an opening in
/// all levels (Montmartre), 100 of them in the fourth. From some 5,000 openings on that is not enough
/// (docs/sectors.md).
inline constexpr int kMostDeepOpenings = 1000;
/// 4, or 3 in such a sector.
int finest_level(const CityIndex& index, const Sector& sector);

/// Ids of the houses that have facades with openings in the sector: they come as LOD nodes, all others as plain prisms.
std::vector<std::string> houses_with_levels(const CityIndex& index, const Sector& sector);

/// Frame   the sector's own.   Urls  "../textures/ID.png".
/// Differs VRML97 gets the second level alone, as Groups: its LOD names the levels `level`, which view3dscene 4.2, the
///         independent reader of our files, does not know.
std::vector<Node> house_nodes(const CityIndex& index, const Sector& sector, SceneFormat format);

/// Shape nodes below a node, all levels counted.
int count_shapes(const Node& node);

}  // namespace vicus
