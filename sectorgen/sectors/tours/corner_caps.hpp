#pragma once
#include <vector>

#include "sectorgen/sectors/tours/walk_mesh.hpp"

/// How far a walk keeps off walls.
namespace vicus {

/// One cap for each corner that a walk could bend at.
///
/// A shortest walk is straight but where it bends, and it bends at corners only: what keeps it off the corners keeps it
/// off the walls. Between two bends it is no nearer to a straight wall than at the bends, or its own ends.
///
///       ground      m1---m0      the wall turns at v; m0, m1 are where the tangents of the circle around v meet, over
///                    \   /       the arc that a taut walk can lean on, at most 45 degrees each
///                     \ /
///       ___________ w  v         radius: clearance, but at most kRoomShare of the way to the nearest wall across:
///       wall           |         each side of a narrow place leaves the middle free
///                      | wall
///
/// Needs   `bare`: make_walk_mesh without caps; clearance_mm > 0.
/// Source  the idea that clearance is kept where there is room and given up where there is none: Wein, van den Berg &
///         Halperin, "The visibility-Voronoi complex and its applications", SoCG 2005.
/// Differs room is measured at corners, not along a Voronoi diagram.
std::vector<CornerCap> corner_caps(const WalkMesh& bare, std::int32_t clearance_mm);

/// The ground less corner_caps(), with no part of more than kPocket_m2 cut off from what it is joined to without: caps
/// that would do so are made smaller. Smaller pockets are left out.
/// Needs   clearance_mm >= 0; 0: make_walk_mesh without caps.
WalkMesh make_clear_walk_mesh(const std::vector<Sector>& sectors, const std::vector<Gate>& gates,
                              std::int32_t clearance_mm);

inline constexpr std::int32_t kWalkClearance_mm = 400;  ///< half of a person's breadth and an arm's ease
inline constexpr double kRoomShare = 0.45;              ///< below a half: caps on both sides of a gap never meet
inline constexpr double kPocket_m2 = 1;                 ///< ground that nobody misses

}  // namespace vicus
