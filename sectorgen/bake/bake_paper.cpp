#include "sectorgen/bake/bake_paper.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "city_db/blockmap2007_layout.h"
#include "city_db/blockmap2009_layout.h"
#include "city_db/blockmap_layout.h"
#include "sectorgen/bake/cell_pieces.hpp"
#include "sectorgen/bake/ground_colours.hpp"

namespace vicus {
namespace {

constexpr int kStep[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};  // by CellSide
constexpr double kSteepestRoof = 1;                              // rise over run, 2009
constexpr double kFullTop_mm = 65535.0;

std::uint8_t byte_of(double v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5, 0.0, 255.0)); }
std::uint8_t normal_byte(double v) { return byte_of((v + 1) * 127.5); }

class PaperBaker {
 public:
  PaperBaker(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm, PaperYear year, std::uint32_t side,
             std::uint32_t columns)
      : scene_(scene), frame_{corner, side, tile_side_mm, {}} {
    map_.year = year;
    map_.side = side;
    map_.columns = columns;
    map_.corner = corner;
    map_.tile_side_mm = tile_side_mm;
    map_.texels.assign(std::size_t{map_.width()} * side * map_.channels(), 0);
    n_ = static_cast<long>(side);
  }

  PaperBlockMap bake() {
    set_heights();
    set_distances();
    set_roofs();
    unfold();
    slice();
    paint_walls();
    return std::move(map_);
  }

 private:
  std::size_t index(long column, long row) const { return static_cast<std::size_t>(row * n_ + column); }
  bool is_inside(long column, long row) const { return column >= 0 && row >= 0 && column < n_ && row < n_; }
  int height(long column, long row) const {
    return is_inside(column, row) ? map_.cell(static_cast<std::size_t>(column), static_cast<std::size_t>(row))[0] : 0;
  }

  void set_heights() {
    pieces_ = cut_to_cells(scene_, scene_.houses_in(frame_.box()), frame_);
    const std::size_t cells = std::size_t{map_.side} * map_.side;
    std::vector<double> up(cells, -1);
    double base = 1e9, top = 0;
    for (const std::uint32_t i : scene_.houses_in(frame_.box())) base = std::min(base, scene_.houses()[i].ground_m);
    map_.base_mm = base > 1e8 ? 0 : static_cast<std::int32_t>(std::floor(base * kMmPerMetre));
    for (std::size_t c = 0; c < cells; ++c) {
      double area = 0, sum = 0;
      for (const RoofPiece& p : pieces_.roofs_of(c)) area += p.area, sum += p.area * p.up;
      if (area < 0.5) continue;
      up[c] = sum / area - metres(map_.base_mm);
      top = std::max(top, up[c]);
    }
    map_.top_mm = static_cast<std::uint32_t>(std::max(1.0, std::ceil(top * kMmPerMetre)));
    for (std::size_t c = 0; c < cells; ++c)
      if (up[c] >= 0)
        map_.cell(c % map_.side, c / map_.side)[0] =
            std::max<std::uint8_t>(1, byte_of(up[c] / metres(map_.top_mm) * 255));
  }

  /// Texels to the nearest house, along rows and columns and diagonals (Chebyshev), by widening rings.
  void set_distances() {
    std::vector<int> distance(std::size_t{map_.side} * map_.side, -1);
    std::deque<std::pair<long, long>> queue;
    for (long row = 0; row < n_; ++row)
      for (long column = 0; column < n_; ++column)
        if (height(column, row) > 0) distance[index(column, row)] = 0, queue.emplace_back(column, row);
    while (!queue.empty()) {
      const auto [column, row] = queue.front();
      queue.pop_front();
      for (long r = row - 1; r <= row + 1; ++r)
        for (long c = column - 1; c <= column + 1; ++c)
          if (is_inside(c, r) && distance[index(c, r)] < 0) {
            distance[index(c, r)] = distance[index(column, row)] + 1;
            queue.emplace_back(c, r);
          }
    }
    for (std::size_t c = 0; c < distance.size(); ++c) {
      std::uint8_t* p = map_.cell(c % map_.side, c / map_.side);
      p[BLOCKMAP2007_DISTANCE_CHANNEL] = byte_of(distance[c] < 0 ? 255 : distance[c]);
      if (map_.year == PaperYear::y2009 && p[0] == 0) p[BLOCKMAP2009_COLUMN_HIGH_CHANNEL] = 255;
    }
  }

