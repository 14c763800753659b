#include "sectorgen/visibility/look_map.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>
#include <tuple>

#include "sectorgen/geom/triangulation.hpp"

namespace vicus {
namespace {

/// A side of a sight cell that ends looks: the cell on the left of a -> b.
struct WallSide {
  PlanPoint a, b;
  std::uint32_t value;         // as SightCell::beyond
  std::uint32_t cell;          // of the sight map
  std::uint32_t look = kNone;  // the triangle of the mesh with the same side
};

class WallSides {
 public:
  explicit WallSides(const SightMap& sight) {
    for (std::uint32_t c = 0; c < sight.cells.size(); ++c)
      for (std::size_t k = 0; k < 3; ++k)
        if (const SightCell& cell = sight.cells[c]; cell.beyond[k] >= kWall)
          sides_.push_back({cell.corner[(k + 1) % 3], cell.corner[(k + 2) % 3], cell.beyond[k], c});
    std::sort(sides_.begin(), sides_.end(),
              [](const WallSide& s, const WallSide& t) { return std::tie(s.a, s.b) < std::tie(t.a, t.b); });
  }
  /// nullptr: nothing ends there.
  WallSide* find(PlanPoint a, PlanPoint b) {
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), std::tie(a, b),
                                     [](const WallSide& s, const auto& t) { return std::tie(s.a, s.b) < t; });
    return at != sides_.end() && at->a == a && at->b == b ? &*at : nullptr;
  }
  /// At each end of a wall another one begins: rings close.
  bool has_corner(PlanPoint p) const {
    const auto at =
        std::lower_bound(sides_.begin(), sides_.end(), p, [](const WallSide& s, PlanPoint q) { return s.a < q; });
    return at != sides_.end() && at->a == p;
  }
  const std::vector<WallSide>& all() const { return sides_; }
  /// Triangles get other numbers.
  void renumber(const std::vector<std::uint32_t>& number) {
    for (auto& side : sides_)
      if (side.look != kNone) side.look = number[side.look];
  }

 private:
  std::vector<WallSide> sides_;
};

Mesh mesh_of(const SightMap& sight, const WallSides& walls) {
  std::vector<PlanPoint> points;
  std::vector<Edge> edges;
  const auto add = [&](PlanPoint a, PlanPoint b) {
    const auto at = static_cast<std::uint32_t>(points.size());
    points.push_back(a);
    points.push_back(b);
    edges.push_back({at, at + 1});
  };
  for (const WallSide& side : walls.all()) add(side.a, side.b);
  for (std::uint32_t c = 0; c < sight.cells.size(); ++c)
    for (std::size_t k = 0; k < 3; ++k) {
      const SightCell& cell = sight.cells[c];
      const std::uint32_t side = cell.beyond[k];
      if (side >= kWall || side >> 2 < c || sight.cells[side >> 2].sector == cell.sector) continue;
      const PlanPoint a = cell.corner[(k + 1) % 3], b = cell.corner[(k + 2) % 3];
      if (walls.has_corner(a) && walls.has_corner(b)) add(a, b);
    }
  return triangulate_edges(points, edges);
}

/// The triangles that looks may enter, still in the mesh's order and with its numbers beyond their sides.
std::vector<LookCell> open_triangles(const Mesh& mesh, WallSides& walls) {
  std::vector<LookCell> cells(mesh.triangles.size());
  std::vector<std::uint32_t> queue;
  std::vector<char> is_open(cells.size(), 0);
  for (std::uint32_t t = 0; t < cells.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto side = static_cast<std::size_t>(k);
      cells[t].corner[side] = mesh.points[mesh.corner(t, k)];
      const std::uint32_t n = mesh.triangles[t].neighbour[side];
      if (n != kNone) cells[t].beyond[side] = 4 * n + static_cast<std::uint32_t>(mesh.twin_side(t, k));
      if (mesh.triangles[t].edge[side] == kNone) continue;
      WallSide* wall = walls.find(mesh.points[mesh.corner(t, k + 1)], mesh.points[mesh.corner(t, k + 2)]);
      if (wall == nullptr) continue;
      cells[t].beyond[side] = wall->value;
      wall->look = t;
      if (!is_open[t]) queue.push_back(t);
      is_open[t] = 1;
    }
  while (!queue.empty()) {
    const std::uint32_t t = queue.back();
    queue.pop_back();
    for (const std::uint32_t side : cells[t].beyond)
      if (side < kWall && !is_open[side >> 2]) {
        is_open[side >> 2] = 1;
        queue.push_back(side >> 2);
      }
  }
  std::vector<std::uint32_t> number(cells.size(), kNone);
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < cells.size(); ++t)
    if (is_open[t]) number[t] = count++;
  std::vector<LookCell> open;
  open.reserve(count);
  for (std::uint32_t t = 0; t < cells.size(); ++t) {
    if (!is_open[t]) continue;
    open.push_back(cells[t]);
    for (auto& side : open.back().beyond)
      if (side < kWall) side = 4 * number[side >> 2] + (side & 3);
  }
  walls.renumber(number);
  return open;
}

