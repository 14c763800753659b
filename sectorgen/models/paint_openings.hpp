#pragma once
#include "city_db/facade_layout.hpp"
#include "sectorgen/models/canvas.hpp"

/// Windows, doors and shop fronts: the same strokes in a facade's texture and in the atlas.
namespace vicus {

/// Fills the opening's rectangle with the tile of its kind, as levels 2 and 4 show it: with curtains, glass and bars of
/// its own each window would change when the level of detail does.
void paint_opening(Canvas& canvas, const Opening& opening);

/// The tile of the atlas that holds one kind: the opening alone fills it.
Canvas paint_tile(OpeningKind kind);

/// All tiles (facade_layout.hpp's atlas_tile says where).
Canvas paint_atlas();

}  // namespace vicus
