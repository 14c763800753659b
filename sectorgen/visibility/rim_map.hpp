#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/look_map.hpp"

/// A look map in which the rim of one sector at a time is made of sides, so that looks can begin there.
namespace vicus {

/// Where the rim has corners that stand at no wall, the cells that it passes are triangulated anew with it.
///
/// Cost    a copy of the cells; to turn to another sector: a triangulation of the cells round its loose corners.
class RimMap {
 public:
  /// Keeps both by reference.
  RimMap(const SightMap& sight, const LookMap& looks);

  /// From now on each cell is wholly in the sector, or wholly outside.
  void turn_to(std::uint32_t sector);

  const LookCell& cell(std::uint32_t c) const { return cells_[c]; }
  std::uint32_t index_of(const LookCell& cell) const { return static_cast<std::uint32_t>(&cell - cells_.data()); }
  const GroundPiece& piece(std::uint32_t p) const { return pieces_[p]; }
  /// Those of the sector turned to.
  const std::vector<std::uint32_t>& own_cells() const { return own_; }
  std::size_t size() const { return cells_.size(); }

 private:
  struct Undo {
    std::uint32_t side, beyond;  // a side of a cell that stays, as it was
  };
  struct Cut;

  void put_back();
  void find_cut(Cut& cut, std::uint32_t sector);
  void triangulate(const Cut& cut, std::uint32_t sector);
  void link(std::uint32_t side, std::uint32_t to);
  void describe(LookCell& cell, const std::vector<GroundPiece>& below, std::uint32_t sector);

  const SightMap& sight_;
  const LookMap& looks_;
  std::vector<LookCell> cells_;
  std::vector<GroundPiece> pieces_;
  std::vector<std::uint32_t> own_;
  std::vector<Undo> undo_;
  std::vector<char> is_cut_;  // per cell, while cut cells are looked for
};

}  // namespace vicus
