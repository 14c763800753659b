#pragma once
#include "city_db/ground_tile_layout.h"
#include "sectorgen/bake/cell_pieces.hpp"
#include "sectorgen/bake/webp_image.hpp"

/// What the ground of a tile looks like.
namespace vicus {

/// Ground that no surface covers: beyond the city's edge.
inline constexpr Colour kBeyondCity{GROUND_BEYOND_CITY >> 16, GROUND_BEYOND_CITY >> 8 & 0xff,
                                    GROUND_BEYOND_CITY & 0xff};

class GroundColours {
 public:
  /// Four samples a cell. `has_leaves`: with trees as discs of leaves, where nothing else shows them.
  GroundColours(const BakeScene& scene, const TileFrame& frame, bool has_leaves);
  ColourMean of_cell(std::size_t column, std::size_t row) const;  ///< kBeyondCity where no sample is ground
  /// N/2 x N/2, north row first. Where houses stand the colours around them go on, so that coding it costs little and
  /// the foot of a wall is never roof-coloured.
  /// Squares of reach_m and more without any ground are kBeyondCity; or as `larger` has them, north row first, with so
  /// many of its pixels beyond the tile on each side.   Needs   a pixel of `larger` is reach_m wide.
  RgbImage filled(double reach_m = 1e9, const RgbImage* larger = nullptr) const;

 private:
  void add_leaves(const BakeScene& scene, const TileFrame& frame);
  std::size_t side_;
  double texel_m_;                  ///< of filled()
  std::vector<std::uint8_t> kind_;  ///< 1 + SurfaceKind; 0: none; 15: leaves
};

/// Ambient light of roofs and ground, 255: the whole sky; N/2 x N/2 values, south row first. Of eight directions the
/// horizon within 32 m and 16 samples; the sky above it by the cosine law, and what walls reflect of it,
/// again and again.
/// Source  paper 001 §4 "Ambient occlusion".
/// Differs by horizons over the height field instead of counting views: no noise, 1/50 of the rays' cost. Houses beyond
///         the tile's rim count, so that tiles agree at their seams.
std::vector<std::uint8_t> ambient_light(const BakeScene& scene, const TileFrame& frame);

}  // namespace vicus
