#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "city_db/city.hpp"

/// The plan as sight sees it: triangles of everything that does not stop a level look, with what lies beyond each side.
namespace vicus {

inline constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
/// From here on values of SightCell::beyond are walls: the look ends there.
inline constexpr std::uint32_t kWall = 0x80000000u;

/// What reaches higher than this stops a look in plan; what is lower does not. Above the highest eye (kEyeTop_m), so
/// that no eye looks down over a stopper at the ground behind it.
inline constexpr double kStopsSight_m = 2.5;

/// Does the house, or the wall, stop a look in plan? Not those that one walks below.
bool stops_sight(const Building& building);
bool stops_sight(const Obstacle& obstacle);

/// Side k is opposite corner k, from corner k + 1 to corner k + 2 (mod 3), the triangle on its left.
struct SightCell {
  std::array<PlanPoint, 3> corner{};
  /// Per side: 4 * cell + side of the cell beyond; kWall + group: walls of these houses; kNowhere: another end.
  std::array<std::uint32_t, 3> beyond{kNowhere, kNowhere, kNowhere};
  std::uint32_t sector = kNowhere;  ///< kNowhere: ground of no sector: water, a shut yard, beyond the city
  std::uint32_t group = 0;          ///< houses over some point of it that do not stop a look
};

struct SightMap {
  std::vector<SightCell> cells;      ///< those of one sector stand together, those of none at the end
  std::vector<std::uint32_t> begin;  ///< per sector its first cell, and one more: the first of none
  /// Groups of houses whose owners are not the sector of the cell that names them. The first is empty.
  std::vector<std::vector<std::uint32_t>> groups;
  std::vector<std::uint32_t> owner;  ///< per house: the sector that sends its roof, and walls that are no facades

  std::size_t sector_count() const { return begin.size() - 1; }
};

/// Cells for the sectors' grounds, water, fences, low walls, shut ground, low houses, and the ground beyond the city as
/// far as its convex hull: no line between two sectors leaves it.
///
/// Frame   the plan lattice. Sectors and houses by their index in the city.
/// Needs   a city that keeps rules 1 and 2 of DESIGN §3: everything noded, sectors disjoint.
/// Cost    n log n: one triangulation of all rings, one flood that counts covers.
SightMap make_sight_map(const City& city);

}  // namespace vicus
