#include "sectorgen/bake/bake_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/facade_layout.hpp"
#include "city_db/run_parallel.hpp"
#include "city_db/segment.hpp"
#include "city_db/surroundings.hpp"

namespace vicus {
namespace {

constexpr std::int32_t kGridCell_mm = kGroundSquare_mm;
constexpr double kOnWall_mm = 2;           // a roof's corner over a wall: rounded to 1 mm
constexpr double kOnFacade_mm = 10;        // facades are straightened by kStraight_mm
constexpr double kLeastArea_mm2 = 10'000;  // of a triangle that may say how a facet lies

std::int32_t grid_of(std::int32_t mm) {
  return mm >= 0 ? mm / kGridCell_mm : -((-mm + kGridCell_mm - 1) / kGridCell_mm);
}
std::uint64_t grid_key(std::int32_t x, std::int32_t y) {
  return std::uint64_t{static_cast<std::uint32_t>(x)} << 32 | static_cast<std::uint32_t>(y);
}

double doubled_area_mm2(PlanPoint a, PlanPoint b, PlanPoint c) {
  return static_cast<double>((std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
                             (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x));
}

UpPlane plane_through(const RoofPoint& a, const RoofPoint& b, const RoofPoint& c, double ground_m) {
  const double ux = metres(b.at.x - a.at.x), uy = metres(b.at.y - a.at.y), vx = metres(c.at.x - a.at.x),
               vy = metres(c.at.y - a.at.y);
  const double uz = (b.up - a.up) / kRoofStepsPerMetre, vz = (c.up - a.up) / kRoofStepsPerMetre;
  const double area = ux * vy - uy * vx;
  return {metres(a.at.x), metres(a.at.y), ground_m + a.up / kRoofStepsPerMetre, (uz * vy - vz * uy) / area,
          (ux * vz - vx * uz) / area};
}

/// One plane a facet, by its largest triangle: thin ones say little about how it lies.
void add_roof(const Building& house, BakeHouse& out) {
  const auto& points = house.roof.points;
  for (const RoofFacet& facet : house.roof.facets) {
    if (facet.kind == FacetKind::gable) continue;
    std::size_t best = 0;
    double most = 0;
    for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3) {
      const double area = doubled_area_mm2(points.at(facet.triangles[i]).at, points.at(facet.triangles[i + 1]).at,
                                           points.at(facet.triangles[i + 2]).at);
      if (area > most) most = area, best = i;
    }
    if (most <= 0) continue;
    UpPlane plane = plane_through(points[facet.triangles[best]], points[facet.triangles[best + 1]],
                                  points[facet.triangles[best + 2]], house.ground_m);
    if (facet.kind == FacetKind::top || most < kLeastArea_mm2) plane.east = plane.north = 0;
    for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3) {
      BakeTriangle t;
      t.plane = static_cast<std::uint32_t>(out.planes.size());
      for (std::size_t k = 0; k < 3; ++k) {
        t.x[k] = metres(points.at(facet.triangles[i + k]).at.x);
        t.y[k] = metres(points.at(facet.triangles[i + k]).at.y);
      }
      out.roof.push_back(t);
    }
    out.planes.push_back(plane);
    out.lit_roof.push_back(rounded(mean_of(house.roof_colour) * light_on(-plane.east, -plane.north, 1)));
  }
}

/// Position along a -> b of the point nearest to p, metres.
double along_m(PlanPoint p, PlanPoint a, PlanPoint b) {
  const double dx = metres(std::int64_t{b.x} - a.x), dy = metres(std::int64_t{b.y} - a.y), length = std::hypot(dx, dy);
  return length > 0 ? (metres(std::int64_t{p.x} - a.x) * dx + metres(std::int64_t{p.y} - a.y) * dy) / length : 0;
}

void add_walls(const Building& house, const Ring& ring, const std::vector<const Facade*>& facades, BakeHouse& out) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    BakeWall wall{metres(a.x), metres(a.y), metres(b.x), metres(b.y), -1, 0, 0, house.ground_m + house.eave_m};
    for (const RoofPoint& p : house.roof.points)
      if (distance_to_segment_mm(p.at, a, b) <= kOnWall_mm)
        wall.top_m = std::max(wall.top_m, house.ground_m + p.up / kRoofStepsPerMetre);
    for (std::size_t f = 0; f < facades.size() && wall.facade < 0; ++f) {
      const Facade& facade = *facades[f];  // ground on its left, seen from there it runs from b to a
      if (distance_to_segment_mm(a, facade.b, facade.a) > kOnFacade_mm ||
          distance_to_segment_mm(b, facade.b, facade.a) > kOnFacade_mm)
        continue;
      wall.facade = static_cast<std::int32_t>(f);
      wall.from_m = along_m(a, facade.b, facade.a);
      wall.to_m = along_m(b, facade.b, facade.a);
    }
    wall.light = wall.ax == wall.bx && wall.ay == wall.by ? 0 : light_on(wall.by - wall.ay, wall.ax - wall.bx, 0);
    out.walls.push_back(wall);
  }
}

