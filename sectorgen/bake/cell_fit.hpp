#pragma once
#include <functional>

#include "sectorgen/bake/cell_pieces.hpp"

/// The plane and the line of one cell (blockmap.hpp) from what stands in it.
namespace vicus {

/// Units of one tile.
struct CellUnits {
  double cell_m = 1, step_m = 0.01;
};

/// The bare ground of a cell: metres above the base plane at the middle, metres a cell.
struct CellGround {
  double up = 0, east = 0, north = 0;
  double rough_m = 0;  ///< the ground leaves this plane by no more within the cell
  double up_at(CellPoint p) const { return up + east * p.x + north * p.y; }
};

/// As stored, and what the baker goes on with.
struct CellFit {
  std::uint16_t height = 0, foot = 0;
  std::uint8_t slope_east = 0, slope_north = 0, angle = 0, offset = 0;
  double top_m = 0;           ///< no surface of the cell is higher above the base plane
  double error_m = 0;         ///< bound of the distance of true points of the cell from its surface, and back
  double back_m = 0;          ///< the part of it that is the way back: from the line to the true walls
  bool ground_above = false;  ///< ground is among what the plane stands for
  std::uint32_t above = 0;    ///< bit i: roof piece i belongs to the plane (of the first 31; of the others bit 31)
};

/// Fits one cell after the other of a tile.
///
/// Error   error_m is measured at every corner of every piece after rounding to stored numbers. Of a piece on its own
///         side of the line it is how far the plane passes from it; else the distance to the wall over the line, if
///         that is less. Gaps between roofs of kRounding_m and less are rounding of their corners to 1 mm, and no
///         ground.
/// Source  line: Laine & Karras, "Efficient sparse voxel octrees", I3D 2010 (contours); its normal by the divergence
///         theorem from how much of each side of the cell is covered, its offset from the covered area.
class CellFitter {
 public:
  /// Needs   `pieces` outlives it.
  CellFitter(const CellPieces& pieces, const CellUnits& units);
  CellFit fit(std::size_t cell, const CellGround& ground);
  /// The corners of what stands in the cell, with their heights.
  void true_corners(std::size_t cell, const CellGround& ground,
                    const std::function<void(CellPoint at, double up_m)>& take);

 private:
  /// What a cell is made of: roof pieces and the bare ground. Moments over its area, around the cell's middle.
  struct Part {
    double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  ///< area and integrals
    double up = 0, east = 0, north = 0;                     ///< its plane at the middle
    double mean_up = 0;
    const RoofPiece* piece = nullptr;  ///< null: ground
    std::size_t index = 0;
  };
  struct Plane;
  struct Chord;
  void collect(std::size_t cell);
  void sort_by_height();
  std::size_t best_split() const;
  CellFit with_plane(std::size_t first) const;
  CellFit with_line(std::size_t first) const;
  Plane plane_of(const CellFit& f) const;
  double plane_error(CellFit& f) const;
  void add_line(CellFit& f) const;
  double line_error(CellFit& f) const;
  bool covers(CellPoint at) const;
  template <class Take>
  void ground_corners(Take take) const;

  const CellPieces& pieces_;
  CellUnits units_;
  CellGround ground_;
  std::span<const RoofPiece> roofs_;
  std::span<const WallPiece> walls_;
  std::vector<Part> parts_;  ///< by height
};

inline constexpr double kRounding_m = 0.004;

/// Does piece `index` of the cell's roof pieces belong to the plane?
inline bool is_above(const CellFit& fit, std::size_t index) {
  return (fit.above >> (index < 31 ? index : 31) & 1u) != 0;
}

}  // namespace vicus
