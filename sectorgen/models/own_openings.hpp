#pragma once
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

namespace vicus {

/// The windows and doors of a house's own model, on its facades: each goes to the facade whose wall it lies in, within
/// 0.8 m before or behind, else 2.5 m, as the upright rectangle around it. Sets openings, and floors, bays, repeats and
/// the door's bay to count them. Error   what reaches over the facade's edges is cut off; of two that overlap the
/// smaller one yields, and goes where
///         less than half of it would be left; narrower or lower than 0.2 m: left out.
/// Needs   all facades are one house's, with a and b, bottom and top. Returns  how many openings found a facade.
std::size_t hang_openings(const HouseModel& model, const std::vector<Facade*>& facades);

}  // namespace vicus
