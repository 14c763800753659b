#pragma once
#include <vector>

#include "sectorgen/geo/source_map.hpp"

/// How high a house is, by the best there is.
namespace vicus {

/// Sets base_m, height_m, eave_m, roof_shape and height_source of every footprint:
///   measured  `height`;
///   levels    `building:levels` x 3.0 m, and `roof:height` or `roof:levels` x 3.0 m on top;
///   guessed   the median of like neighbours (same value of `building`, within 100 m, near ones weigh more), else 9 m;
///             churches and towers by the size of their plan, sheds, garages and whatever is smaller than 30 m2: 3 m.
/// Issues 103, 209, 210. `is_cut[i]`: footprint i is a piece of a house, its area says nothing.
/// Error   a guess is a guess: see docs of the figures for its error on measured cities.
void set_heights(std::vector<Footprint>& footprints, const std::vector<bool>& is_cut, std::vector<Issue>& issues);

}  // namespace vicus
