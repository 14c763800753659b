#pragma once
#include "city_db/city.hpp"

namespace vicus {

/// Of the visible sector only the houses named are needed, nothing of its ground: they are seen over roofs. On a slope
/// the ground may be seen over lower houses as well; such a row names no houses.
inline bool is_of_houses_alone(const Visible& v) {
  return v.reason == VisibleReason::over_roofs && !v.building_ids.empty();
}

}  // namespace vicus
