#pragma once
#include <cstdint>
#include <vector>

#include "city_db/city.hpp"

/// A walk along real streets.
namespace vicus::test {

struct WalkPlace {
  std::uint32_t sector = 0;
  double east_m = 0, north_m = 0;
};

/// Places every `step_m` metres along a way of `length_m`: from the middle of a gate to the middle of another, through
/// the middles of the sides between the ground's triangles, so never outside the sector. Where there is a choice, into
/// the sector that was entered least; among equals the seed says. It begins in the named street sector that has most
/// gates. Shorter where no gate leads on.
/// Needs   a city that keeps rules 1 and 2 of DESIGN §3.
std::vector<WalkPlace> walk_streets(const City& city, double length_m, double step_m, std::uint64_t seed);

}  // namespace vicus::test
