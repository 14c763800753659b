#include "sectorgen/bake/cell_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace vicus {
namespace {

/// A convex polygon with few corners: a triangle cut by the four sides of a cell has at most seven.
struct SmallPolygon {
  double x[10], y[10];
  std::size_t count = 0;
  void add(CellPoint p) {
    x[count] = p.x;
    y[count++] = p.y;
  }
  CellPoint at(std::size_t i) const { return {x[i], y[i]}; }
};

/// Cuts off what lies below `limit`, exactly on it where the edges cross; `rest` keeps what lies above.
void split(const SmallPolygon& whole, bool is_x, double limit, SmallPolygon& below, SmallPolygon& rest) {
  below.count = rest.count = 0;
  const double* along = is_x ? whole.x : whole.y;
  for (std::size_t i = 0; i < whole.count; ++i) {
    const std::size_t next = i + 1 == whole.count ? 0 : i + 1;
    const CellPoint p = whole.at(i), q = whole.at(next);
    const double pc = along[i], qc = along[next];
    if (pc <= limit) below.add(p);
    if (pc >= limit) rest.add(p);
    if ((pc < limit && qc > limit) || (pc > limit && qc < limit)) {
      const double t = (limit - pc) / (qc - pc);
      const CellPoint cut = is_x ? CellPoint{limit, p.y + t * (q.y - p.y)} : CellPoint{p.x + t * (q.x - p.x), limit};
      below.add(cut);
      rest.add(cut);
    }
  }
}

class Cutter {
 public:
  Cutter(const BakeScene& scene, const TileFrame& frame, CellPieces& out)
      : scene_(scene), frame_(frame), cell_m_(frame.cell_m()), out_(out) {}

  void add_house(std::uint32_t index) {
    house_ = index;
    const BakeHouse& house = scene_.houses()[index];
    for (const BakeTriangle& t : house.roof) {
      plane_ = &house.planes[t.plane];
      shown_ = house.lit_roof[t.plane];
      SmallPolygon polygon;
      for (std::size_t k = 0; k < 3; ++k) polygon.add(cells_of(t.x[k], t.y[k]));
      cut_rows(polygon);
    }
    for (std::uint32_t w = 0; w < house.walls.size(); ++w) cut_wall(house.walls[w], w);
  }

 private:
  CellPoint cells_of(double x, double y) const {
    return {(x - frame_.west_m()) / cell_m_, (y - frame_.south_m()) / cell_m_};
  }

