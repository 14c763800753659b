#include "sectorgen/bake/blockmap_caster.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "city_db/blockmap_layout.h"

namespace vicus {

/// In cells of the tile, metres above its base plane, from where the ray comes into the tile's box.
struct BlockMapCaster::LocalRay {
  float x, y, z, dx, dy, dz, per_dx, per_dy;
};

BlockMapCaster::BlockMapCaster(const BlockMap& map)
    : side_(static_cast<int>(map.side)),
      west_(metres(map.corner.x)),
      south_(metres(map.corner.y)),
      cell_m_(metres(map.tile_side_mm) / map.side),
      base_(metres(map.base_mm)),
      base_east_(map.base_east / double{BLOCKMAP_BASE_ONE}),
      base_north_(map.base_north / double{BLOCKMAP_BASE_ONE}) {
  const auto number = [](double v) { return static_cast<float>(v); };
  const double step = map.step_um * 1e-6;
  CellLine normals[256];
  for (int i = 0; i < 256; ++i) normals[i] = line_of(static_cast<std::uint8_t>(i), 1);
  for (std::size_t i = 0; i < map.height.size(); ++i) {
    Cell c{number(map.height[i] * step),
           number(slope_of(map.slope_east[i]) * cell_m_),
           number(slope_of(map.slope_north[i]) * cell_m_),
           number(map.foot[i] * step),
           0,
           0,
           9,
           0};
    float top = c.up + (std::abs(c.east) + std::abs(c.north)) / 2;
    if (map.offset[i] != 0) {
      c.line_east = number(normals[map.angle[i]].east);
      c.line_north = number(normals[map.angle[i]].north);
      c.at = number(line_of(0, map.offset[i]).distance);
      top = std::max(top, c.foot);
    }
    cells_.push_back(c);
    tops_.push_back(top + 1e-4f);
  }
  levels_ = 1;
  for (int n = side_; n > 1; n /= 2, ++levels_) {
    const std::size_t fine = tops_.size() - static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    const std::size_t coarse = tops_.size();
    first_[static_cast<std::size_t>(levels_)] = static_cast<int>(coarse);
    tops_.resize(coarse + static_cast<std::size_t>(n / 2) * static_cast<std::size_t>(n / 2), -1e9f);
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        float& top = tops_[coarse + static_cast<std::size_t>(y / 2 * (n / 2) + x / 2)];
        top = std::max(top, tops_[fine + static_cast<std::size_t>(y * n + x)]);
      }
  }
  top_ = tops_.back();
}

bool BlockMapCaster::meet(const LocalRay& ray, float t0, float t1, std::uint32_t column, std::uint32_t row,
                          CellSide side, CastHit& hit, float& t) const {
  const std::uint32_t index = row * static_cast<std::uint32_t>(side_) + column;
  const Cell& c = cells_[index];
  const float ox = ray.x - static_cast<float>(column) - 0.5f, oy = ray.y - static_cast<float>(row) - 0.5f;
  // Height above the plane, beside the line, as a + b t.
  const float plane_a = ray.z - c.up - c.east * ox - c.north * oy,
              plane_b = ray.dz - c.east * ray.dx - c.north * ray.dy;
  const float line_a = c.line_east * ox + c.line_north * oy - c.at,
              line_b = c.line_east * ray.dx + c.line_north * ray.dy;
  const float line0 = line_a + line_b * t0, line1 = line_a + line_b * t1;
  const bool crosses = (line0 <= 0) != (line1 <= 0);
  const float tc = crosses ? std::clamp(-line_a / line_b, t0, t1) : t1;
  bool on_plane = line0 <= 0;
  float from = t0, to = tc;
  for (int part = 0;; ++part) {
    const float a = on_plane ? plane_a : ray.z - c.foot, b = on_plane ? plane_b : ray.dz;
    if (a + b * from < 0) {
      t = from;
      hit.cell = index;
      hit.surface = part == 0 ? CastSurface::side : CastSurface::line;
      hit.side = part == 0 ? side : CellSide::none;
      if (part == 0 && side == CellSide::none) hit.surface = on_plane ? CastSurface::plane : CastSurface::foot;
      return true;
    }
    if (a + b * to < 0) {
      t = std::clamp(-a / b, from, to);
      hit.cell = index;
      hit.surface = on_plane ? CastSurface::plane : CastSurface::foot;
      hit.side = CellSide::none;
      return true;
    }
    if (part == 1 || !crosses) return false;
    on_plane = !on_plane;
    from = tc;
    to = t1;
  }
}

