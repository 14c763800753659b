#pragma once
#include <cstddef>
#include <vector>

#include "sectorgen/town/network.hpp"

/// Facade lines: where the houses of a block meet the street.
namespace vicus::town {

struct Side {
  Polyline front;  ///< counter-clockwise around the block, corner to corner
  std::size_t line = 0;
  bool is_left = true;             ///< of the line's direction
  double first_m = 0, last_m = 0;  ///< chainage along the line at both ends of `front`
};

inline constexpr double kWallSetback = 9;  ///< m from ring street to facade line where the town wall stands between

/// The sides of a face, each set back from its street's centre line by the half width plus extra(line, is_left).
/// Needs   a bent network.
/// Returns nothing when the streets leave no block between them.
struct Setback {
  double jitter = 0;  ///< m, drawn per side
  double wall = 0;    ///< m, where the town wall runs between street and block
};
std::vector<Side> facade_sides(const Network& network, std::size_t face, const Setback& setback, std::uint64_t seed);

Ring ring_of(const std::vector<Side>& sides);

/// Does the town wall stand before this side?
inline bool is_walled(const Network& n, const Side& side) { return n.lines[side.line].has_wall && side.is_left; }

}  // namespace vicus::town
