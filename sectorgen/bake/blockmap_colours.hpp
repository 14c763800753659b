#pragma once
#include <optional>

#include "city_db/blockmap.hpp"
#include "sectorgen/bake/cast_hit.hpp"
#include "sectorgen/bake/webp_image.hpp"

namespace vicus {

/// What a hit looks like, and how the surface lies there.
struct HitLook {
  Colour colour;
  double east = 0, north = 0, up = 1;  ///< unit normal
  double ambient = 1;
  bool is_lit = false;  ///< the colour is what the world's lights show; then no normal is given
};

/// The pictures of a tile; no ambient light: none of it is blocked.
struct TilePictures {
  RgbImage roof, ground, ambient, wall;
};
/// Unpacked; nullopt: one is damaged or of another size.
std::optional<TilePictures> tile_pictures(const BlockMap& map);
/// Width and height of the picture of wall columns.
std::pair<std::uint32_t, std::uint32_t> wall_atlas_size(std::uint32_t columns, std::uint32_t rows);

/// The pictures of a tile, unpacked; the rules of colouring that caster and shader share are said here.
///
/// All pictures show what the world's lights (surroundings.hpp) make of the true faces: of a roof's two slopes in one
/// cell the mean of both.
///
/// plane   the roof picture. foot: the roof picture one or two cells on, in the direction of the line's normal, of the
///         first whose plane, carried on, lies within wall_step of the foot; else the ground picture.
/// side    not more than wall_step below the plane: the plane's. Else the column of that side; else the cell's line;
/// else
///         the line of the cell that the ray came from; else the plane's.
/// light   of planes and feet: the ambient picture. Of walls: that of two cells before them at the foot, all at the
/// top.
class BlockMapColours {
 public:
  /// Needs   `map` outlives it; pictures of its sizes.
  BlockMapColours(const BlockMap& map, TilePictures pictures);
  HitLook look(const PlanRay& ray, const CastHit& hit) const;

 private:
  Colour wall(std::size_t cell, std::uint8_t bit, double up) const;
  Colour foot(std::size_t cell) const;
  const BlockMap* map_;
  TilePictures pictures_;
  std::vector<std::uint8_t> walls_;
  std::vector<std::uint32_t> first_;
};

}  // namespace vicus
