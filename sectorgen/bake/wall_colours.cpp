#include "sectorgen/bake/wall_colours.hpp"

#include <cmath>

#include "city_db/blockmap_layout.h"
#include "sectorgen/bake/blockmap_colours.hpp"

namespace vicus {
namespace {

struct Side {
  WallBit bit;
  int east, north;
};
constexpr Side kSides[] = {{kWallEast, 1, 0}, {kWallNorth, 0, 1}, {kWallWest, -1, 0}, {kWallSouth, 0, -1}};
constexpr double kFaces = 0.5;  // cosine between a stretch of wall and the side that it may stand for

double up_at_side(const BlockMap& map, std::size_t cell, int east, int north) {
  const double half_cell_m = metres(map.tile_side_mm) / map.side / 2;
  return map.height[cell] * (map.step_um * 1e-6) +
         (slope_of(map.slope_east[cell]) * east + slope_of(map.slope_north[cell]) * north) * half_cell_m;
}

class WallPainter {
 public:
  WallPainter(const BakeScene& scene, const TileFrame& frame, const BlockMap& map, const CellPieces& pieces,
              const std::vector<CellFit>& fits, const RgbImage& roof)
      : scene_(scene), frame_(frame), map_(map), pieces_(pieces), fits_(fits), roof_(roof) {}

  RgbImage paint() {
    const auto walls = wall_bits(map_);
    const auto first = first_columns(walls);
    const std::uint32_t columns = column_total(first);
    const auto [width, height] = wall_atlas_size(columns, map_.rows);
    image_ = RgbImage(width, height);
    for (std::size_t cell = 0; cell < walls.size(); ++cell) {
      std::uint32_t column = first[cell];
      for (const Side& side : kSides)
        if (walls[cell] & side.bit) {
          find_side(cell, side);
          paint_column(cell, side.bit, column++);
        }
      if (walls[cell] & kWallLine) {
        find_line(cell);
        paint_column(cell, kWallLine, column++);
      }
    }
    pad(columns);
    return std::move(image_);
  }

 private:
  void add(const WallPiece& piece, double weight) {
    if (weight > 1e-9) found_.push_back({&piece, weight});
  }

  /// Stretches that face the side, in the cell itself or behind the side.
  void find_side(std::size_t cell, const Side& side) {
    found_.clear();
    const auto take = [&](std::size_t at) {
      for (const WallPiece& w : pieces_.walls_of(at)) {
        const double dx = w.b.x - w.a.x, dy = w.b.y - w.a.y, length = std::sqrt(dx * dx + dy * dy);
        const double facing = dy * side.east - dx * side.north;  // outward is (dy, -dx)
        if (facing > kFaces * length) add(w, facing);
      }
    };
    take(cell);
    const std::size_t n = map_.side, column = cell % n, row = cell / n;
    const bool at_rim = (side.east > 0 && column + 1 == n) || (side.east < 0 && column == 0) ||
                        (side.north > 0 && row + 1 == n) || (side.north < 0 && row == 0);
    if (found_.empty() && !at_rim)
      take((row + static_cast<std::size_t>(side.north)) * n + column + static_cast<std::size_t>(side.east));
  }

  bool is_high(std::size_t cell, const WallPiece& wall) const {
    const auto roofs = pieces_.roofs_of(cell);
    for (std::size_t i = 0; i < roofs.size(); ++i)
      if (roofs[i].house == wall.house && is_above(fits_[cell], i)) return true;
    return false;
  }

  /// Stretches of houses that the plane stands for and that look the line's way.
  void find_line(std::size_t cell) {
    found_.clear();
    const CellLine line = line_of(map_.angle[cell], map_.offset[cell]);
    const auto take = [&](double least) {
      for (const WallPiece& w : pieces_.walls_of(cell)) {
        const double dx = w.b.x - w.a.x, dy = w.b.y - w.a.y;
        const double facing = dy * line.east - dx * line.north;
        if (facing > least * std::sqrt(dx * dx + dy * dy) && is_high(cell, w)) add(w, facing);
      }
    };
    take(kFaces);
    if (found_.empty()) take(0);
  }

