#pragma once
#include "city_db/facade_layout.hpp"
#include "sectorgen/models/canvas.hpp"

/// Windows, doors and shop fronts: the same strokes in a facade's texture and in the atlas.
namespace vicus {

/// Fills the opening's rectangle. `variant` chooses curtains and how dark the glass is.
void paint_opening(Canvas& canvas, const Opening& opening, int variant);

/// The tile of the atlas that holds one kind: the opening alone fills it.
Canvas paint_tile(OpeningKind kind);

/// All tiles (facade_layout.hpp's atlas_tile says where).
Canvas paint_atlas();

}  // namespace vicus
