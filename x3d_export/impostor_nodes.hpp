#pragma once
#include <string>
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/scene.hpp"

/// Pictures of what lies beyond a sector's gates (paper 004 §4.1.7) as they stand in its near file.
namespace vicus {

/// "impostors/GATE.png", below the root world.
std::string impostor_path(const std::string& gate_id);

/// For each impostor one Group "IMPOSTOR-" + gate id with one unlit Shape, seen from its sector only. Of a gate to
/// another sector the Group is not visible and its texture not loaded until a loader says so (core/GateImpostors.js);
/// at an end of the city both are as usual.
/// Frame   the sector's own.   Urls  "../impostors/GATE.png".
std::vector<Node> impostor_nodes(const CityIndex& index, const Sector& sector);

}  // namespace vicus
