#pragma once
#include "city_db/facade_layout.hpp"
#include "sectorgen/models/canvas.hpp"

namespace vicus {

/// One pattern of the facade, for the third level of detail: the wall by style and colour, with the openings where
/// facade_layout.hpp puts them. About 13 pixels a metre, sides powers of two, at most 512.
/// Source  paper 004 §4.2; recipe and figures: research/HOUSES.md §4.
Canvas paint_facade(const Facade& facade, Colour wall);

}  // namespace vicus
