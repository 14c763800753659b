#pragma once
#include "city_db/shape.hpp"
#include "city_db/shape_ground.hpp"

namespace vicus {

/// The named streets' share of ShapeReport.
NamedStreets measure_named_streets(const City& city, const GroundMap& ground);

}  // namespace vicus