  void set_roofs() {
    const GroundColours ground(scene_, frame_, true);
    ambient_ = ambient_light(scene_, frame_);
    for (long row = 0; row < n_; ++row)
      for (long column = 0; column < n_; ++column) {
        const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
        const bool is_house = height(column, row) > 0;
        ColourMean sum;
        double area = 0, east = 0, north = 0;
        if (is_house)
          for (const RoofPiece& p : pieces_.roofs_of(index(column, row))) {
            sum = sum + mean_of(scene_.houses()[p.house].roof_colour) * p.area;
            const double a = p.east / frame_.cell_m(), b = p.north / frame_.cell_m(),
                         length = std::sqrt(a * a + b * b + 1);
            east -= p.area * a / length;
            north -= p.area * b / length;
            area += p.area;
          }
        const Colour colour = rounded(area > 0 ? sum * (1 / area) : ground.of_cell(c, r));
        std::uint8_t* p = map_.texel(map_.side + c, map_.side - 1 - r);
        p[0] = colour.r, p[1] = colour.g, p[2] = colour.b;
        if (map_.year == PaperYear::y2007) continue;
        p[3] = ambient_at(column, row);
        if (!is_house) continue;
        const auto seventh = [&](double v) {
          return static_cast<unsigned>(std::clamp(std::lround(v / area * 7) + 8, 1L, 15L));
        };
        map_.cell(c, r)[BLOCKMAP2009_NORMAL_CHANNEL] = static_cast<std::uint8_t>(seventh(east) << 4 | seventh(north));
      }
  }

  std::uint8_t ambient_at(long column, long row) const {
    return ambient_[static_cast<std::size_t>(row / 2 * (n_ / 2) + column / 2)];
  }

  bool is_boundary(long column, long row) const {
    if (height(column, row) == 0) return false;
    for (const auto& s : kStep)
      if (height(column + s[0], row + s[1]) < height(column, row)) return true;
    return false;
  }

  /// The boundary texels in the order of the walk along each boundary.
  void unfold() {
    std::vector<bool> seen(std::size_t{map_.side} * map_.side);
    for (long row = 0; row < n_; ++row)
      for (long column = 0; column < n_; ++column) {
        if (seen[index(column, row)] || !is_boundary(column, row)) continue;
        for (long c = column, r = row;;) {
          seen[index(c, r)] = true;
          order_.push_back(index(c, r));
          bool goes_on = false;
          for (const auto& [dc, dr] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
            const long nc = c + dc, nr = r + dr;
            if (!is_inside(nc, nr) || seen[index(nc, nr)] || !is_boundary(nc, nr)) continue;
            c = nc, r = nr;
            goes_on = true;
            break;
          }
          if (!goes_on) break;
        }
      }
  }

  std::size_t slice_of(std::size_t cell) const {  // the first at the top, like the rows
    return (map_.side - 1 - cell / map_.side) * map_.slices / map_.side;
  }

  /// 2009: as many slices as it takes until none has more boundary texels than there are columns.
  void slice() {
    map_.slices = 1;
    if (map_.year == PaperYear::y2007) return;
    for (; map_.slices * 2 <= map_.side / 4; map_.slices *= 2) {  // powers of two: equal parts of the rows
      std::vector<std::size_t> count(map_.slices);
      for (const std::size_t cell : order_) ++count[slice_of(cell)];
      if (*std::max_element(count.begin(), count.end()) <= map_.columns) return;
    }
  }

  void paint_walls() {
    std::vector<std::vector<std::size_t>> in_slice(map_.slices);
    for (const std::size_t cell : order_) in_slice[slice_of(cell)].push_back(cell);
    const std::size_t rows = map_.side / map_.slices;
    for (std::size_t s = 0; s < map_.slices; ++s) {
      const auto& cells = in_slice[s];
      const std::size_t usable =
          std::min<std::size_t>(map_.columns, map_.year == PaperYear::y2007 ? BLOCKMAP2007_LAST_COLUMN : map_.columns);
      // More boundary texels than columns: several share one, and their colours are averaged.
      for (std::size_t i = 0; i < cells.size();) {
        const std::size_t column = cells.size() <= usable ? i : i * usable / cells.size();
        std::size_t end = i + 1;
        while (cells.size() > usable && end < cells.size() && end * usable / cells.size() == column) ++end;
        paint_column(cells, i, end, column, s * rows, rows);
        i = end;
      }
    }
  }

