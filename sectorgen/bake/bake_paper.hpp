#pragma once
#include "city_db/blockmap.hpp"
#include "city_db/blockmap_paper.hpp"
#include "sectorgen/bake/bake_scene.hpp"
#include "sectorgen/bake/blockmap_colours.hpp"

/// BlockMaps as the papers made them, for comparison: n:w as published are 16:64, 32:192, 64:256 in 2007, 128:512 in
/// 2009.
namespace vicus {

/// Source  paper 000 §3.1, §3.3; paper 001 §4.
/// Differs where the papers leave it open: a texel is house where half of it is covered, as high as the roof's mean
/// there;
///         boundaries are unfolded by walking from boundary texel to neighbouring boundary texel. Colours are the exact
///         means that ours have, in place of views (paper 001 §5 samples several: it is for what is no prism, and every
///         house of a city file is one). Terrain is not in the papers: heights count from the lowest ground.
PaperBlockMap bake_paper(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm, PaperYear year,
                         std::uint32_t side, std::uint32_t columns);

/// Its surface in our form: level cells without lines. Cast exactly, where the papers sample along the ray and miss
/// corners.
BlockMap surface_of(const PaperBlockMap& map);

/// Bytes of the texture in parts, each coded as suits it best: geometry without loss, colours and light as WebP of
/// quality 80.
double paper_sent_bytes(const PaperBlockMap& map);

/// What a hit on that surface looks like.
/// 2009: a side is roof where the cell rises less over the one before than 45 degrees (paper 001 §4, "sloped
/// rooftops").
HitLook look_of(const PaperBlockMap& map, const BlockMap& surface, const PlanRay& ray, const CastHit& hit);

}  // namespace vicus
