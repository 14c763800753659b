#include "sectorgen/bake/bake_blockmap.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "city_db/blockmap_layout.h"
#include "city_db/surroundings.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/bake/cell_fit.hpp"
#include "sectorgen/bake/few_colours.hpp"
#include "sectorgen/bake/ground_colours.hpp"
#include "sectorgen/bake/surface_distance.hpp"
#include "sectorgen/bake/wall_colours.hpp"

namespace vicus {
namespace {

constexpr double kLeastStep_m = 0.005;
constexpr double kStepsACell = 32;  // of height: rounding is 1/64 of a cell
constexpr double kWallStep = 0.75;  // cells: neighbours that stand for one roof differ by less
constexpr double kLeastWall_m = 0.3;
constexpr double kBadCell = 1;          // cells
constexpr double kBaseBelow_m = 0.001;  // of the ground, so that rounding leaves it above

/// The ground at the corners of all cells, metres above the plan frame's 0.
class GroundNodes {
 public:
  GroundNodes(const Terrain& terrain, const TileFrame& frame) : n_(frame.side + 1) {
    if (terrain.height_mm.empty()) return;
    is_flat_ = false;
    up_.reserve(n_ * n_);
    for (std::size_t row = 0; row < n_; ++row)
      for (std::size_t column = 0; column < n_; ++column)
        up_.push_back(height_m(terrain, {lattice_mm(frame.west_m() + double(column) * frame.cell_m()),
                                         lattice_mm(frame.south_m() + double(row) * frame.cell_m())}));
  }
  bool is_flat() const { return is_flat_; }
  double at(std::size_t column, std::size_t row) const { return is_flat_ ? 0 : up_[row * n_ + column]; }
  std::size_t last() const { return n_ - 1; }