  void paint_column(const std::vector<std::size_t>& cells, std::size_t begin, std::size_t end, std::size_t column,
                    std::size_t first_row, std::size_t rows) {
    std::vector<ColourMean> sum(rows - 1);
    double east = 0, north = 0, ambient = 0, total = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t cell = cells[i];
      const auto c = static_cast<long>(cell % map_.side), r = static_cast<long>(cell / map_.side);
      map_.set_wall_column(cell % map_.side, cell / map_.side, static_cast<std::uint32_t>(column + 1));
      for (const auto& s : kStep) {
        if (height(c + s[0], r + s[1]) >= height(c, r)) continue;
        east += s[0];
        north += s[1];
        if (is_inside(c + s[0], r + s[1]))
          ambient += ambient_at(c + s[0], r + s[1]);
        else
          ambient += 255;
        add_side(c, r, s, sum);
        total += 1;
      }
    }
    const double length = std::max(1e-9, std::sqrt(east * east + north * north));
    const auto put = [&](std::size_t row, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
      std::uint8_t* p = map_.texel(2 * map_.side + column, first_row + row);
      p[0] = r, p[1] = g, p[2] = b;
      if (map_.year == PaperYear::y2009) p[3] = byte_of(ambient / std::max(1.0, total));
    };
    for (std::size_t row = 0; row + 1 < rows; ++row) {
      const Colour colour = rounded(sum[row] * (1 / std::max(1.0, total)));
      put(rows - 2 - row, colour.r, colour.g, colour.b);
    }
    put(rows - 1, normal_byte(east / length), normal_byte(north / length), normal_byte(0));
  }

  /// Means of the walls that face a side, row by row of the prism's height.
  void add_side(long column, long row, const int (&side)[2], std::vector<ColourMean>& sum) const {
    std::vector<std::pair<const WallPiece*, double>> found;
    const auto take = [&](long c, long r) {
      if (!is_inside(c, r)) return;
      for (const WallPiece& w : pieces_.walls_of(index(c, r))) {
        const double dx = w.b.x - w.a.x, dy = w.b.y - w.a.y;
        const double facing = dy * side[0] - dx * side[1];
        if (facing > 1e-9) found.push_back({&w, facing});
      }
    };
    take(column, row);
    if (found.empty()) take(column + side[0], row + side[1]);
    const double top = height(column, row) / 255.0 * metres(map_.top_mm), base = metres(map_.base_mm);
    const RoofPiece* largest = nullptr;
    for (const RoofPiece& p : pieces_.roofs_of(index(column, row)))
      if (!largest || p.area > largest->area) largest = &p;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double low = base + top * double(i) / double(sum.size()),
                   high = base + top * double(i + 1) / double(sum.size());
      ColourMean mean = mean_of(largest ? scene_.houses()[largest->house].wall_colour : kBeyondCity);
      double weight = 0;
      ColourMean colours;
      for (const auto& [piece, facing] : found) {
        const BakeHouse& house = scene_.houses()[piece->house];
        colours = colours + wall_mean(house, house.walls[piece->wall], piece->from, piece->to, low, high) * facing;
        weight += facing;
      }
      sum[i] = sum[i] + (weight > 0 ? colours * (1 / weight) : mean);
    }
  }

  const BakeScene& scene_;
  TileFrame frame_;
  PaperBlockMap map_;
  long n_ = 0;
  CellPieces pieces_;
  std::vector<std::uint8_t> ambient_;
  std::vector<std::size_t> order_;
};

}  // namespace

PaperBlockMap bake_paper(const BakeScene& scene, PlanPoint corner, std::uint32_t tile_side_mm, PaperYear year,
                         std::uint32_t side, std::uint32_t columns) {
  return PaperBaker(scene, corner, tile_side_mm, year, side, columns).bake();
}

