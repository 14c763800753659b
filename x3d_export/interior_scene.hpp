#pragma once
#include "x3d_export/sector_scene.hpp"

/// An interior as a file: sectors/ID.x3d, in the form of every near sector file (record, GROUND, doors).
namespace vicus {

/// Floor, walls with their doorways, lamp; seen from inside. The ceiling apart: no light of the street's reaches it.
/// Frame   the interior's own.
struct InteriorFaces {
  std::vector<Face> floor, ceiling, rest;
};
InteriorFaces interior_faces(const CityIndex& index, const Interior& interior);

/// The file with a lamp that lights nothing but the room.
/// Needs   a format that has what doors need: x3d or x3dj (assert).
ExportFile interior_file(const CityIndex& index, const Interior& interior, SceneFormat format);

}  // namespace vicus
