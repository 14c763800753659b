#include "cli/measure_tile_tracer.hpp"

#include <algorithm>
#include <cmath>

#include "city_db/issues.hpp"
#include "sectorgen/bake/render/shading.hpp"

namespace vicus::measure {
namespace {

PlanBox box_of(PlanPoint corner, std::uint32_t side_mm) {
  return {corner,
          {static_cast<std::int32_t>(std::int64_t{corner.x} + side_mm),
           static_cast<std::int32_t>(std::int64_t{corner.y} + side_mm)}};
}

class OurTile : public CastTile {
 public:
  OurTile(BlockMap map, TilePictures pictures)
      : map_(std::move(map)), caster_(map_), colours_(map_, std::move(pictures)) {
    box = box_of(map_.corner, map_.tile_side_mm);
  }
  CastHit cast(const PlanRay& ray, double before) const override { return caster_.cast(ray, before); }
  HitLook look(const PlanRay& ray, const CastHit& hit) const override { return colours_.look(ray, hit); }

 private:
  BlockMap map_;
  BlockMapCaster caster_;
  BlockMapColours colours_;
};

class PaperTile : public CastTile {
 public:
  explicit PaperTile(PaperBlockMap map) : map_(std::move(map)), surface_(surface_of(map_)), caster_(surface_) {
    box = box_of(map_.corner, map_.tile_side_mm);
  }
  CastHit cast(const PlanRay& ray, double before) const override { return caster_.cast(ray, before); }
  HitLook look(const PlanRay& ray, const CastHit& hit) const override { return look_of(map_, surface_, ray, hit); }

 private:
  PaperBlockMap map_;
  BlockMap surface_;
  BlockMapCaster caster_;
};

/// Where the ray comes into the box and leaves it; first > second: it passes by.
std::pair<double, double> stretch(const PlanBox& box, const PlanRay& ray) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  const auto clip = [&](double from, double way, double low, double high) {
    if (std::abs(way) < 1e-12) {
      if (from < low || from > high) out = -1;
      return;
    }
    const double a = (low - from) / way, b = (high - from) / way;
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  };
  clip(ray.x, ray.dx, metres(box.min.x), metres(box.max.x));
  clip(ray.y, ray.dy, metres(box.min.y), metres(box.max.y));
  return {in, out};
}

PlanRay ray_of(const Vec3& from, const Vec3& way, double least) {
  const Vec3 start = from + way * least;
  return {start[0], start[1], start[2], way[0], way[1], way[2]};
}

}  // namespace

std::shared_ptr<const CastTile> cast_tile(BlockMap map) {
  auto pictures = tile_pictures(map);
  if (!pictures) throw CityError("a tile's picture is damaged");
  return cast_tile(std::move(map), std::move(*pictures));
}
std::shared_ptr<const CastTile> cast_tile(BlockMap map, TilePictures pictures) {
  return std::make_shared<OurTile>(std::move(map), std::move(pictures));
}
std::shared_ptr<const CastTile> cast_tile(PaperBlockMap map) { return std::make_shared<PaperTile>(std::move(map)); }

TileTracer::TileTracer(std::vector<std::shared_ptr<const CastTile>> tiles, RenderMesh mesh)
    : tiles_(std::move(tiles)), scene_(std::move(mesh)), mesh_(scene_) {}

TileTracer::Nearest TileTracer::nearest(const PlanRay& ray, double before) const {
  constexpr double kSlack = 1e-3;  // the caster works in floats
  Nearest best;
  best.hit.t = before;
  for (const auto& tile : tiles_) {
    const auto [in, out] = stretch(tile->box, ray);
    if (in > out + kSlack || in > best.hit.t + kSlack) continue;
    if (const CastHit hit = tile->cast(ray, best.hit.t); hit && hit.t < best.hit.t) best = {hit, tile.get()};
  }
  return best;
}

std::optional<Tracer::Met> TileTracer::meet(const Vec3& from, const RaySample& sample, double least) const {
  const auto polygon = mesh_.meet(from, sample, least);
  const PlanRay ray = ray_of(from, sample.way, least);
  const Nearest found = nearest(ray, polygon ? polygon->t - least : std::numeric_limits<double>::infinity());
  if (found.tile == nullptr) return polygon;
  const HitLook look = found.tile->look(ray, found.hit);
  Vec3 normal{look.east, look.north, look.up};
  if (dot(normal, sample.way) > 0) normal = normal * -1;
  const auto light = look.is_lit ? 1.0f : static_cast<float>(light_on(normal));
  const auto channel = [&](std::uint8_t v) { return std::min(1.0f, static_cast<float>(v) / 255 * light); };
  return Met{found.hit.t + least, {channel(look.colour.r), channel(look.colour.g), channel(look.colour.b), 1}};
}

std::optional<double> TileTracer::distance(const Vec3& from, const Vec3& way, double least) const {
  const auto polygon = mesh_.distance(from, way, least);
  const Nearest found =
      nearest(ray_of(from, way, least), polygon ? *polygon - least : std::numeric_limits<double>::infinity());
  return found.tile == nullptr ? polygon : std::optional(found.hit.t + least);
}

}  // namespace vicus::measure
