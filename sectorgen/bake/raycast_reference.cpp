#include "sectorgen/bake/raycast_reference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "city_db/blockmap_layout.h"

namespace vicus {
namespace {

/// The surface of one cell at a place, in metres of the plan frame.
class CellSurface {
 public:
  CellSurface(const BlockMap& map, long column, long row) : map_(map) {
    cell_ = static_cast<std::size_t>(row) * map.side + static_cast<std::size_t>(column);
    size_ = metres(map.tile_side_mm) / map.side;
    middle_x_ = metres(map.corner.x) + (static_cast<double>(column) + 0.5) * size_;
    middle_y_ = metres(map.corner.y) + (static_cast<double>(row) + 0.5) * size_;
  }
  std::size_t cell() const { return cell_; }
  bool has_line() const { return map_.offset[cell_] != 0; }
  /// Negative on the plane's side of the line; metres.
  double beside_line(double x, double y) const {
    const CellLine line = line_of(map_.angle[cell_], map_.offset[cell_]);
    return line.east * (x - middle_x_) + line.north * (y - middle_y_) - line.distance * size_;
  }
  double up(double x, double y, bool on_plane) const {
    const double base = metres(map_.base_mm) + (x - metres(map_.corner.x)) * map_.base_east / BLOCKMAP_BASE_ONE +
                        (y - metres(map_.corner.y)) * map_.base_north / BLOCKMAP_BASE_ONE;
    const double step = map_.step_um * 1e-6;
    if (!on_plane) return base + map_.foot[cell_] * step;
    return base + map_.height[cell_] * step + slope_of(map_.slope_east[cell_]) * (x - middle_x_) +
           slope_of(map_.slope_north[cell_]) * (y - middle_y_);
  }

 private:
  const BlockMap& map_;
  std::size_t cell_;
  double size_, middle_x_, middle_y_;
};

/// Every t > 0 at which the ray passes from cell to cell, ascending.
std::vector<double> crossings(const BlockMap& map, const PlanRay& ray) {
  std::vector<double> out{0};
  const double size = metres(map.tile_side_mm) / map.side;
  for (std::uint32_t i = 0; i <= map.side; ++i) {
    if (ray.dx != 0) out.push_back((metres(map.corner.x) + i * size - ray.x) / ray.dx);
    if (ray.dy != 0) out.push_back((metres(map.corner.y) + i * size - ray.y) / ray.dy);
  }
  std::erase_if(out, [](double t) { return t < 0; });
  std::sort(out.begin(), out.end());
  out.push_back(out.back() + 1e6);  // straight down, or within the last cell
  return out;
}

/// Which side of the cell a ray comes in by that came from (column, row).
CellSide side_from(long from_column, long from_row, long column, long row) {
  if (from_column < column) return CellSide::west;
  if (from_column > column) return CellSide::east;
  if (from_row < row) return CellSide::south;
  if (from_row > row) return CellSide::north;
  return CellSide::none;
}

}  // namespace

CastHit raycast_reference(const BlockMap& map, const PlanRay& ray) {
  const auto ts = crossings(map, ray);
  const double size = metres(map.tile_side_mm) / map.side;
  const auto cell_at = [&](double t, double from, double origin, double step) {
    return static_cast<long>(std::floor((origin + step * t - from) / size));
  };
  long last_column = 0, last_row = 0;
  bool has_last = false;
  for (std::size_t i = 1; i < ts.size(); ++i) {
    if (ts[i] - ts[i - 1] < 1e-12) continue;
    const double middle = (ts[i - 1] + ts[i]) / 2;
    const long column = cell_at(middle, metres(map.corner.x), ray.x, ray.dx);
    const long row = cell_at(middle, metres(map.corner.y), ray.y, ray.dy);
    const CellSide side = has_last ? side_from(last_column, last_row, column, row) : CellSide::none;
    last_column = column;
    last_row = row;
    has_last = true;
    const long n = static_cast<long>(map.side);
    if (column < 0 || row < 0 || column >= n || row >= n) continue;
    const CellSurface cell(map, column, row);
    const auto height_over = [&](double t, bool on_plane) {
      const double x = ray.x + t * ray.dx, y = ray.y + t * ray.dy;
      return ray.z + t * ray.dz - cell.up(x, y, on_plane);
    };
    const auto beside = [&](double t) { return cell.beside_line(ray.x + t * ray.dx, ray.y + t * ray.dy); };
    // The stretch before the line and the one after it.
    std::vector<double> parts{ts[i - 1], ts[i]};
    if (cell.has_line()) {
      const double a = beside(ts[i - 1]), b = beside(ts[i]);
      if ((a <= 0) != (b <= 0)) parts.insert(parts.begin() + 1, ts[i - 1] + (ts[i] - ts[i - 1]) * a / (a - b));
    }
    for (std::size_t part = 1; part < parts.size(); ++part) {
      const bool on_plane = !cell.has_line() || beside((parts[part - 1] + parts[part]) / 2) <= 0;
      const double before = height_over(parts[part - 1], on_plane), after = height_over(parts[part], on_plane);
      const auto index = static_cast<std::uint32_t>(cell.cell());
      if (before < 0) {
        if (part > 1) return {parts[part - 1], CastSurface::line, CellSide::none, index};
        return {parts[part - 1], side == CellSide::none ? CastSurface::plane : CastSurface::side, side, index};
      }
      if (after < 0)
        return {parts[part - 1] + (parts[part] - parts[part - 1]) * before / (before - after),
                on_plane ? CastSurface::plane : CastSurface::foot, CellSide::none, index};
    }
  }
  return {};
}

}  // namespace vicus
