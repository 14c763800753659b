#pragma once
#include <string>
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/scene.hpp"

/// What an open sector sees beyond its L_vis (paper 004 §4.1.7, §6), as it stands in its near file.
namespace vicus {

/// "panoramas/SECTOR.png", below the root world.
std::string panorama_path(const std::string& sector_id);

/// None, or one Group "PANORAMA" with one unlit Shape around the sector, not visible and its texture not loaded until a
/// loader says so (core/Panoramas.js): it is for who stands in the sector.
/// Frame   the sector's own.   Urls  "../panoramas/SECTOR.png".
std::vector<Node> panorama_nodes(const CityIndex& index, const Sector& sector);

}  // namespace vicus
