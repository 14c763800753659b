#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/ground_piece.hpp"
#include "sectorgen/visibility/sight_map.hpp"

/// The plan as looks walk over it: triangles whose corners stand at walls, whatever sectors lie in them.
namespace vicus {

/// Sides as in SightCell.
struct LookCell {
  Corners corner{};
  std::array<std::uint32_t, 3> beyond{kNowhere, kNowhere, kNowhere};
  std::uint32_t sector = kNowhere;                   ///< all of it lies in that one; kNowhere: in several, or in none
  std::uint32_t first_piece = 0, pieces_behind = 0;  ///< what it says of itself only by its pieces
};

struct LookMap {
  std::vector<LookCell> cells;                         ///< those of one sector stand together, the others at the end
  std::vector<std::uint32_t> begin;                    ///< per sector its first cell, and one more
  std::vector<GroundPiece> pieces;                     ///< sectors where a cell has several, houses that stop no look
  std::vector<std::vector<std::uint32_t>> own_groups;  ///< per sector: groups over its ground and at its walls
  /// Per cell of the sight map, cells of this one with which it shares inner points: from first_of[c] to first_of[c +
  /// 1].
  std::vector<std::uint32_t> first_of, cells_of;
  std::vector<std::uint8_t> loose_corners;  ///< per cell of the sight map: bit k: its corner k stands at no wall
  std::vector<char> is_loose;               ///< per sector: its rim has such a corner

  bool is_loose_corner(std::uint32_t sight_cell, std::size_t k) const {
    return (loose_corners[sight_cell] >> k & 1) != 0;
  }
};

/// What stops no look has no corners here. In a triangulation of all rings a look divides at every corner that it
/// passes; at one in the open nothing is gained by it, and both parts go on over the same ground: k such corners make
/// it as much as k^2 looks. (Berlin Mitte: 9 % of all corners, 75 % of all divisions.)
///
/// Walls' sides are the same as in the sight map; edges of sectors from wall to wall are sides, too.
/// Needs   `sight` as made by make_sight_map.
/// Cost    n log n: one triangulation; each triangle of the sight map asks those that lie over it.
LookMap make_look_map(const SightMap& sight);

}  // namespace vicus