void add_double(KeyHash& hash, double value) { hash.add(std::bit_cast<std::uint64_t>(value)); }
std::uint64_t packed(Colour c) { return std::uint64_t{c.r} << 16 | std::uint64_t{c.g} << 8 | c.b; }

void hash_shape(const Building& house, KeyHash& hash) {
  const auto add_ring = [&](const Ring& ring) {
    hash.add(ring.size());
    for (const PlanPoint p : ring) hash.add(grid_key(p.x, p.y));
  };
  hash.add(house.id);
  add_ring(house.footprint.outer);
  for (const auto& hole : house.footprint.holes) add_ring(hole);
  for (const RoofPoint& p : house.roof.points) {
    hash.add(grid_key(p.at.x, p.at.y));
    hash.add(static_cast<std::uint32_t>(p.up));
  }
  for (const RoofFacet& facet : house.roof.facets) {
    hash.add(static_cast<std::uint64_t>(facet.kind));
    for (const std::uint32_t i : facet.triangles) hash.add(i);
  }
  for (const double v : {house.ground_m, house.eave_m, house.height_m}) add_double(hash, v);
  hash.add(packed(house.wall_colour));
  hash.add(packed(house.roof_colour));
}

/// A large city has hundreds of thousands of houses: no list keeps room to grow.
void drop_slack(BakeHouse& house) {
  house.planes.shrink_to_fit();
  house.lit_roof.shrink_to_fit();
  house.roof.shrink_to_fit();
  house.walls.shrink_to_fit();
  house.facades.shrink_to_fit();
}

std::uint64_t key_of_ground(const BakeGround& g) {
  KeyHash hash;
  hash.add(static_cast<std::uint64_t>(g.kind));
  for (const PlanPoint p : g.at) hash.add(grid_key(p.x, p.y));
  return hash.value();
}

bool is_upright(const Surface& s) { return s.kind == SurfaceKind::kerb; }

}  // namespace

void BakeScene::Grid::add(const PlanBox& box, std::uint32_t item) {
  for (std::int32_t x = grid_of(box.min.x); x <= grid_of(box.max.x); ++x)
    for (std::int32_t y = grid_of(box.min.y); y <= grid_of(box.max.y); ++y) cells_[grid_key(x, y)].push_back(item);
}

