#pragma once
#include "city_db/city.hpp"

namespace vicus::test {

/// sample_city_with_facades with two rooms in house b-8: a hall behind a door to s-main-e, and a kitchen beside it.
///
///     y=-5    ----[door hall-d1: x 10 ... 11]---- facade of b-8
///     y=-5.3  +--------- hall ----------+
///             |  x 6 ... 14             [kitchen-d1] kitchen, x 14.2 ... 20
///     y=-12   +-------------------------+
City sample_city_with_interior();

}  // namespace vicus::test