/// Which open triangles lie over each cell of the sight map.
class Overlaps {
 public:
  Overlaps(const SightMap& sight, const std::vector<LookCell>& looks, const WallSides& walls)
      : sight_(sight),
        looks_(looks),
        asked_(looks.size(), kNone),
        first_(sight.cells.size(), kNone),
        behind_(sight.cells.size(), kNone) {
    for (const WallSide& wall : walls.all())
      if (first_[wall.cell] == kNone && wall.look != kNone) grow(wall.cell, wall.look);
    while (!queue_.empty()) {
      const std::uint32_t c = queue_.back();
      queue_.pop_back();
      for (const std::uint32_t side : sight_.cells[c].beyond)
        if (side < kWall && first_[side >> 2] == kNone) grow(side >> 2, next_to(c, side >> 2));
    }
  }
  std::uint32_t first(std::uint32_t cell) const { return first_[cell]; }
  std::uint32_t behind(std::uint32_t cell) const { return behind_[cell]; }
  std::uint32_t operator[](std::uint32_t i) const { return found_[i]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(found_.size()); }

 private:
  bool lies_over(std::uint32_t look, std::uint32_t cell) const {
    return overlap(looks_[look].corner, sight_.cells[cell].corner);
  }
  /// Those over a triangle hang together: from one over their sides to all.
  void grow(std::uint32_t cell, std::uint32_t look) {
    assert(look != kNone);
    first_[cell] = static_cast<std::uint32_t>(found_.size());
    found_.push_back(look);
    asked_[look] = cell;
    for (std::uint32_t i = first_[cell]; i < found_.size(); ++i)
      for (const std::uint32_t side : looks_[found_[i]].beyond) {
        if (side >= kWall || asked_[side >> 2] == cell) continue;
        asked_[side >> 2] = cell;
        if (lies_over(side >> 2, cell)) found_.push_back(side >> 2);
      }
    behind_[cell] = static_cast<std::uint32_t>(found_.size());
    queue_.push_back(cell);
  }
  /// One over `cell`: over its known neighbour, too, or beyond a side of one that is.
  std::uint32_t next_to(std::uint32_t known, std::uint32_t cell) const {
    for (std::uint32_t i = first_[known]; i < behind_[known]; ++i) {
      if (lies_over(found_[i], cell)) return found_[i];
      for (const std::uint32_t side : looks_[found_[i]].beyond)
        if (side < kWall && lies_over(side >> 2, cell)) return side >> 2;
    }
    return kNone;  // not with a noded map
  }

  const SightMap& sight_;
  const std::vector<LookCell>& looks_;
  std::vector<std::uint32_t> asked_;  // per look: for which cell
  std::vector<std::uint32_t> first_, behind_, found_, queue_;
};

std::vector<std::vector<std::uint32_t>> own_groups_of(const SightMap& sight) {
  std::vector<std::vector<std::uint32_t>> groups(sight.sector_count());
  for (const SightCell& cell : sight.cells) {
    if (cell.sector == kNowhere) continue;
    auto& own = groups[cell.sector];
    if (cell.group != 0) own.push_back(cell.group);
    for (const std::uint32_t side : cell.beyond)
      if (side >= kWall && side != kNowhere) own.push_back(side - kWall);
  }
  for (auto& own : groups) {
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
  }
  return groups;
}

std::vector<std::uint8_t> loose_corners_of(const SightMap& sight, const WallSides& walls) {
  std::vector<std::uint8_t> loose;
  for (const SightCell& cell : sight.cells) {
    unsigned corners = 0;
    for (std::size_t k = 0; k < 3; ++k) corners |= (walls.has_corner(cell.corner[k]) ? 0u : 1u) << k;
    loose.push_back(static_cast<std::uint8_t>(corners));
  }
  return loose;
}

