#pragma once
#include <optional>
#include <string>
#include <utility>

#include "city_db/city.hpp"

/// Places for doors on the facades of a house that people walk along.
namespace vicus {

/// The foot of a place on a straight stretch of a facade, ground on the left of a -> b.
struct FacadeSpot {
  std::string sector_id;
  PlanPoint a, b;
  double along_mm = 0;  ///< from a
  double distance_m = 0;
};

/// On the nearest facade of the house within `reach_m`.
std::optional<FacadeSpot> facade_spot(const City& city, const std::string& building_id, PlanPoint at, double reach_m);

/// In the middle of the house's longest stretch of facade that the room lies behind, no deeper than a doorway.
std::optional<PlanPoint> middle_of_longest_facade(const City& city, const std::string& building_id,
                                                  const Polygon& room);

/// An opening `width_m` wide around the spot, moved along the stretch until it is kFromCorner_m clear of its ends, and
/// into the house until its line lies inside the footprint.
/// Error   the line lies at most kMostInset_mm behind the facade.
/// Fails   nullopt: the stretch is too short, or too far from straight.
inline constexpr double kFromCorner_m = 0.3, kMostInset_mm = 8;
std::optional<std::pair<PlanPoint, PlanPoint>> opening_in(const FacadeSpot& spot, double width_m,
                                                          const Polygon& footprint);

}  // namespace vicus
