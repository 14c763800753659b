#pragma once
#include <string>
#include <vector>

#include "city_db/tour.hpp"

/// Tours and places as JSON: what /tours, /search and `vicus tour --json` give.
///
/// Frame   `at`, `look`: plan-frame metres, east then north, 3 decimals; `lat`, `lon`: degrees; `ground`: metres.
///         `points`: [east, north, ground, walked] each.
namespace vicus {

std::string tour_json(const Tour& tour);
std::string tour_proposals_json(const std::vector<TourProposal>& proposals);
std::string places_json(const std::string& typed, const std::vector<TourPlace>& places);

}  // namespace vicus