BlockMap surface_of(const PaperBlockMap& map) {
  BlockMap out;
  out.side = map.side;
  out.rows = BLOCKMAP_LEAST_ROWS;
  out.corner = map.corner;
  out.tile_side_mm = map.tile_side_mm;
  out.base_mm = map.base_mm;
  out.step_um = std::max(1u, static_cast<std::uint32_t>(std::ceil(map.top_mm * 1000.0 / kFullTop_mm)));
  const std::size_t cells = std::size_t{map.side} * map.side;
  for (auto* list : {&out.angle, &out.offset}) list->assign(cells, 0);
  for (auto* list : {&out.slope_east, &out.slope_north}) list->assign(cells, BLOCKMAP_SLOPE_ZERO);
  out.height.resize(cells);
  out.foot.assign(cells, 0);
  for (std::size_t i = 0; i < cells; ++i)
    out.height[i] = static_cast<std::uint16_t>(
        std::lround(map.cell(i % map.side, i / map.side)[0] / 255.0 * map.top_mm * 1000.0 / out.step_um));
  return out;
}

double paper_sent_bytes(const PaperBlockMap& map) {
  double sum = 0;
  const auto part = [&](std::size_t first, std::size_t count, bool alpha, int quality) {
    RgbImage image(static_cast<std::uint32_t>(count), map.side);
    for (std::size_t row = 0; row < map.side; ++row)
      for (std::size_t c = 0; c < count; ++c) {
        const auto* p = map.texel(first + c, row);
        image.set(c, row, alpha ? Colour{p[3], p[3], p[3]} : Colour{p[0], p[1], p[2]});
      }
    sum += double(encode_webp(image, quality).size());
  };
  const bool has_alpha = map.year == PaperYear::y2009;
  part(0, map.side, false, kLossless);
  if (has_alpha) part(0, map.side, true, kLossless);
  part(map.side, map.side + map.columns, false, 80);
  if (has_alpha) part(map.side, map.side + map.columns, true, 80);
  return sum;
}

HitLook look_of(const PaperBlockMap& map, const BlockMap& surface, const PlanRay& ray, const CastHit& hit) {
  const std::size_t column = hit.cell % map.side, row = hit.cell / map.side;
  const std::uint8_t* cell = map.cell(column, row);
  HitLook look;
  const auto as_roof = [&] {
    const std::uint8_t* p = map.texel(map.side + column, map.side - 1 - row);
    look.colour = {p[0], p[1], p[2]};
    if (map.year == PaperYear::y2007) return;
    look.ambient = p[3] / 255.0;
    if (cell[0] == 0) return;
    const std::uint8_t normal = cell[BLOCKMAP2009_NORMAL_CHANNEL];
    look.east = ((normal >> 4) - 8) / 7.0;
    look.north = ((normal & 15) - 8) / 7.0;
    look.up = std::sqrt(std::max(0.0, 1 - look.east * look.east - look.north * look.north));
  };
  const std::uint32_t wall = map.wall_column(column, row);
  bool is_roof = hit.surface != CastSurface::side || wall == 0;
  if (!is_roof && map.year == PaperYear::y2009) {
    const int* step = kStep[static_cast<int>(hit.side)];
    const long c = static_cast<long>(column) + step[0], r = static_cast<long>(row) + step[1],
               n = static_cast<long>(map.side);
    const std::uint8_t before = c >= 0 && r >= 0 && c < n && r < n
                                    ? map.cell(static_cast<std::size_t>(c), static_cast<std::size_t>(r))[0]
                                    : std::uint8_t{0};
    const double rise = (cell[0] - before) / 255.0 * metres(map.top_mm);
    is_roof = rise < kSteepestRoof * metres(map.tile_side_mm) / map.side;
  }
  if (is_roof) {
    as_roof();
    return look;
  }
  const std::size_t rows = map.side / map.slices, slice = (map.side - 1 - row) * map.slices / map.side;
  const double top = surface.height[hit.cell] * (surface.step_um * 1e-6);
  const double up = ray.z + hit.t * ray.dz - metres(map.base_mm);
  const auto v =
      static_cast<std::size_t>(std::clamp(up / std::max(top, 1e-6) * double(rows - 1), 0.0, double(rows - 2)));
  const std::size_t at = 2 * map.side + wall - 1;
  const std::uint8_t* p = map.texel(at, slice * rows + rows - 2 - v);
  const std::uint8_t* normal = map.texel(at, slice * rows + rows - 1);
  look.colour = {p[0], p[1], p[2]};
  look.east = normal[0] / 127.5 - 1;
  look.north = normal[1] / 127.5 - 1;
  look.up = 0;
  if (map.year == PaperYear::y2009) look.ambient = p[3] / 255.0;
  return look;
}

}  // namespace vicus
