#pragma once
#include <string>

#include "city_db/units.hpp"

namespace vicus::measure {

/// walk: along streets, eye 1.7 m up. fly: 150 m up, 30 degrees down. overview: one view of the whole city.
enum class Path { walk, fly, overview };
const char* name_of(Path);

/// Where a visitor is and what he looks at.   Frame   plan frame.
struct Pose {
  Path path = Path::walk;
  double along_m = 0;
  Enu eye, look;
  std::string sector_id;  ///< walk: the sector he is in
};

}  // namespace vicus::measure