std::vector<std::uint32_t> BakeScene::Grid::find(const PlanBox& box) const {
  std::vector<std::uint32_t> out;
  for (std::int32_t x = grid_of(box.min.x); x <= grid_of(box.max.x); ++x)
    for (std::int32_t y = grid_of(box.min.y); y <= grid_of(box.max.y); ++y)
      if (const auto cell = cells_.find(grid_key(x, y)); cell != cells_.end())
        out.insert(out.end(), cell->second.begin(), cell->second.end());
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

bool BakeScene::Grid::is_full(const PlanBox& box) const {
  for (std::int32_t x = grid_of(box.min.x); x <= grid_of(box.max.x); ++x)
    for (std::int32_t y = grid_of(box.min.y); y <= grid_of(box.max.y); ++y)
      if (!cells_.contains(grid_key(x, y))) return false;
  return true;
}

std::function<std::string(const std::string&)> pictures_of(const City& city) {
  std::map<std::string, const std::string*> by_id;
  for (const Texture& t : city.textures) by_id.emplace(t.id, &t.png);
  return [by_id](const std::string& id) {
    const auto at = by_id.find(id);
    return at == by_id.end() ? std::string() : *at->second;
  };
}

BakeScene::BakeScene(const City& city, const std::function<std::string(const std::string&)>& picture, unsigned threads)
    : terrain_(city.terrain) {
  std::unordered_map<std::string, std::vector<const Facade*>> facades;
  std::set<std::string> ids;
  for (const Facade& f : city.facades) {
    facades[f.building_id].push_back(&f);
    if (!f.texture.empty()) ids.insert(f.texture);
  }
  const std::vector<std::string> names(ids.begin(), ids.end());
  std::vector<std::shared_ptr<const FacadeSums>> sums(names.size());
  run_parallel(names.size(), thread_count(threads), [&](std::size_t i, unsigned) {
    if (auto read = FacadeSums::of_png(picture(names[i])))
      sums[i] = std::make_shared<const FacadeSums>(std::move(*read));
  });
  std::unordered_map<std::string, std::shared_ptr<const FacadeSums>> pictures;
  for (std::size_t i = 0; i < names.size(); ++i) pictures.emplace(names[i], sums[i]);

  // By id: a part of the city, read from its file, gives the same bytes as the whole (sums are rounded, heights are
  // equal).
  std::vector<const Building*> by_id;
  for (const Building& house : city.buildings) by_id.push_back(&house);
  std::sort(by_id.begin(), by_id.end(), [](const Building* a, const Building* b) { return a->id < b->id; });
  houses_.resize(by_id.size());
  for (std::size_t i = 0; i < by_id.size(); ++i) {
    const Building& house = *by_id[i];
    BakeHouse& out = houses_[i];
    out.id = house.id;
    out.box = box_of(house.footprint);
    out.footprint = house.footprint;
    out.ground_m = house.ground_m;
    out.eave_m = house.eave_m;
    out.top_m = house.ground_m + house.height_m;
    out.wall_colour = house.wall_colour;
    out.roof_colour = house.roof_colour;
    add_roof(house, out);
    out.facets = house.roof;
    KeyHash hash;
    hash_shape(house, hash);
    const auto own = facades.find(house.id);
    const std::vector<const Facade*> none, &list = own == facades.end() ? none : own->second;
    add_walls(house, house.footprint.outer, list, out);
    for (const auto& hole : house.footprint.holes) add_walls(house, hole, list, out);
    for (const Facade* f : list) {
      const auto found = pictures.find(f->texture);
      out.facades.push_back({found == pictures.end() ? nullptr : found->second, length_m(*f),
                             house.ground_m + f->bottom_m, house.ground_m + f->top_m, f->repeats});
      hash.add(f->texture);
      for (const PlanPoint p : {f->a, f->b}) hash.add(grid_key(p.x, p.y));
      for (const double v : {f->bottom_m, f->top_m}) add_double(hash, v);
      hash.add(static_cast<std::uint64_t>(f->repeats));
    }
    out.key = hash.value();
    drop_slack(out);
    house_grid_.add(out.box, static_cast<std::uint32_t>(i));
    if (out.box.is_empty()) continue;
    box_.add(out.box.min);
    box_.add(out.box.max);
  }
  add_ground(city);
  add_trees(city);
  KeyHash hash;
  for (const std::int32_t v : {terrain_.corner.x, terrain_.corner.y, terrain_.step_mm})
    hash.add(static_cast<std::uint32_t>(v));
  for (const std::int32_t v : terrain_.height_mm) hash.add(static_cast<std::uint32_t>(v));
  terrain_key_ = hash.value();
}

void BakeScene::add_ground(const City& city) {
  std::size_t count = 0;
  for (const Surface& s : city.surfaces) count += is_upright(s) ? 0 : s.triangles.size() / 3;
  ground_.reserve(count);
  for (const Surface& s : city.surfaces) {
    if (is_upright(s)) continue;
    for (std::size_t i = 0; i + 2 < s.triangles.size(); i += 3) {
      BakeGround t;
      t.kind = s.kind;
      for (std::size_t k = 0; k < 3; ++k) t.at[k] = s.points.at(s.triangles[i + k]).at;
      const PlanBox box = t.box();
      ground_grid_.add(box, static_cast<std::uint32_t>(ground_.size()));
      ground_.push_back(t);
      box_.add(box.min);
      box_.add(box.max);
    }
  }
}

void BakeScene::add_trees(const City& city) {
  for (const StandaloneObject& object : city.objects) {
    if (object.kind != "tree") continue;
    BakeTree tree{object.id, object.at, {}, object.ground_m, shape_of_tree(object)};
    tree.box.add(object.at);
    tree.box = grown(tree.box, lattice_mm(tree.shape.crown_m));
    KeyHash hash;
    hash.add(tree.id);
    hash.add(grid_key(tree.at.x, tree.at.y));
    for (const double v : {tree.ground_m, tree.shape.height_m, tree.shape.crown_m}) add_double(hash, v);
    hash.add(static_cast<std::uint64_t>(tree.shape.form));
    hash.add(packed(tree.shape.leaves));
    tree.key = hash.value();
    trees_.push_back(std::move(tree));
  }
  std::sort(trees_.begin(), trees_.end(), [](const BakeTree& a, const BakeTree& b) { return a.id < b.id; });
  for (std::size_t i = 0; i < trees_.size(); ++i) tree_grid_.add(trees_[i].box, static_cast<std::uint32_t>(i));
}

std::vector<std::uint32_t> BakeScene::houses_in(const PlanBox& box) const {
  auto out = house_grid_.find(box);
  std::erase_if(out, [&](std::uint32_t i) { return !meet(houses_[i].box, box); });
  return out;
}

std::vector<std::uint32_t> BakeScene::ground_in(const PlanBox& box) const {
  auto out = ground_grid_.find(box);
  std::erase_if(out, [&](std::uint32_t i) { return !meet(ground_[i].box(), box); });
  return out;
}

bool BakeScene::lacks_ground(const PlanBox& box) const { return !ground_grid_.is_full(box); }

std::vector<std::uint32_t> BakeScene::trees_in(const PlanBox& box) const {
  auto out = tree_grid_.find(box);
  std::erase_if(out, [&](std::uint32_t i) { return !meet(trees_[i].box, box); });
  return out;
}

std::uint64_t BakeScene::key_of(const PlanBox& box) const {
  std::uint64_t sum = terrain_key_;  // a sum: the order of the houses in the city does not matter
  for (const std::uint32_t i : houses_in(box)) sum += houses_[i].key;
  for (const std::uint32_t i : ground_in(box)) sum += key_of_ground(ground_[i]);
  for (const std::uint32_t i : trees_in(box)) sum += trees_[i].key;
  KeyHash hash;
  hash.add(sum);
  return hash.value();
}

WallColumn::WallColumn(const BakeHouse& house, const BakeWall& wall, double from, double to)
    : plain_(mean_of(house.wall_colour)), roof_(mean_of(house.roof_colour)), top_m_(wall.top_m) {
  if (wall.facade < 0) return;
  const BakeFacade& f = house.facades[static_cast<std::size_t>(wall.facade)];
  const double x0 = wall.from_m + from * (wall.to_m - wall.from_m), x1 = wall.from_m + to * (wall.to_m - wall.from_m);
  const double scale = f.repeats / f.length_m;
  u0_ = std::min(x0, x1) * scale, u1_ = std::max(x0, x1) * scale;
  constexpr double kNothing = 1e-9;
  if (f.picture && u1_ - u0_ >= kNothing && f.top_m > f.bottom_m) facade_ = &f;
}

ColourMean WallColumn::up_to(double up_m) const {
  const double wall_m = std::min(up_m, top_m_);
  const ColourMean roof = roof_ * (up_m - wall_m);
  if (!facade_) return roof + plain_ * wall_m;
  const double picture_m = std::clamp(wall_m, facade_->bottom_m, facade_->top_m);
  const double height_m = facade_->top_m - facade_->bottom_m;
  return roof + plain_ * (wall_m - picture_m) +
         facade_->picture->strip(u0_, u1_, (picture_m - facade_->bottom_m) / height_m) * height_m;
}

ColourMean wall_mean(const BakeHouse& house, const BakeWall& wall, double from, double to, double low_m,
                     double high_m) {
  const WallColumn column(house, wall, from, to);
  return (column.up_to(high_m) + column.up_to(low_m) * -1) * (1 / (high_m - low_m));
}

}  // namespace vicus
