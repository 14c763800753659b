#pragma once
#include <cstdint>

#include "city_db/city.hpp"

/// L_vis of a city (DESIGN §5): both lists, as records.
namespace vicus {

/// Cities of more sectors get no list over roofs unless asked for.
inline constexpr std::size_t kSectorsOverRoofs = 1500;
/// Lower houses are not looked for where landmarks alone are asked for.
inline constexpr double kLandmark_m = 40;
enum class OverRoofs { automatic, yes, landmarks, no };

struct VisibleOptions {
  unsigned threads = 0;  ///< 0: all cores
  OverRoofs over_roofs = OverRoofs::automatic;
  double least_radius_m = 0.125;  ///< how far eyes and walls are told apart over roofs (docs/visibility.md)
  std::uint64_t step_budget = 40'000'000;
};

/// Fills City::visible: for each sector itself, those behind its gates, those in line of sight, and with the reason
/// over_roofs those of which houses are seen alone: over roofs, or on the level from behind. By sector, then visible
/// sector. Sets meta "over_roofs" to yes, landmarks or no: which list over roofs was made.
///
/// Error   a superset of the truth. Raises  404 sight_over_budget where two such sectors list each other unproved.
/// Needs   sectors with their ids, gates, borders, buildings.
void list_visible(City& city, const VisibleOptions& options);

}  // namespace vicus
