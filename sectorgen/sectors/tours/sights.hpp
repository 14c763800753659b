#pragma once
#include <functional>
#include <vector>

#include "city_db/tour.hpp"

/// Ready-made tours.
namespace vicus {

/// Round trips: past the sights nearest to the middle of all sights, past more of them, and over the squares; none
/// where fewer than kFewestStops are to be seen. Stops follow each other so that the walk is short: each next one the
/// nearest, then two pieces exchanged as long as that shortens it (2-opt). Needs   sights put on the ground; walk_m(a,
/// b): length of the walk, < 0: there is none.
std::vector<TourProposal> propose_tours(const std::vector<TourPlace>& sights,
                                        const std::function<double(const TourPlace&, const TourPlace&)>& walk_m);

inline constexpr std::size_t kFewestStops = 3;

}  // namespace vicus