  /// First and last cell of a range of coordinates, within the tile; false where there is none.
  bool cells_between(double low, double high, std::int64_t& first, std::int64_t& last) const {
    first = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(low)));
    last = std::min<std::int64_t>(frame_.side - 1, static_cast<std::int64_t>(std::ceil(high)) - 1);
    return first <= last;
  }

  template <class Take>
  void cut(const SmallPolygon& whole, bool is_x, Take take) const {
    const double* along = is_x ? whole.x : whole.y;
    const auto [low, high] = std::minmax_element(along, along + whole.count);
    std::int64_t first = 0, last = 0;
    if (!cells_between(*low, *high, first, last)) return;
    SmallPolygon below, rests[2];
    const SmallPolygon* polygon = &whole;
    const auto split_at = [&](double limit) {
      SmallPolygon& rest = polygon == &rests[0] ? rests[1] : rests[0];
      split(*polygon, is_x, limit, below, rest);
      polygon = &rest;
    };
    if (*low < double(first)) split_at(double(first));
    for (std::int64_t i = first; i <= last && polygon->count >= 3; ++i) {
      if (*high <= double(i + 1)) {
        take(i, *polygon);
        return;
      }
      split_at(double(i + 1));
      if (below.count >= 3) take(i, below);
    }
  }

  void cut_rows(const SmallPolygon& triangle) {
    cut(triangle, false, [&](std::int64_t row, const SmallPolygon& strip) {
      cut(strip, true, [&](std::int64_t column, const SmallPolygon& piece) { add_piece(column, row, piece); });
    });
  }

  void add_piece(std::int64_t column, std::int64_t row, const SmallPolygon& polygon) {
    const double mx = double(column) + 0.5, my = double(row) + 0.5;
    RoofPiece piece;
    piece.first_point = static_cast<std::uint32_t>(out_.points.size());
    double area = 0, x = 0, y = 0;
    const CellPoint o{polygon.x[0] - mx, polygon.y[0] - my};
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const CellPoint p{polygon.x[i] - mx, polygon.y[i] - my};
      out_.points.push_back(p);
      if (i < 2) continue;
      const CellPoint q = *(out_.points.end() - 2);
      const double twice = (q.x - o.x) * (p.y - o.y) - (q.y - o.y) * (p.x - o.x);
      area += twice / 2;
      x += twice / 6 * (o.x + q.x + p.x);
      y += twice / 6 * (o.y + q.y + p.y);
    }
    if (area < kLeastArea) {
      out_.points.resize(piece.first_point);
      return;
    }
    piece.cell = static_cast<std::uint32_t>(row * frame_.side + column);
    piece.house = house_;
    piece.points = static_cast<std::uint32_t>(polygon.count);
    piece.shown = shown_;
    piece.area = area;
    piece.x = x / area;
    piece.y = y / area;
    piece.east = (plane_->east - frame_.base.east) * cell_m_;
    piece.north = (plane_->north - frame_.base.north) * cell_m_;
    const double px = frame_.west_m() + (mx + piece.x) * cell_m_, py = frame_.south_m() + (my + piece.y) * cell_m_;
    piece.up = plane_->at(px, py) - frame_.base.at(px, py);
    out_.roofs.push_back(piece);
  }

  void cut_wall(const BakeWall& wall, std::uint32_t index) {
    const CellPoint a = cells_of(wall.ax, wall.ay), b = cells_of(wall.bx, wall.by);
    const double n = frame_.side;
    if (std::max(a.x, b.x) < 0 || std::max(a.y, b.y) < 0 || std::min(a.x, b.x) > n || std::min(a.y, b.y) > n) return;
    cuts_.assign({0, 1});
    const auto add_cuts = [&](double from, double to) {
      const double low = std::min(from, to), high = std::max(from, to);
      for (double c = std::max(0.0, std::ceil(low)); c <= std::min(n, high); ++c)
        if (c > low && c < high) cuts_.push_back((c - from) / (to - from));
    };
    add_cuts(a.x, b.x);
    add_cuts(a.y, b.y);
    std::sort(cuts_.begin(), cuts_.end());
    // Outward is to the right: a wall on a side of a cell belongs to the cell of its house.
    const double inward_x = -(b.y - a.y) * 1e-9, inward_y = (b.x - a.x) * 1e-9;
    for (std::size_t i = 1; i < cuts_.size(); ++i) {
      const double from = cuts_[i - 1], to = cuts_[i], middle = (from + to) / 2;
      if (to <= from) continue;
      const double column = std::floor(a.x + middle * (b.x - a.x) + inward_x),
                   row = std::floor(a.y + middle * (b.y - a.y) + inward_y);
      if (column < 0 || row < 0 || column >= n || row >= n) continue;
      const auto at = [&](double t) {
        return CellPoint{std::clamp(a.x + t * (b.x - a.x) - column - 0.5, -0.5, 0.5),
                         std::clamp(a.y + t * (b.y - a.y) - row - 0.5, -0.5, 0.5)};
      };
      out_.walls.push_back({static_cast<std::uint32_t>(row * n + column), house_, index, at(from), at(to), from, to});
    }
  }

  static constexpr double kLeastArea = 1e-9;  // cells: rounding leaves slivers
  const BakeScene& scene_;
  const TileFrame& frame_;
  const double cell_m_;
  CellPieces& out_;
  std::uint32_t house_ = 0;
  const UpPlane* plane_ = nullptr;
  Colour shown_;
  std::vector<double> cuts_;
};

/// Stable counting sort by cell; first[cell] is where each begins.
template <class Piece>
void sort_by_cell(std::vector<Piece>& pieces, std::size_t cells, std::vector<std::uint32_t>& first) {
  first.assign(cells + 1, 0);
  for (const Piece& p : pieces) ++first[p.cell + 1];
  for (std::size_t i = 0; i < cells; ++i) first[i + 1] += first[i];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  std::vector<Piece> sorted(pieces.size());
  for (const Piece& p : pieces) sorted[next[p.cell]++] = p;
  pieces = std::move(sorted);
}

}  // namespace

CellPieces cut_to_cells(const BakeScene& scene, const std::vector<std::uint32_t>& which, const TileFrame& frame) {
  CellPieces out;
  Cutter cutter(scene, frame, out);
  for (const std::uint32_t i : which) cutter.add_house(i);
  const std::size_t cells = std::size_t{frame.side} * frame.side;
  sort_by_cell(out.roofs, cells, out.first_roof);
  sort_by_cell(out.walls, cells, out.first_wall);
  return out;
}

}  // namespace vicus
