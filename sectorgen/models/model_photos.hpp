#pragma once
#include <map>
#include <string>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

namespace vicus {

/// Images on the walls of houses that came as models, as textures of their facades (as hang_photos does it): of each
/// facade that such walls cover by half and more. Needs   facades laid out, not yet painted. Fails CityError: an image
/// that cannot be read.
/// Error   an image's places are taken as linear over a wall; walls count as on the facade within 0.5 m.
void hang_model_photos(const std::map<std::string, HouseModel>& models, City& city);

}  // namespace vicus