 private:
  std::size_t n_;
  bool is_flat_ = true;
  std::vector<double> up_;
};

/// A plane with the slope of the tile's four corners, below all of its ground.
void set_base(const GroundNodes& ground, BlockMap& map, TileFrame& frame) {
  const std::size_t n = ground.last();
  const double side = metres(frame.tile_side_mm);
  const auto slope = [&](double rise) {
    return static_cast<std::int32_t>(std::lround(std::clamp(rise / (2 * side), -8.0, 8.0) * BLOCKMAP_BASE_ONE));
  };
  map.base_east = slope(ground.at(n, 0) + ground.at(n, n) - ground.at(0, 0) - ground.at(0, n));
  map.base_north = slope(ground.at(0, n) + ground.at(n, n) - ground.at(0, 0) - ground.at(n, 0));
  frame.base = {frame.west_m(), frame.south_m(), 0, map.base_east / double{BLOCKMAP_BASE_ONE},
                map.base_north / double{BLOCKMAP_BASE_ONE}};
  double least = ground.is_flat() ? 0 : 1e9;
  if (!ground.is_flat())
    for (std::size_t row = 0; row <= n; ++row)
      for (std::size_t column = 0; column <= n; ++column)
        least = std::min(least, ground.at(column, row) - frame.base.at(frame.west_m() + double(column) * frame.cell_m(),
                                                                       frame.south_m() + double(row) * frame.cell_m()));
  map.base_mm = ground.is_flat() ? 0 : static_cast<std::int32_t>(std::floor((least - kBaseBelow_m) * kMmPerMetre));
  frame.base.up = metres(map.base_mm);
}

/// The ground of a cell as a plane, and how far the terrain leaves it.
CellGround ground_of(const GroundNodes& nodes, const Terrain& terrain, const TileFrame& frame, std::size_t column,
                     std::size_t row) {
  if (nodes.is_flat()) return {};
  const double cell = frame.cell_m(), west = frame.west_m() + double(column) * cell,
               south = frame.south_m() + double(row) * cell;
  const double sw = nodes.at(column, row), se = nodes.at(column + 1, row), nw = nodes.at(column, row + 1),
               ne = nodes.at(column + 1, row + 1);
  const UpPlane own{west + cell / 2, south + cell / 2, (sw + se + nw + ne) / 4, (se + ne - sw - nw) / (2 * cell),
                    (nw + ne - sw - se) / (2 * cell)};
  CellGround out;
  out.up = own.up - frame.base.at(own.x0, own.y0);
  out.east = (own.east - frame.base.east) * cell;
  out.north = (own.north - frame.base.north) * cell;
  const int parts = 2 * static_cast<int>(std::ceil(cell / metres(terrain.step_mm)));
  for (int j = 0; j <= parts; ++j)
    for (int i = 0; i <= parts; ++i) {
      const double x = west + cell * i / parts, y = south + cell * j / parts;
      out.rough_m = std::max(out.rough_m, std::abs(height_m(terrain, {lattice_mm(x), lattice_mm(y)}) - own.at(x, y)));
    }
  return out;
}

/// The largest error of all cells. Of those whose own surface passes far from what stands in them (three heights in one
/// cell, say) the distance to the surface around counts: a neighbour's may be near.
double measured_error(const BakeScene& scene, const TileFrame& frame, const GroundNodes& nodes, const BlockMap& map,
                      const std::vector<CellFit>& fits, CellFitter& fitter) {
  const SurfaceDistance surface(map);
  const double bad_m = kBadCell * frame.cell_m();
  double error = 0;
  for (const CellFit& fit : fits) error = std::max(error, fit.error_m > bad_m ? fit.back_m : fit.error_m);
  for (std::size_t cell = 0; cell < fits.size(); ++cell) {
    const double own = fits[cell].error_m;
    if (own <= bad_m || own <= error) continue;  // it cannot raise the error
    const CellGround ground = ground_of(nodes, scene.terrain(), frame, cell % map.side, cell / map.side);
    double around = std::max(0.0, error - ground.rough_m);  // what is nearer does not count
    fitter.true_corners(cell, ground, [&](CellPoint at, double up_m) {
      around = std::max(around, surface.at_most(cell, at, up_m, around));
    });
    error = std::max(error, std::min(own, around + ground.rough_m));
  }
  return error;
}

void store_fit(const CellFit& f, std::size_t cell, BlockMap& map) {
  map.height[cell] = f.height;
  map.foot[cell] = f.foot;
  map.slope_east[cell] = f.slope_east;
  map.slope_north[cell] = f.slope_north;
  map.angle[cell] = f.angle;
  map.offset[cell] = f.offset;
}

/// Of what each cell's plane stands for, as the world's lights show it. `light`: that falls on the ground.
RgbImage roof_colours(const GroundColours& ground, double light, const CellPieces& pieces,
                      const std::vector<CellFit>& fits, std::uint32_t side) {
  RgbImage image(side, side);
  for (std::size_t row = 0, cell = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column, ++cell) {
      ColourMean sum;
      double area = 0;
      const auto roofs = pieces.roofs_of(cell);
      double covered = 0;
      for (std::size_t i = 0; i < roofs.size(); ++i) {
        covered += roofs[i].area;
        if (!is_above(fits[cell], i)) continue;
        sum = sum + mean_of(roofs[i].shown) * roofs[i].area;
        area += roofs[i].area;
      }
      if (fits[cell].ground_above && covered < 1) {
        sum = sum + ground.of_cell(column, row) * (light * (1 - covered));
        area += 1 - covered;
      }
      image.set(column, side - 1 - row, rounded(sum * (1 / area)));
    }
  return image;
}

RgbImage darkened(RgbImage image, double light) {
  for (std::uint8_t& v : image.rgb) v = static_cast<std::uint8_t>(std::min(255.0, v * light + 0.5));
  return image;
}

RgbImage grey_image(const std::vector<std::uint8_t>& values, std::uint32_t side) {
  RgbImage image(side, side);
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column) {
      const std::uint8_t v = values[(side - 1 - row) * side + column];
      image.set(column, row, {v, v, v});
    }
  return image;
}

/// Sum of squares between two pictures of one size.
double squares(const RgbImage& a, const RgbImage& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += (a.rgb[i] - b.rgb[i]) * (a.rgb[i] - b.rgb[i]);
  return sum;
}

std::string coded(const RgbImage& image, int colours, double& squares_sum, double& values) {
  if (image.rgb.empty()) return "";
  const IndexedPicture few = with_few_colours(image, colours);
  squares_sum += squares(image, rgb_of(few, image.width, image.height));
  values += static_cast<double>(image.rgb.size());
  return encode_indexed(few);
}

}  // namespace

