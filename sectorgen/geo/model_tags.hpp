#pragma once
#include "city_db/city.hpp"

/// CityGML's attributes of a house as OSM's tags.
namespace vicus {

/// `height_m`: of the model from foot to top; what is drawn, so it comes before what the attributes say.
/// roofType: the code list of CityGML 2.0 (OGC 12-019, annex C.1) and Germany's (ALKIS).
Tags model_tags(const Tags& attributes, double height_m);

}  // namespace vicus
