#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// Truth by rays, for what L_vis must hold: Embree finds the first thing each ray meets.
namespace vicus::test {

struct RayReport {
  std::uint64_t rays = 0;
  std::uint64_t pairs_seen = 0;      ///< different (sector, visible sector) found by rays
  std::uint64_t showings_seen = 0;   ///< different (sector, visible sector, house)
  std::vector<std::string> missing;  ///< seen by a ray and by rays beside it, but not in City::visible
};

/// Eyes anywhere in a sector, 2 cm off its rim, 1.2 to 2.0 m up; packets of 16 rays: half of them towards one house
/// (near the top of its walls), half round about. What a ray meets is a house's wall (the sector whose border it is,
/// else the house's own), a roof (the house's own sector), or a sector's ground. A pair whose reason is over_roofs must
/// name the house.
///
/// Where the lists over roofs were not made (meta over_roofs), what a rising ray meets counts only when a level one in
/// the same direction meets the same house: nothing is asked that is seen over what stops a level look. With a terrain
/// each house's own 0 is the ground's height at one of its corners, houses reach down for ever, and walls stop no
/// ray; what is met below the ground, asked each half metre, does not count. One packet in four is then aimed at a
/// place on some sector's ground.
///
/// Frame   each eye's own: 32-bit floats hold under 0.1 mm within 1 km.
/// Needs   City::visible.
RayReport shoot_rays(const City& city, std::uint64_t rays, std::uint64_t seed, unsigned threads = 0);

}  // namespace vicus::test
