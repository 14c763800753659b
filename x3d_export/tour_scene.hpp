#pragma once
#include <string>
#include <vector>

#include "city_db/tour.hpp"
#include "x3d_export/city_index.hpp"
#include "x3d_export/scene.hpp"

/// A tour as a world that walks by itself (paper 004 §3, precalculated walks; §5, the sectors of a path).
namespace vicus {

/// Where one looks so far along the way.
struct TourLook {
  double walked_m = 0;
  double heading_rad = 0;  ///< clockwise from north; goes on beyond half a turn, so that it never jumps
};

/// Headings every kLookStep_m, and at the end: the way's own direction, averaged from kLookSpan_m before to as far
/// after. Bound   |change| <= the way's turning within that span / (2 kLookSpan_m) per metre: a corner of 90 degrees is
/// spread
///         over 4 m, at walking speed 2.9 s.
std::vector<TourLook> tour_looks(const Tour& tour);

/// The sectors of the tour, and what they see as far files; a Viewpoint that goes along the way at a steady speed from
/// the moment it is bound. Valid without the page and without a Script.
/// Frame   as root_scene.
/// nullopt: the city has none of the tour's sectors.
std::optional<Scene> tour_scene(const RecordSource& source, const Tour& tour);

inline constexpr double kLookStep_m = 0.5, kLookSpan_m = 2;
inline constexpr std::size_t kMostFarSectors = 120;  ///< of one tour's world; the nearest to its beginning first

}  // namespace vicus
