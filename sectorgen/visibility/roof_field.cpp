#include "sectorgen/visibility/roof_field.hpp"

#include <algorithm>
#include <cmath>

namespace vicus {
namespace {

constexpr double kDoubt_m = 0.001;
constexpr double kFullHeight_m = 127;  // of houses above the highest ground; what is higher counts as so high
/// Times the finest cell; a cell of each grid is at most a quarter of its radius.
constexpr double kRadii[] = {1.1, 1.6, 2.2, 3.2, 4.4, 6.2, 8.8, 12.5, 17.5, 25};

using Heights = std::vector<std::uint8_t>;

/// The least of each value and of all cells within `radius` cells of any point of it; beyond the rim is ground.
Heights worn(const Heights& from, std::int64_t columns, std::int64_t rows, double radius) {
  const auto reach = static_cast<std::int64_t>(std::floor(radius)) + 1;
  // Per row above or below: how many cells to each side a disc touches that may lie anywhere in the middle cell.
  std::vector<std::int64_t> half_width;
  for (std::int64_t d = 0; d <= reach; ++d) {
    const double gap = d > 0 ? static_cast<double>(d - 1) : 0;
    if (gap > radius) break;
    half_width.push_back(static_cast<std::int64_t>(std::floor(std::sqrt(radius * radius - gap * gap))) + 1);
  }
  const auto lines = static_cast<std::int64_t>(half_width.size());
  const auto line_at = [&](auto& heights, std::int64_t row) { return heights.data() + row * columns; };
  Heights out(from.size(), 255), window(static_cast<std::size_t>(columns));
  for (std::int64_t row = 0; row < rows; ++row)
    for (std::int64_t d = 0, width = -1; d < lines; ++d) {
      // From the narrowest to the widest: each window goes on from the one before.
      const std::int64_t line = lines - 1 - d;
      const std::uint8_t* source = line_at(from, row);
      if (width < 0) {
        std::copy(source, source + columns, window.begin());
        width = 0;
      }
      for (++width; width <= half_width[static_cast<std::size_t>(line)]; ++width) {
        const std::int64_t w = width;
        for (std::int64_t c = 0; c < columns - w; ++c)
          window[static_cast<std::size_t>(c)] = std::min(window[static_cast<std::size_t>(c)], source[c + w]);
        for (std::int64_t c = w; c < columns; ++c)
          window[static_cast<std::size_t>(c)] = std::min(window[static_cast<std::size_t>(c)], source[c - w]);
        std::fill(window.begin(), window.begin() + std::min(w, columns), std::uint8_t{0});
        std::fill(window.end() - std::min(w, columns), window.end(), std::uint8_t{0});
      }
      --width;
      for (const std::int64_t target_row : {row - line, row + line}) {
        if (target_row < 0 || target_row >= rows) continue;
        std::uint8_t* target = line_at(out, target_row);
        for (std::int64_t c = 0; c < columns; ++c) target[c] = std::min(target[c], window[static_cast<std::size_t>(c)]);
      }
    }
  for (std::int64_t row = 0; row < rows; ++row)
    if (row < reach || row + reach >= rows) std::fill(line_at(out, row), line_at(out, row) + columns, std::uint8_t{0});
  return out;
}

struct Plane {
  double cell_m = 0;
  std::int64_t columns = 0, rows = 0;
  Heights height;
};

/// Four cells to one, the least of them.
Plane halved(const Plane& fine) {
  Plane out{2 * fine.cell_m, (fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
  out.height.assign(static_cast<std::size_t>(out.columns * out.rows), 255);
  for (std::int64_t row = 0; row < fine.rows; ++row)
    for (std::int64_t column = 0; column < fine.columns; ++column) {
      std::uint8_t& target = out.height[static_cast<std::size_t>(row / 2 * out.columns + column / 2)];
      target = std::min(target, fine.height[static_cast<std::size_t>(row * fine.columns + column)]);
    }
  return out;
}

WornGrid in_blocks(const Plane& plane, double radius_m) {
  WornGrid grid{plane.cell_m, 1 / plane.cell_m, radius_m, plane.columns, plane.rows, (plane.columns + 7) / 8, {}, {}};
  const std::int64_t block_rows = (plane.rows + 7) / 8;
  grid.block.assign(static_cast<std::size_t>(grid.block_columns * block_rows), 0);
  grid.height.assign(64, 0);
  std::uint8_t block[64];
  for (std::int64_t y = 0; y < block_rows; ++y)
    for (std::int64_t x = 0; x < grid.block_columns; ++x) {
      std::fill(std::begin(block), std::end(block), std::uint8_t{0});
      for (std::int64_t row = 8 * y; row < std::min(8 * y + 8, plane.rows); ++row)
        std::copy_n(&plane.height[static_cast<std::size_t>(row * plane.columns + 8 * x)],
                    std::min<std::int64_t>(8, plane.columns - 8 * x), &block[8 * (row - 8 * y)]);
      if (std::all_of(std::begin(block), std::end(block), [](std::uint8_t h) { return h == 0; })) continue;
      grid.block[static_cast<std::size_t>(y * grid.block_columns + x)] =
          static_cast<std::uint32_t>(grid.height.size() / 64);
      grid.height.insert(grid.height.end(), std::begin(block), std::end(block));
    }
  return grid;
}

}  // namespace

RoofField::RoofField(const HouseWalls& houses, std::size_t most_cells) {
  bool is_first = true;
  for (const auto& w : houses.walls()) {
    if (is_first) left_ = right_ = w.a.x, bottom_ = top_ = w.a.y, is_first = false;
    left_ = std::min(left_, w.a.x);
    right_ = std::max(right_, w.a.x);
    bottom_ = std::min(bottom_, w.a.y);
    top_ = std::max(top_, w.a.y);
  }
  double cell = 0.5;
  while ((right_ - left_) / cell * ((top_ - bottom_) / cell) > static_cast<double>(most_cells)) cell *= 2;
  const auto columns = static_cast<std::int64_t>((right_ - left_) / cell) + 1;
  const auto rows = static_cast<std::int64_t>((top_ - bottom_) / cell) + 1;
  // Flat ground: base 0. On slopes from the lowest roof up, in coarser steps where 255 of them would not do.
  double least_m = 0, most_m = 0;
  for (const auto& house : houses.houses()) {
    least_m = std::min(least_m, house.sure_top_m);
    most_m = std::max(most_m, house.most_zero_m + kFullHeight_m);
  }
  base_m_ = std::floor(least_m) - (least_m < 0 ? 1 : 0);
  step_m_ = std::max(kHeightStep_m, (most_m - base_m_) / 255);
  const Heights heights = draw(houses, cell, columns, rows);
  tile_columns_ = static_cast<std::size_t>((right_ - left_) / kTile_m) + 1;
  tile_rows_ = static_cast<std::size_t>((top_ - bottom_) / kTile_m) + 1;
  tiles_.assign(tile_columns_ * tile_rows_, 0);
  const auto tile_cells = static_cast<std::int64_t>(kTile_m / cell);
  for (std::int64_t row = 0; row < rows; ++row)
    for (std::int64_t column = 0; column < columns; ++column) {
      const std::uint8_t height = heights[static_cast<std::size_t>(row * columns + column)];
      // A coarse cell may lie in several tiles.
      const auto last = [&](std::int64_t at, std::size_t most) {
        return std::min(most - 1, static_cast<std::size_t>(static_cast<double>(at + 1) * cell / kTile_m));
      };
      if (height == 0) continue;
      ceiling_ = std::max(ceiling_, height);
      if (tile_cells > 0) {
        std::uint8_t& tile = tiles_[static_cast<std::size_t>(row / tile_cells) * tile_columns_ +
                                    static_cast<std::size_t>(column / tile_cells)];
        tile = std::max(tile, height);
        continue;
      }
      for (auto r = static_cast<std::size_t>(static_cast<double>(row) * cell / kTile_m); r <= last(row, tile_rows_);
           ++r)
        for (auto c = static_cast<std::size_t>(static_cast<double>(column) * cell / kTile_m);
             c <= last(column, tile_columns_); ++c)
          tiles_[r * tile_columns_ + c] = std::max(tiles_[r * tile_columns_ + c], height);
    }
  for (const double radius : kRadii) {
    Plane plane{cell, columns, rows, worn(heights, columns, rows, radius)};
    while (plane.cell_m * 8 <= radius * cell) plane = halved(plane);
    grids_.push_back(in_blocks(plane, radius * cell));
  }
}

namespace {

/// The cells of a grid whose square comes within 1 mm of a wall, or more.
template <class Visit>
void visit_cells_at(const HouseWall& w, double cell_m, Spot corner, std::int64_t columns, std::int64_t rows,
                    Visit visit) {
  const auto row_at = [&](double y) {
    return std::clamp(static_cast<std::int64_t>(std::floor((y - corner.y) / cell_m)), std::int64_t{0}, rows - 1);
  };
  const auto column_at = [&](double x) {
    return std::clamp(static_cast<std::int64_t>(std::floor((x - corner.x) / cell_m)), std::int64_t{0}, columns - 1);
  };
  const Spot p = w.a.y < w.b.y ? w.a : w.b, q = w.a.y < w.b.y ? w.b : w.a;
  const double slope = q.y > p.y ? (q.x - p.x) / (q.y - p.y) : 0;
  for (std::int64_t row = row_at(p.y - kDoubt_m); row <= row_at(q.y + kDoubt_m); ++row) {
    const double from_y = corner.y + static_cast<double>(row) * cell_m - kDoubt_m,
                 to_y = from_y + cell_m + 2 * kDoubt_m;
    double from = p.x, to = q.x;
    if (q.y > p.y) {
      from = p.x + (std::clamp(from_y, p.y, q.y) - p.y) * slope;
      to = p.x + (std::clamp(to_y, p.y, q.y) - p.y) * slope;
    }
    const std::int64_t last = column_at(std::max(from, to) + 2 * kDoubt_m);
    for (std::int64_t column = column_at(std::min(from, to) - 2 * kDoubt_m); column <= last; ++column)
      visit(column, row);
  }
}

/// One house's part of a grid.
struct HousePatch {
  std::int64_t column = 0, row = 0, columns = 0, rows = 0;
  std::vector<float> up;  // the least of its roof over the cell, metres; kNoRoof_m: not asked
  float& at(std::int64_t c, std::int64_t r) { return up[static_cast<std::size_t>((r - row) * columns + c - column)]; }
};

}  // namespace

/// Each cell's sure height: the least of the roof of the house that fills it, and of those whose walls touch it; none
/// where a wall has no house behind it.
Heights RoofField::draw(const HouseWalls& houses, double cell_m, std::int64_t columns, std::int64_t rows) const {
  Heights heights(static_cast<std::size_t>(columns * rows), 0);
  std::vector<std::uint8_t> wall_limit(heights.size(), 255);
  const Spot corner{left_, bottom_};
  const auto cell_at = [&](std::int64_t column, std::int64_t row) {
    return static_cast<std::size_t>(row * columns + column);
  };
  const auto row_at = [&](double y) {
    return std::clamp(static_cast<std::int64_t>(std::floor((y - bottom_) / cell_m)), std::int64_t{0}, rows - 1);
  };
  const auto column_at = [&](double x) {
    return std::clamp(static_cast<std::int64_t>(std::floor((x - left_) / cell_m)), std::int64_t{0}, columns - 1);
  };
  const double reach = cell_m * 0.7072 + kDoubt_m;  // of a cell's corners from its middle
  HousePatch patch;
  std::vector<double> cuts;
  for (const auto& house : houses.houses()) {
    if (!house.stands() || house.first_wall == house.last_wall) continue;
    Spot low = houses.walls()[house.first_wall].a, high = low;
    for (std::uint32_t i = house.first_wall; i < house.last_wall; ++i) {
      const Spot a = houses.walls()[i].a;
      low = {std::min(low.x, a.x), std::min(low.y, a.y)};
      high = {std::max(high.x, a.x), std::max(high.y, a.y)};
    }
    patch.column = column_at(low.x - kDoubt_m), patch.row = row_at(low.y - kDoubt_m);
    patch.columns = column_at(high.x + kDoubt_m) - patch.column + 1,
    patch.rows = row_at(high.y + kDoubt_m) - patch.row + 1;
    const bool has_roof = house.first_triangle != house.last_triangle;
    const auto top = static_cast<float>(has_roof ? house.sure_top_m : house.sure_eave_m);
    patch.up.assign(static_cast<std::size_t>(patch.columns * patch.rows), top);
    for (std::uint32_t i = house.first_triangle; i < house.last_triangle; ++i) {
      const RoofTriangle& t = *houses.triangles(i);
      for (std::int64_t row = row_at(t.low_corner().y - kDoubt_m); row <= row_at(t.high_corner().y + kDoubt_m); ++row)
        for (std::int64_t column = column_at(t.low_corner().x - kDoubt_m);
             column <= column_at(t.high_corner().x + kDoubt_m); ++column) {
          const Spot middle{left_ + (static_cast<double>(column) + 0.5) * cell_m,
                            bottom_ + (static_cast<double>(row) + 0.5) * cell_m};
          float& up = patch.at(column, row);
          up = std::min(up, static_cast<float>(house.sure_zero_m + t.least_within(middle, reach) - kDoubt_m));
        }
    }
    for (std::uint32_t i = house.first_wall; i < house.last_wall; ++i) {
      const HouseWall& w = houses.walls()[i];
      visit_cells_at(w, cell_m, corner, columns, rows, [&](std::int64_t column, std::int64_t row) {
        std::uint8_t& limit = wall_limit[cell_at(column, row)];
        limit = std::min(limit, w.beyond_m <= kNoRoof_m ? std::uint8_t{0} : step_below(patch.at(column, row)));
      });
    }
    for (std::int64_t row = patch.row; row < patch.row + patch.rows; ++row) {
      const double y = bottom_ + (static_cast<double>(row) + 0.5) * cell_m;
      cuts.clear();
      for (std::uint32_t i = house.first_wall; i < house.last_wall; ++i) {
        const HouseWall& w = houses.walls()[i];
        if ((w.a.y > y) != (w.b.y > y)) cuts.push_back(w.a.x + (y - w.a.y) / (w.b.y - w.a.y) * (w.b.x - w.a.x));
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
        const auto first = static_cast<std::int64_t>(std::ceil((cuts[i] - left_) / cell_m - 0.5));
        const auto last = static_cast<std::int64_t>(std::floor((cuts[i + 1] - left_) / cell_m - 0.5));
        for (std::int64_t column = std::max(first, patch.column);
             column <= std::min(last, patch.column + patch.columns - 1); ++column) {
          std::uint8_t& cell = heights[cell_at(column, row)];
          cell = std::max(cell, step_below(patch.at(column, row)));
        }
      }
    }
  }
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = std::min(heights[i], wall_limit[i]);
  return heights;
}

}  // namespace vicus
