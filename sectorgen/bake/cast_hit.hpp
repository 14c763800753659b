#pragma once
#include <cstdint>
#include <limits>

/// Rays and what they meet in a BlockMap.
namespace vicus {

/// Metres in the plan frame, up above its 0. The direction need not be of length 1: t counts in its lengths.
struct PlanRay {
  double x = 0, y = 0, z = 0, dx = 0, dy = 0, dz = 0;
};

/// plane: the cell's plane. foot: the level surface beyond its line. line: the wall over the line. side: the cell's
/// side where the ray came in.
enum class CastSurface : std::uint8_t { none, plane, foot, line, side };
enum class CellSide : std::uint8_t { east, north, west, south, none };

struct CastHit {
  double t = std::numeric_limits<double>::infinity();
  CastSurface surface = CastSurface::none;
  CellSide side = CellSide::none;  ///< of a side: which one
  std::uint32_t cell = 0;
  explicit operator bool() const { return surface != CastSurface::none; }
};

}  // namespace vicus