  void paint_column(std::size_t cell, WallBit bit, std::uint32_t column) {
    const WallSpan span = wall_span(map_, cell, bit);
    const double x = frame_.west_m() + (static_cast<double>(cell % map_.side) + 0.5) * frame_.cell_m();
    const double y = frame_.south_m() + (static_cast<double>(cell / map_.side) + 0.5) * frame_.cell_m();
    const double base = frame_.base.at(x, y), step = (span.high_m - span.low_m) / map_.rows;
    const ColourMean plain =
        found_.empty() ? mean_of(roof_.at(cell % map_.side, map_.side - 1 - cell / map_.side)) : ColourMean{};
    const std::size_t strip = column / BLOCKMAP_ATLAS_WIDTH;
    sums_.assign(map_.rows, plain);
    double total = found_.empty() ? 1 : 0;
    for (const auto& [piece, weight] : found_) {
      const BakeHouse& house = scene_.houses()[piece->house];
      const BakeWall& wall = house.walls[piece->wall];
      const WallColumn colours(house, wall, piece->from, piece->to);
      ColourMean below = colours.up_to(base + span.low_m);
      for (std::uint32_t row = 0; row < map_.rows; ++row) {
        const ColourMean above = colours.up_to(base + span.low_m + (row + 1) * step);
        sums_[row] = sums_[row] + (above + below * -1) * (wall.light * weight / step);
        below = above;
      }
      total += weight;
    }
    for (std::uint32_t row = 0; row < map_.rows; ++row)
      image_.set(column % BLOCKMAP_ATLAS_WIDTH, (strip + 1) * map_.rows - 1 - row, rounded(sums_[row] * (1 / total)));
  }

  /// What is left of the last strip repeats its last column: it costs nothing.
  void pad(std::uint32_t columns) {
    if (columns == 0 || columns <= BLOCKMAP_ATLAS_WIDTH) return;
    const std::size_t last = columns - 1, strip = last / BLOCKMAP_ATLAS_WIDTH;
    for (std::size_t c = last % BLOCKMAP_ATLAS_WIDTH + 1; c < BLOCKMAP_ATLAS_WIDTH; ++c)
      for (std::size_t r = strip * map_.rows; r < (strip + 1) * map_.rows; ++r)
        image_.set(c, r, image_.at(last % BLOCKMAP_ATLAS_WIDTH, r));
  }

  const BakeScene& scene_;
  const TileFrame& frame_;
  const BlockMap& map_;
  const CellPieces& pieces_;
  const std::vector<CellFit>& fits_;
  const RgbImage& roof_;
  std::vector<std::pair<const WallPiece*, double>> found_;
  std::vector<ColourMean> sums_;  // of a column, from its foot
  RgbImage image_;
};

}  // namespace

WallSpan wall_span(const BlockMap& map, std::size_t cell, WallBit wall) {
  const double step = map.step_um * 1e-6;
  WallSpan span;
  if (wall == kWallLine) {
    span = {map.foot[cell] * step, map.height[cell] * step};
  } else {
    const std::size_t n = map.side, column = cell % n, row = cell / n;
    for (const Side& s : kSides) {
      if (s.bit != wall) continue;
      span.high_m = up_at_side(map, cell, s.east, s.north);
      const bool at_rim = (s.east > 0 && column + 1 == n) || (s.east < 0 && column == 0) ||
                          (s.north > 0 && row + 1 == n) || (s.north < 0 && row == 0);
      if (!at_rim)
        span.low_m =
            up_at_side(map, (row + static_cast<std::size_t>(s.north)) * n + column + static_cast<std::size_t>(s.east),
                       -s.east, -s.north);
    }
  }
  if (span.high_m < span.low_m + step) span.high_m = span.low_m + step;
  return span;
}

RgbImage wall_colours(const BakeScene& scene, const TileFrame& frame, const BlockMap& map, const CellPieces& pieces,
                      const std::vector<CellFit>& fits, const RgbImage& roof) {
  return WallPainter(scene, frame, map, pieces, fits, roof).paint();
}

}  // namespace vicus