BakedBlockMap bake_unpacked(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm,
                            const BlockMapOptions& options) {
  assert(std::has_single_bit(options.side) && options.side >= BLOCKMAP_LEAST_SIDE &&
         options.side <= BLOCKMAP_MOST_SIDE);
  BakedBlockMap out;
  BlockMap& map = out.map;
  map.side = options.side;
  map.corner = corner;
  map.tile_side_mm = tile_side_mm;
  TileFrame frame{corner, options.side, tile_side_mm, {}};
  const GroundNodes nodes(scene.terrain(), frame);
  set_base(nodes, map, frame);
  const double cell_m = frame.cell_m();
  map.step_um = static_cast<std::uint32_t>(std::lround(std::max(kLeastStep_m, cell_m / kStepsACell) * 1e6));
  map.wall_step_um = static_cast<std::uint32_t>(std::lround(std::max(kLeastWall_m, kWallStep * cell_m) * 1e6));

  const auto pieces = cut_to_cells(scene, scene.houses_in(frame.box()), frame);
  const std::size_t cells = std::size_t{options.side} * options.side;
  std::vector<CellFit> fits(cells);
  for (auto* list : {&map.height, &map.foot}) list->resize(cells);
  for (auto* list : {&map.slope_east, &map.slope_north, &map.angle, &map.offset}) list->resize(cells);
  const CellUnits units{cell_m, map.step_um * 1e-6};
  CellFitter fitter(pieces, units);
  double top = 0, error = 0;
  for (std::size_t row = 0, cell = 0; row < options.side; ++row)
    for (std::size_t column = 0; column < options.side; ++column, ++cell) {
      fits[cell] = fitter.fit(cell, ground_of(nodes, scene.terrain(), frame, column, row));
      store_fit(fits[cell], cell, map);
      top = std::max(top, fits[cell].top_m);
      error = std::max(error, fits[cell].error_m);
    }
  if (error > kBadCell * cell_m) error = measured_error(scene, frame, nodes, map, fits, fitter);
  map.top = static_cast<std::uint32_t>(std::ceil(top / units.step_m));
  map.error_mm = static_cast<std::uint32_t>(std::ceil(error * kMmPerMetre));
  map.rows = options.rows != 0 ? options.rows
                               : std::clamp<std::uint32_t>(static_cast<std::uint32_t>(std::ceil(top / (2 * cell_m))),
                                                           BLOCKMAP_LEAST_ROWS, BLOCKMAP_MOST_ROWS);
  const GroundColours ground(scene, frame, true);
  const double light = light_on(-frame.base.east, -frame.base.north, 1);
  out.pictures.roof = roof_colours(ground, light, pieces, fits, options.side);
  out.pictures.ground = darkened(ground.filled(), light);
  if (options.with_ambient) out.pictures.ambient = grey_image(ambient_light(scene, frame), options.side / 2);
  out.pictures.wall = wall_colours(scene, frame, map, pieces, fits, out.pictures.roof);
  return out;
}

BlockMap bake_blockmap(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm,
                       const BlockMapOptions& options) {
  BakedBlockMap baked = bake_unpacked(scene, corner, tile_side_mm, options);
  BlockMap& map = baked.map;
  const TilePictures& pictures = baked.pictures;
  double sum = 0, values = 0, unused = 0, unused_values = 0;
  map.roof_image = coded(pictures.roof, options.colours, sum, values);
  map.ground_image = coded(pictures.ground, options.colours, unused, unused_values);
  map.ambient_image = coded(pictures.ambient, options.colours, unused, unused_values);
  map.wall_image = coded(pictures.wall, options.colours, sum, values);
  map.colour_error_milli = static_cast<std::uint32_t>(std::ceil(std::sqrt(sum / values) * 1000));
  return std::move(baked.map);
}

}  // namespace vicus
