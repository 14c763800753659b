#include "sectorgen/bake/blockmap_colours.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "city_db/blockmap_layout.h"
#include "sectorgen/bake/few_colours.hpp"
#include "sectorgen/bake/wall_colours.hpp"

namespace vicus {
namespace {

constexpr int kStep[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};  // by CellSide

}  // namespace

std::pair<std::uint32_t, std::uint32_t> wall_atlas_size(std::uint32_t columns, std::uint32_t rows) {
  if (columns == 0) return {0, 0};
  const std::uint32_t strips = (columns + BLOCKMAP_ATLAS_WIDTH - 1) / BLOCKMAP_ATLAS_WIDTH;
  return {std::min<std::uint32_t>(columns, BLOCKMAP_ATLAS_WIDTH), strips * rows};
}

std::optional<TilePictures> tile_pictures(const BlockMap& map) {
  TilePictures out;
  const auto read = [](const std::string& bytes, std::uint32_t w, std::uint32_t h, RgbImage& image) {
    if (w == 0 || h == 0) return bytes.empty();
    const auto decoded = decode_indexed(bytes, std::size_t{w} * h);
    if (decoded) image = rgb_of(*decoded, w, h);
    return decoded.has_value();
  };
  const auto [width, height] = wall_atlas_size(column_total(first_columns(wall_bits(map))), map.rows);
  const std::uint32_t half = map.side / 2;
  if (!read(map.roof_image, map.side, map.side, out.roof) || !read(map.ground_image, half, half, out.ground) ||
      !read(map.wall_image, width, height, out.wall))
    return std::nullopt;
  if (!map.ambient_image.empty() && !read(map.ambient_image, half, half, out.ambient)) return std::nullopt;
  return out;
}

BlockMapColours::BlockMapColours(const BlockMap& map, TilePictures pictures)
    : map_(&map), pictures_(std::move(pictures)), walls_(wall_bits(map)), first_(first_columns(walls_)) {}

Colour BlockMapColours::wall(std::size_t cell, std::uint8_t bit, double up) const {
  const WallSpan span = wall_span(*map_, cell, static_cast<WallBit>(bit));
  const std::uint32_t column =
      first_[cell] + static_cast<std::uint32_t>(std::popcount(static_cast<std::uint8_t>(walls_[cell] & (bit - 1u))));
  const double v = (up - span.low_m) / (span.high_m - span.low_m) * map_->rows;
  const auto row = static_cast<std::uint32_t>(std::clamp(v, 0.0, map_->rows - 1.0));
  return pictures_.wall.at(column % BLOCKMAP_ATLAS_WIDTH, (column / BLOCKMAP_ATLAS_WIDTH + 1) * map_->rows - 1 - row);
}

Colour BlockMapColours::foot(std::size_t cell) const {
  const std::size_t n = map_->side;
  const auto column = static_cast<long>(cell % n), row = static_cast<long>(cell / n);
  const CellLine line = line_of(map_->angle[cell], map_->offset[cell]);
  for (int k = 1; k <= 2; ++k) {
    const long east = std::lround(k * line.east), north = std::lround(k * line.north);
    const long c = column + east, r = row + north;
    if (c < 0 || r < 0 || c >= static_cast<long>(n) || r >= static_cast<long>(n)) break;
    const std::size_t other = static_cast<std::size_t>(r) * n + static_cast<std::size_t>(c);
    // The other's plane, carried on to this cell's middle.
    const double rise =
        (slope_of(map_->slope_east[other]) * double(east) + slope_of(map_->slope_north[other]) * double(north)) *
        metres(map_->tile_side_mm) / double(n);
    const double up = map_->height[other] * (map_->step_um * 1e-6) - rise;
    if (std::abs(up - map_->foot[cell] * (map_->step_um * 1e-6)) <= map_->wall_step_um * 1e-6)
      return pictures_.roof.at(static_cast<std::size_t>(c), n - 1 - static_cast<std::size_t>(r));
  }
  return pictures_.ground.at(static_cast<std::size_t>(column / 2), n / 2 - 1 - static_cast<std::size_t>(row / 2));
}

HitLook BlockMapColours::look(const PlanRay& ray, const CastHit& hit) const {
  const std::size_t n = map_->side, cell = hit.cell, column = cell % n, row = cell / n;
  const double cell_m = metres(map_->tile_side_mm) / static_cast<double>(n);
  const double x = ray.x + hit.t * ray.dx - metres(map_->corner.x), y = ray.y + hit.t * ray.dy - metres(map_->corner.y);
  const double base_east = map_->base_east / double{BLOCKMAP_BASE_ONE},
               base_north = map_->base_north / double{BLOCKMAP_BASE_ONE};
  const double up = ray.z + hit.t * ray.dz - metres(map_->base_mm) - base_east * x - base_north * y;
  const double east = slope_of(map_->slope_east[cell]), north = slope_of(map_->slope_north[cell]);
  HitLook look;
  look.is_lit = true;
  if (!pictures_.ambient.rgb.empty()) look.ambient = pictures_.ambient.at(column / 2, n / 2 - 1 - row / 2).r / 255.0;
  // A wall is as light at its foot as the ground two cells before it, and as the open sky at its top.
  const auto stand = [&](double a, double b, std::size_t at, std::uint8_t bit) {
    if (pictures_.ambient.rgb.empty()) return;
    const long last = static_cast<long>(n) - 1;
    const long c = std::clamp(static_cast<long>(at % n) + std::lround(2 * a), 0L, last),
               r = std::clamp(static_cast<long>(at / n) + std::lround(2 * b), 0L, last);
    const double low =
        pictures_.ambient.at(static_cast<std::size_t>(c / 2), n / 2 - 1 - static_cast<std::size_t>(r / 2)).r / 255.0;
    const WallSpan span = wall_span(*map_, at, static_cast<WallBit>(bit));
    look.ambient = low + (1 - low) * std::clamp((up - span.low_m) / (span.high_m - span.low_m), 0.0, 1.0);
  };
  const auto as_plane = [&] { look.colour = pictures_.roof.at(column, n - 1 - row); };
  const auto as_line = [&](std::size_t at) {
    const CellLine line = line_of(map_->angle[at], map_->offset[at]);
    look.colour = wall(at, kWallLine, up);
    stand(line.east, line.north, at, kWallLine);
  };
  if (hit.surface == CastSurface::plane) {
    as_plane();
  } else if (hit.surface == CastSurface::foot) {
    look.colour = foot(cell);
  } else if (hit.surface == CastSurface::line) {
    if (walls_[cell] & kWallLine)
      as_line(cell);
    else
      as_plane();
  } else if (hit.surface == CastSurface::side) {
    const auto* step = kStep[static_cast<int>(hit.side)];
    const auto bit = static_cast<std::uint8_t>(1u << static_cast<int>(hit.side));
    const double px = x / cell_m - static_cast<double>(column) - 0.5, py = y / cell_m - static_cast<double>(row) - 0.5;
    const double plane = map_->height[cell] * (map_->step_um * 1e-6) + (east * px + north * py) * cell_m;
    const long c = static_cast<long>(column) + step[0], r = static_cast<long>(row) + step[1];
    const long across = static_cast<long>(n);
    const bool is_inside = c >= 0 && r >= 0 && c < across && r < across;
    const std::size_t other = is_inside ? static_cast<std::size_t>(r * across + c) : cell;
    if (plane - up <= map_->wall_step_um * 1e-6) {
      as_plane();
    } else if (walls_[cell] & bit) {
      look.colour = wall(cell, bit, up);
      stand(step[0], step[1], cell, bit);
    } else if (walls_[cell] & kWallLine) {
      as_line(cell);
    } else if (walls_[other] & kWallLine) {
      as_line(other);
    } else {
      as_plane();
    }
  }
  return look;
}

}  // namespace vicus
