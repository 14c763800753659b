#pragma once
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/models/roof_build.hpp"

/// What roof each house shall have: from its tags, else guessed.
namespace vicus {

struct RoofWish {
  RoofRequest request;
  RoofSource source = RoofSource::rule;
};

/// One wish per building. Guesses, the first that has something to say:
///   neighbours  most of the 5 nearest houses of like area (half to twice) within 120 m that are tagged;
///   preset      Paris: mansard from 12 m of height on;
///   rule        gabled: 25 to 150 m2, at most 6 corners, at most 7.5 m high, 9 m wide, fills its rectangle by 0.7;
///               else flat. What hangs over ground or stands on posts is flat.
/// Rise: roof:height, roof:levels x 3 m, roof:angle, or what heights.hpp left between eave and top; else
/// min(3.2 m, 0.66 width), mansard 4.6 m, at most 0.375 of the house's height.
/// Ridge: roof:orientation, roof:direction (that water runs to); else perpendicular to party walls where the plan is
/// less than twice as long as wide; else along the longer side.
/// Source  research/HOUSES.md §1.3, §2; errors: docs/houses.md.
std::vector<RoofWish> guess_roofs(const City& city);

}  // namespace vicus