std::vector<char> loose_sectors(const SightMap& sight, const LookMap& map) {
  std::vector<char> is_loose(sight.sector_count(), 0);
  for (std::uint32_t c = 0; c < sight.begin.back(); ++c)
    for (std::size_t k = 0; k < 3; ++k) {
      const SightCell& cell = sight.cells[c];
      const std::uint32_t side = cell.beyond[k];
      if (side >= kWall || sight.cells[side >> 2].sector == cell.sector) continue;
      if (map.is_loose_corner(c, (k + 1) % 3) || map.is_loose_corner(c, (k + 2) % 3)) is_loose[cell.sector] = 1;
    }
  return is_loose;
}

/// Per triangle of the looks, the cells of the sight map below it.
struct Below {
  std::vector<std::uint32_t> begin, cells;
};

Below below_of(const SightMap& sight, std::size_t looks, const Overlaps& overlaps) {
  Below below;
  below.begin.assign(looks + 1, 0);
  for (std::uint32_t i = 0; i < overlaps.size(); ++i) ++below.begin[overlaps[i] + 1];
  std::partial_sum(below.begin.begin(), below.begin.end(), below.begin.begin());
  below.cells.resize(overlaps.size());
  std::vector<std::uint32_t> next(below.begin.begin(), below.begin.end() - 1);
  for (std::uint32_t c = 0; c < sight.cells.size(); ++c)
    for (std::uint32_t i = overlaps.first(c); i < overlaps.behind(c); ++i) below.cells[next[overlaps[i]]++] = c;
  return below;
}

/// Says what lies below a look's cell by one sector, where that is all, and by pieces.
void describe(LookCell& look, std::span<const std::uint32_t> below, const SightMap& sight,
              std::vector<GroundPiece>& pieces) {
  assert(!below.empty());
  const std::uint32_t sector = sight.cells[below.front()].sector;
  const bool is_one =
      std::all_of(below.begin(), below.end(), [&](std::uint32_t c) { return sight.cells[c].sector == sector; });
  look.sector = is_one ? sector : kNowhere;
  look.first_piece = static_cast<std::uint32_t>(pieces.size());
  for (const std::uint32_t c : below)
    if (const SightCell& cell = sight.cells[c]; cell.group != 0 || (!is_one && cell.sector != kNowhere))
      pieces.push_back({cell.corner, cell.sector, cell.group});
  look.pieces_behind = static_cast<std::uint32_t>(pieces.size());
}

}  // namespace

LookMap make_look_map(const SightMap& sight) {
  LookMap map;
  map.begin.assign(sight.sector_count() + 1, 0);
  if (sight.cells.empty()) return map;
  WallSides walls(sight);
  std::vector<LookCell> looks = open_triangles(mesh_of(sight, walls), walls);
  const Overlaps overlaps(sight, looks, walls);
  const Below below = below_of(sight, looks.size(), overlaps);
  for (std::uint32_t l = 0; l < looks.size(); ++l)
    describe(looks[l], std::span(below.cells).subspan(below.begin[l], below.begin[l + 1] - below.begin[l]), sight,
             map.pieces);

  std::vector<std::uint32_t> order(looks.size()), number(looks.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return looks[a].sector < looks[b].sector; });
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  map.cells.reserve(looks.size());
  for (const std::uint32_t l : order) {
    map.cells.push_back(looks[l]);
    for (auto& side : map.cells.back().beyond)
      if (side < kWall) side = 4 * number[side >> 2] + (side & 3);
    if (looks[l].sector != kNowhere) ++map.begin[looks[l].sector + 1];
  }
  std::partial_sum(map.begin.begin(), map.begin.end(), map.begin.begin());
  for (std::uint32_t c = 0; c < sight.cells.size(); ++c) {
    map.first_of.push_back(static_cast<std::uint32_t>(map.cells_of.size()));
    for (std::uint32_t i = overlaps.first(c); i < overlaps.behind(c); ++i) map.cells_of.push_back(number[overlaps[i]]);
  }
  map.first_of.push_back(static_cast<std::uint32_t>(map.cells_of.size()));
  map.own_groups = own_groups_of(sight);
  map.loose_corners = loose_corners_of(sight, walls);
  map.is_loose = loose_sectors(sight, map);
  return map;
}

}  // namespace vicus
