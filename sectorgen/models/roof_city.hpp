#pragma once
#include <map>
#include <string>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// The roofs of a city's houses.
namespace vicus {

/// Gives every building its roof, and with it roof_shape, roof_source and eave_m; side walls follow the new eaves.
/// Houses with a model (by source_id) get the model's roof; where that fails (issue model_unused), and without one, a
/// roof of the shape that their tags or neighbours call for.
/// Needs   buildings, borders and side walls as the sectors stage leaves them.
void roof_houses(City& city, const std::map<std::string, HouseModel>& models = {});

/// Walls above a lower neighbour again, from the buildings' eaves and the levels that they stand at; walls towards
/// closed ground stay, and go down to the house's foot.
void update_side_walls(City& city);

}  // namespace vicus
