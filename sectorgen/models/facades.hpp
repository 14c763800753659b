#pragma once
#include <map>
#include <string>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

namespace vicus {

/// Colours of all houses, and windows, doors and shop fronts of all facades that face walkable ground: straight
/// stretches of facade borders of 3 m and more. What nobody can see is not modelled. Doors stand where the map has an
/// entrance, else in the middle of the house's longest facade; a shop's facade is the one nearest to where it is
/// mapped. A house whose model has windows or doors shows those and no others (own_openings.hpp). Needs   sectors,
/// borders, buildings and objects, with their final ids. Source  paper 004 §4.2; research/HOUSES.md §3.
void lay_out_facades(City& city, const std::map<std::string, HouseModel>& models = {});

/// Paints the textures of all facades that have none yet (photo_facades.hpp) the atlas of windows and doors
/// (meta["atlas"]) and the ground's grain (meta["grain"]), each picture once. One picture serves all facades of the
/// same style, colour, storeys, bays, door and shop. Cost    about 10 ms a picture; Rochechouart's 900 facades need
/// some 300.
void paint_textures(City& city, unsigned threads);

}  // namespace vicus
