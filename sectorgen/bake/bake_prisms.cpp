#include "sectorgen/bake/bake_prisms.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "city_db/z_order.hpp"
#include "sectorgen/bake/prism_footprint.hpp"
#include "sectorgen/bake/prism_roof.hpp"
#include "sectorgen/bake/prism_trees.hpp"

namespace vicus {
namespace {

constexpr std::uint32_t kLeastStep_mm = 100, kSteps = 512, kUpStep_mm = 100;
constexpr std::size_t kMostColours = 4096 - 16;  // leaves have some, too
/// A house's own roof takes five times the bytes of a simple one: it is for tiles that are seen from near.
constexpr std::uint32_t kOwnRoofStep_mm = 250;
constexpr double kOwnRoofSteps = 0.5;  // where the nearest simple roof errs by more

/// The simple roof over a place, steps above the eave. `rings` and the place in steps.
double rise_at(const PrismHouse& house, double x, double y) {
  const auto& ring = house.rings[0];
  if (house.kind == PrismKind::flat) return house.rise;
  if (house.kind == PrismKind::tent) {
    double mx = 0, my = 0;
    for (const PlanPoint p : ring) mx += p.x, my += p.y;
    mx /= double(ring.size());
    my /= double(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {  // which triangle of the tent it is below
      const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      const double area = (b.x - a.x) * (my - a.y) - (b.y - a.y) * (mx - a.x);
      if (area <= 0) continue;
      const double w = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area;
      const double u = ((mx - b.x) * (y - b.y) - (my - b.y) * (x - b.x)) / area;
      const double v = 1 - u - w;
      if (u >= -1e-9 && v >= -1e-9 && w >= -1e-9) return w * house.rise;
    }
    return 0;
  }
  // Sides 0-1 and 2-3 or 1-2 and 3-0 are the longer ones; the slopes rise from them.
  const auto length = [&](std::size_t i) {
    return std::hypot(double(ring[(i + 1) % 4].x) - ring[i].x, double(ring[(i + 1) % 4].y) - ring[i].y);
  };
  const std::size_t first = length(0) + length(2) >= length(1) + length(3) ? 0 : 1;
  const auto inside = [&](std::size_t i) {  // distance from side i, inwards
    const PlanPoint a = ring[i % 4], b = ring[(i + 1) % 4];
    return ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / std::max(1.0, length(i % 4));
  };
  const double across = std::max(1e-9, inside(first) + inside(first + 2));
  double share = 2 * std::min(inside(first), inside(first + 2)) / across;
  if (house.kind == PrismKind::hipped) {
    const double half = std::max(1e-9, (length((first + 1) % 4) + length((first + 3) % 4)) / 4);
    share = std::min(share, std::min(inside(first + 1), inside(first + 3)) / half);
  }
  return std::clamp(share, 0.0, 1.0) * house.rise;
}

std::uint32_t up_steps(double m) {
  return static_cast<std::uint32_t>(std::max(0L, std::lround(m * kMmPerMetre / kUpStep_mm)));
}

/// How far the simple roof passes above or below the corners of the true one, metres. Those on walls are judged at the
/// eave's height too: there the wall stands.
double roof_error_m(const BakeHouse& house, const PrismHouse& prism, PlanPoint corner, double step_m) {
  double error = 0;
  for (const BakeTriangle& t : house.roof)
    for (int k = 0; k < 3; ++k) {
      const double up = house.planes[t.plane].at(t.x[k], t.y[k]) - house.ground_m;
      const double x = (t.x[k] - metres(corner.x)) / step_m, y = (t.y[k] - metres(corner.y)) / step_m;
      const double simple = (prism.eave + rise_at(prism, x, y)) * (kUpStep_mm / kMmPerMetre);
      error = std::max(error, std::abs(up - simple));
    }
  return error;
}

/// The kind of roof that passes nearest to the true one.
double choose_roof(const BakeHouse& house, PlanPoint corner, double step_m, PrismHouse& prism) {
  const double eave = house.eave_m, top = house.top_m - house.ground_m;
  PrismHouse best = prism;
  double least = 1e9;
  const auto attempt = [&](PrismKind kind, double eave_m, double rise_m) {
    PrismHouse next = prism;
    next.kind = kind;
    next.eave = up_steps(eave_m);
    next.rise = up_steps(rise_m);
    const double error = roof_error_m(house, next, corner, step_m);
    if (error < least) least = error, best = std::move(next);
  };
  double low = 1e9, high = -1e9;
  for (const BakeTriangle& t : house.roof)
    for (int k = 0; k < 3; ++k) {
      const double up = house.planes[t.plane].at(t.x[k], t.y[k]) - house.ground_m;
      low = std::min(low, up), high = std::max(high, up);
    }
  if (low > high) low = high = top;
  attempt(PrismKind::flat, (low + high) / 2, 0);
  if (top - eave > 0.2 && prism.rings.size() == 1) {
    attempt(PrismKind::tent, eave, top - eave);
    if (prism.rings[0].size() == 4) {
      attempt(PrismKind::gabled, eave, top - eave);
      attempt(PrismKind::hipped, eave, top - eave);
    }
  }
  prism = std::move(best);
  return least;
}

/// The palette: colours by how many houses have them, and what each house's are in it.
void set_colours(const BakeScene& scene, const std::vector<std::uint32_t>& which, PrismTile& tile) {
  std::map<Colour, std::size_t> count;
  for (const std::uint32_t i : which) {
    ++count[scene.houses()[i].wall_colour];
    ++count[scene.houses()[i].roof_colour];
  }
  std::vector<std::pair<std::size_t, Colour>> order;
  for (const auto& [colour, n] : count) order.push_back({n, colour});
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  if (order.size() > kMostColours) order.resize(kMostColours);
  std::map<Colour, std::uint16_t> place;
  for (const auto& [n, colour] : order) {
    place.emplace(colour, static_cast<std::uint16_t>(tile.palette.size()));
    tile.palette.push_back(colour);
  }
  const auto find = [&](Colour c) { return place.contains(c) ? place.at(c) : std::uint16_t{0}; };
  for (std::size_t k = 0; k < which.size(); ++k) {
    tile.houses[k].wall = find(scene.houses()[which[k]].wall_colour);
    tile.houses[k].roof = find(scene.houses()[which[k]].roof_colour);
  }
}

}  // namespace

PrismTile bake_prisms(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm) {
  PrismTile tile;
  tile.corner = corner;
  tile.tile_side_mm = tile_side_mm;
  tile.step_mm = std::max(kLeastStep_mm, tile_side_mm / kSteps);
  tile.step_mm = tile.step_mm / 5 * 5;
  while (tile_side_mm % tile.step_mm != 0) ++tile.step_mm;  // the corner stays on the lattice
  tile.up_step_mm = kUpStep_mm;
  const PlanBox box{corner,
                    {static_cast<std::int32_t>(std::int64_t{corner.x} + tile_side_mm),
                     static_cast<std::int32_t>(std::int64_t{corner.y} + tile_side_mm)}};
  struct Found {
    std::uint64_t order;
    std::uint32_t index;
    PrismHouse house;
  };
  std::vector<Found> found;
  double base = 1e9, error = 0;
  for (const std::uint32_t i : scene.houses_in(box)) {
    const BakeHouse& house = scene.houses()[i];
    PrismHouse prism;
    prism.rings = rounded_rings(house.footprint, corner, tile.step_mm);
    if (prism.rings.empty()) {  // narrower than a step: what is left out is no farther than a step from nothing
      error = std::max(error, house.top_m - house.ground_m);
      continue;
    }
    const std::int64_t mx = (std::int64_t{house.box.min.x} + house.box.max.x) / 2,
                       my = (std::int64_t{house.box.min.y} + house.box.max.y) / 2;
    prism.is_owned = mx >= box.min.x && my >= box.min.y && mx < box.max.x && my < box.max.y;
    const std::int64_t half = tile_side_mm / 2;
    if (prism.is_owned)
      prism.quadrant = static_cast<std::uint8_t>((mx >= box.min.x + half ? 1 : 0) + (my >= box.min.y + half ? 2 : 0));
    double roof = choose_roof(house, corner, metres(tile.step_mm), prism);
    if (tile.step_mm <= kOwnRoofStep_mm && roof > kOwnRoofSteps * metres(tile.step_mm) &&
        set_own_roof(house, corner, tile.step_mm, tile.up_step_mm, prism))
      roof = metres(tile.up_step_mm) / 2;
    error = std::max(error, roof + metres(tile.step_mm) * 1.25);  // half a step cut, 0.71 rounded
    base = std::min(base, house.ground_m);
    found.push_back({z_order(prism.rings[0][0]), i, std::move(prism)});
  }
  const bool has_trees = has_standing_trees(scene, corner, tile_side_mm);
  if (has_trees) {
    for (const std::uint32_t i : scene.trees_in(box)) base = std::min(base, scene.trees()[i].ground_m);
  } else {
    error = std::max(error, flat_trees_error_m(scene, corner, tile_side_mm));
  }
  tile.base_mm = base == 1e9 ? 0 : static_cast<std::int32_t>(std::floor(base)) * 1000;
  tile.error_mm = static_cast<std::uint32_t>(std::ceil(error * kMmPerMetre)) + kUpStep_mm;
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.order < b.order; });
  std::vector<std::uint32_t> which;
  for (Found& f : found) {
    f.house.ground = static_cast<std::int32_t>(
        std::lround((scene.houses()[f.index].ground_m * kMmPerMetre - tile.base_mm) / kUpStep_mm));
    which.push_back(f.index);
    tile.houses.push_back(std::move(f.house));
  }
  set_colours(scene, which, tile);
  if (has_trees) set_trees(scene, tile);
  return tile;
}

}  // namespace vicus
