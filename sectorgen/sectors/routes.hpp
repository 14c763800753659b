#pragma once
#include <string>
#include <vector>

#include "sectorgen/geo/source_map.hpp"
#include "sectorgen/sectors/ground.hpp"

/// Streets pushed into the dual graph of the ground and reduced there (research/SECTORS.md §0.1, §4.3).
namespace vicus {

/// Millimetres of a named axis inside a triangle.
struct NameUse {
  std::uint32_t triangle = 0;
  std::uint32_t name = 0;  ///< index into StreetRoutes::names
  std::int64_t mm = 0;
};

struct StreetRoutes {
  std::vector<char> is_used;       ///< per edge id: some reduced axis crosses it
  std::vector<char> is_reached;    ///< per triangle: an axis or a square lies in its component of the ground
  std::vector<std::string> names;  ///< sorted
  std::vector<NameUse> uses;
};

/// Every axis becomes the sequence of free edges it crosses, back-tracking cancelled; parallel carriageways, tram lanes
/// and pavements between the same facades give the same sequence. Stubs shorter than max(15 m, their mouth) are pruned.
/// A street that passes over another one (no common point, a higher level) makes no junction with it: the ground below
/// its deck belongs to the lower street, so the upper one ends at its sides.
/// Components of the ground that no axis and no square reaches are not used. Ground without any axis gets the network
/// of its wide passages instead (edges of at least kWideMm), so that a map without streets still becomes a city. Error
/// none: exact walk; an axis through a vertex is taken as passing on its left.
StreetRoutes route_axes(const Ground& ground, const std::vector<Axis>& axes, const std::vector<Area>& areas);

/// Points at most kReachMm apart along every axis and square's outline: ground without any is not walked on.
std::vector<PlanPoint> reach_points(const std::vector<Axis>& axes, const std::vector<Area>& areas);
inline constexpr std::int64_t kReachMm = 2'000;

inline constexpr std::int64_t kWideMm = 4'000;

/// Used edges of triangle t.
int used_count(const Ground& ground, const StreetRoutes& routes, std::uint32_t t);

/// Twice the distance of the midpoints of two edges of one triangle, and other lengths along chains, in mm.
std::int64_t midpoint_distance_mm(const Ground& ground, std::uint32_t t, int k, int m);

}  // namespace vicus
