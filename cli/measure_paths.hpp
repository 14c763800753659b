#pragma once
#include <cstdint>
#include <vector>

#include "city_db/city.hpp"
#include "city_db/tour.hpp"
#include "cli/measure_pose.hpp"
#include "sectorgen/sectors/tours/guide.hpp"

/// The ways along which a city is looked at.
namespace vicus::measure {

inline constexpr double kWalk_m = 400, kFly_m = 3000, kFlyUp_m = 150, kFlyDown_deg = 30, kOverviewDown_deg = 45;
inline constexpr double kFlySpeed_m_s = 30;

/// A tour (sectorgen/sectors/tours) of streets that `seed` draws from the middle of the city, over a
/// square where there is one: of those tried that are kWalk_m long the one that stays nearest to the middle, else the
/// longest.
/// Fails   CityError: the city has no two places to walk between.
Tour walk_tour(const Guide& guide, const City& city, std::uint64_t seed);
/// Looks the way the tour goes, level.   Needs   0 <= along_m <= length_m (assert).
Pose walk_pose(const Tour& tour, double along_m);

/// A circle round the middle of the houses, as large as the city allows, flown until kFly_m are done; looks forwards,
/// 60 degrees inwards and kFlyDown_deg down, so that a small town stays in view.
class FlyPath {
 public:
  explicit FlyPath(const City& city);
  Pose at(double along_m) const;
  double radius_m() const { return radius_m_; }

 private:
  const City* city_;
  double east_ = 0, north_ = 0, radius_m_ = 0;
};

/// From the south, kOverviewDown_deg down, as near as all houses are in view. `field_of_view`: rad.
Pose overview_pose(const City& city, double field_of_view);

/// `count` places, the first at 0, the last at `length_m`; one: in the middle.
std::vector<double> key_places(double length_m, std::size_t count);

}  // namespace vicus::measure
