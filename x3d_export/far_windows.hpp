#pragma once
#include <span>
#include <string>
#include <vector>

#include "x3d_export/mesh.hpp"

/// Windows of houses that are too far away for facades of their own: one grey pattern over all walls of a file.
namespace vicus {

/// How many windows side by side and above each other a wall shows; none: it is plain.
struct WindowGrid {
  int bays = 0, floors = 0;
};

/// Of a wall that is `length_m` long: `bay_m` wide each, none where it is narrower than a window and its piers.
WindowGrid window_grid(double length_m, double bay_m, int floors);

/// A window and the wall around it: grey, 255 is the wall. Texels row by row from the bottom, kWindowTexels each way.
inline constexpr int kWindowTexels = 16;
std::vector<std::int32_t> window_pattern();
/// Of a wall under the pattern: as light in the mean as `colour` without it.
Colour under_windows(Colour colour);

/// shape_of, solid; faces with bays are under the pattern, and as light in the mean as without it.
/// Needs   as shape_of.
/// Differs from level 2 (facade_levels.hpp)   a place in the pattern for each corner in place of quads: paper 004 §4.2
/// has walls without windows from so far.
Node windowed_shape(const std::string& def, std::span<const Face> faces);

}  // namespace vicus
