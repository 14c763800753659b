#pragma once
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/mesh.hpp"

/// Doors to interiors, as paper 004 §5.2.3 and Figure 7 have them: a leaf with a pane of glass, and behind it a picture
/// of what the door leads to, until that is there.
namespace vicus {

/// One Group for each door of the sector, as its own side looks; the other side's file has the other face of the leaf.
/// For door ID it holds: `DOOR-TOUCH-ID` (TouchSensor), `DOOR-LEAF-ID` (Transform; opens by `rotation` 0 1 0 and an
/// angle below 0), `DOOR-GLASS-ID` (Material of the pane), `DOOR-BEYOND-ID` (Group with the picture) and `DOOR-LAMP-ID`
/// (Material of the picture, lit by its emissiveColor).
/// Frame   the sector's own.
std::vector<Node> door_nodes(const CityIndex& index, const Sector& sector);

/// The same shut, as faces, for formats in which nothing moves.
std::vector<Face> door_faces(const CityIndex& index, const Sector& sector);

}  // namespace vicus
