#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "city_db/blockmap.hpp"
#include "sectorgen/bake/bake_paper.hpp"
#include "sectorgen/bake/blockmap_caster.hpp"
#include "sectorgen/bake/blockmap_colours.hpp"
#include "sectorgen/bake/render/render.hpp"

/// Pictures of tiles and triangles together, in the light of every other picture (render/shading.hpp).
namespace vicus::measure {

/// A height field that rays meet.
class CastTile {
 public:
  virtual ~CastTile() = default;
  virtual CastHit cast(const PlanRay& ray, double before) const = 0;
  virtual HitLook look(const PlanRay& ray, const CastHit& hit) const = 0;
  PlanBox box;  ///< in plan
};

/// Fails   CityError: a picture in it is damaged.
std::shared_ptr<const CastTile> cast_tile(BlockMap map);
std::shared_ptr<const CastTile> cast_tile(BlockMap map, TilePictures pictures);  ///< in place of its own
std::shared_ptr<const CastTile> cast_tile(PaperBlockMap map);

/// Differs light from the sky, which BlockMaps carry, is left out: the truth has none.
class TileTracer : public Tracer {
 public:
  TileTracer(std::vector<std::shared_ptr<const CastTile>> tiles, RenderMesh mesh);
  std::optional<Met> meet(const Vec3& from, const RaySample& sample, double least) const override;
  std::optional<double> distance(const Vec3& from, const Vec3& way, double least) const override;

 private:
  struct Nearest {
    CastHit hit;
    const CastTile* tile = nullptr;
  };
  Nearest nearest(const PlanRay& ray, double before) const;
  std::vector<std::shared_ptr<const CastTile>> tiles_;
  RayScene scene_;
  SceneTracer mesh_;
};

}  // namespace vicus::measure
