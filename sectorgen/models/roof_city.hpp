#pragma once
#include "city_db/city.hpp"

/// The roofs of a city's houses.
namespace vicus {

/// Gives every building its roof, and with it roof_shape, roof_source and eave_m; side walls follow the new eaves.
/// Needs   buildings, borders and side walls as the sectors stage leaves them.
void roof_houses(City& city);

/// Walls above a lower neighbour again, from the buildings' eaves; walls towards closed ground stay.
void update_side_walls(City& city);

}  // namespace vicus
