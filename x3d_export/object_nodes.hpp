#pragma once
#include <utility>
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/mesh.hpp"
#include "x3d_export/writers.hpp"

/// What stands in a near sector file (paper 004 §4.1.5): static (one Shape of a model, USEd by every instance),
/// animated (fountains, trams), interactive (street lamps), sensitive (signs, in Anchors).
namespace vicus {

/// More instances would cost the browser more than their triangles: the others come as prisms in one Shape.
inline constexpr std::size_t kMostInstances = 100;

struct ObjectNodes {
  std::vector<Node> nodes;    ///< each holds all that its routes join
  std::vector<Route> routes;  ///< names are unique in the sector
};

/// Models are DEFined where they come first in a node; sector_scene makes it once a file.
/// Differs lamps are switched, and trams and water move, in X3D alone: VRML97 has no BooleanToggle, and shows fountains
///         and lamps at rest.
ObjectNodes object_nodes(const CityIndex& index, const Sector& sector, SceneFormat format);

/// Objects that come as prisms: beyond kMostInstances.
std::vector<const StandaloneObject*> plain_objects(const CityIndex& index, const Sector& sector);
/// What object_nodes places, at rest and with its signs, and doors, shut, for formats without instances. Frame   the
/// sector's own.
std::vector<Face> object_faces(const CityIndex& index, const Sector& sector);

/// The boards of signs with their letters, as Shapes; those with a web address each in an Anchor that opens it.
std::vector<Node> sign_nodes(const CityIndex& index, const Sector& sector);
/// The boards with their letters as faces, sign by sign; signs whose name has no letters of ours are left out.
std::vector<std::pair<const StandaloneObject*, std::vector<Face>>> sign_faces(const CityIndex& index,
                                                                              const Sector& sector);

}  // namespace vicus