CastHit BlockMapCaster::cast(const PlanRay& ray, double before) const {
  // Into cells, the base plane taken off: straight rays stay straight.
  const double per_cell = 1 / cell_m_;
  double x = (ray.x - west_) * per_cell, y = (ray.y - south_) * per_cell;
  double z = ray.z - base_ - base_east_ * (ray.x - west_) - base_north_ * (ray.y - south_);
  const double dx = ray.dx * per_cell, dy = ray.dy * per_cell, dz = ray.dz - base_east_ * ray.dx - base_north_ * ray.dy;
  double enter = 0, leave = before;
  CellSide side = CellSide::none;
  const auto slab = [&](double at, double step, double size, CellSide low, CellSide high) {
    if (step == 0) return at >= 0 && at <= size;
    const double near = (step > 0 ? -at : size - at) / step, far = (step > 0 ? size - at : -at) / step;
    if (near > enter) enter = near, side = step > 0 ? low : high;
    leave = std::min(leave, far);
    return true;
  };
  CastHit hit;
  if (!slab(x, dx, side_, CellSide::west, CellSide::east) || !slab(y, dy, side_, CellSide::south, CellSide::north))
    return hit;
  if (dz < 0) {
    const double near = (double{top_} - z) / dz;
    if (near > enter) enter = near, side = CellSide::none;
  } else if (z + dz * enter > double{top_}) {
    return hit;
  } else if (dz > 0) {
    leave = std::min(leave, (double{top_} - z) / dz);
  }
  if (!(enter < leave)) return hit;
  x += dx * enter;
  y += dy * enter;
  z += dz * enter;
  const auto number = [](double v) { return static_cast<float>(v); };
  const float big = 1e30f;
  const LocalRay local{number(x),
                       number(y),
                       number(z),
                       number(dx),
                       number(dy),
                       number(dz),
                       dx != 0 ? number(1 / dx) : big,
                       dy != 0 ? number(1 / dy) : big};
  const float end = number(std::min(leave - enter, 1e30));
  int column = std::clamp(static_cast<int>(x), 0, side_ - 1), row = std::clamp(static_cast<int>(y), 0, side_ - 1);
  // Not from the largest square: its top is where the ray comes in. As large as a quarter of the way from there to the
  // ground.
  const float to_ground = local.dz < 0 ? std::min(end, -std::max(local.z, 0.0f) / local.dz) : end;
  const float way = std::min(to_ground * std::max(std::abs(local.dx), std::abs(local.dy)), static_cast<float>(side_));
  const int bits = static_cast<int>(std::bit_width(static_cast<unsigned>(way)));
  int level = std::clamp(bits - 2, 0, levels_ - 1);
  float t = 0;
  const int east = dx > 0, north = dy > 0;
  for (;;) {
    const int size = 1 << level, c0 = column >> level << level, r0 = row >> level << level;
    const float tx = dx != 0 ? (static_cast<float>(c0 + (east ? size : 0)) - local.x) * local.per_dx : big;
    const float ty = dy != 0 ? (static_cast<float>(r0 + (north ? size : 0)) - local.y) * local.per_dy : big;
    const float out = std::max(t, std::min({tx, ty, end}));
    const float least = local.z + local.dz * (local.dz < 0 ? out : t);
    const int square = first_[static_cast<std::size_t>(level)] + (row >> level) * (side_ >> level) + (column >> level);
    if (least <= tops_[static_cast<std::size_t>(square)]) {
      if (level > 0) {
        --level;
        // Which of the four: where the ray is now, kept within this square.
        const float at_x = local.x + local.dx * t, at_y = local.y + local.dy * t;
        column = std::clamp(static_cast<int>(at_x), c0, c0 + size - 1);
        row = std::clamp(static_cast<int>(at_y), r0, r0 + size - 1);
        // On a line between cells truncation may name the one behind; then it is left at once, at the same t.
        continue;
      }
      float at = 0;
      if (meet(local, t, out, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), side, hit, at)) {
        hit.t = enter + double{at};
        return hit;
      }
    }
    if (out >= end) return hit;
    t = out;
    if (tx <= ty) {
      column = east ? c0 + size : c0 - 1;
      row = std::clamp(static_cast<int>(local.y + local.dy * t), r0, r0 + size - 1);
      side = east ? CellSide::west : CellSide::east;
      if (column < 0 || column >= side_) return hit;
      if (level + 1 < levels_ && (column >> (level + 1)) != (c0 >> (level + 1))) ++level;
    } else {
      row = north ? r0 + size : r0 - 1;
      column = std::clamp(static_cast<int>(local.x + local.dx * t), c0, c0 + size - 1);
      side = north ? CellSide::south : CellSide::north;
      if (row < 0 || row >= side_) return hit;
      if (level + 1 < levels_ && (row >> (level + 1)) != (r0 >> (level + 1))) ++level;
    }
  }
}

}  // namespace vicus
