#pragma once
#include <functional>

#include "x3d_export/mesh.hpp"
#include "x3d_export/roof_mesh.hpp"

/// What of a house is no facade: roof, side walls, chimneys; all of a house that one walks under.
namespace vicus {

/// Top of a house's walls, metres above ground: the eave, where the roof begins.
double wall_top_m(const Building& house);

/// Roof and side walls, but those that `is_drawn_elsewhere` is true of (it may be empty); of a house over a passage
/// also its outer walls and underside. `facade_top`, `step_wall`: see add_roof.
void add_body(FaceList& faces, const Building& house,
              const std::function<bool(const SideWall&)>& is_drawn_elsewhere = {}, const WallTop& facade_top = {},
              const StepWall& step_wall = {});

inline constexpr int kChimneyTriangles = 10;
/// At most `most` chimneys in the middle of the roof's largest triangles: one to 70 m2 of houses that are lived in.
void add_chimneys(FaceList& faces, const Building& house, int most);

}  // namespace vicus
