#include "sectorgen/visibility/rim_map.hpp"

#include <algorithm>
#include <compare>
#include <tuple>

#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/geom/triangulation.hpp"

namespace vicus {
namespace {

struct Segment {
  PlanPoint a, b;
  auto operator<=>(const Segment&) const = default;
};

Segment side_of(const Corners& corner, std::size_t k) { return {corner[(k + 1) % 3], corner[(k + 2) % 3]}; }

/// Have they a point in common?   Source  separating axes: the triangle's sides, the segment's line.
bool meet(const Segment& segment, const Corners& cell) {
  const auto [a, b] = segment;
  for (std::size_t k = 0; k < 3; ++k)
    if (orient(cell[k], cell[(k + 1) % 3], a) < 0 && orient(cell[k], cell[(k + 1) % 3], b) < 0) return false;
  const auto is_left = [&](PlanPoint p) { return orient(a, b, p) > 0; };
  const auto is_right = [&](PlanPoint p) { return orient(a, b, p) < 0; };
  return !std::all_of(cell.begin(), cell.end(), is_left) && !std::all_of(cell.begin(), cell.end(), is_right);
}

/// A side of a cell that is cut, towards one that is not: what is beyond it.
struct CutSide {
  PlanPoint a, b;
  std::uint32_t beyond;
};

class CutOutline {
 public:
  void add(Segment side, std::uint32_t beyond) { sides_.push_back({side.a, side.b, beyond}); }
  void finish() {
    std::sort(sides_.begin(), sides_.end(),
              [](const CutSide& s, const CutSide& t) { return std::tie(s.a, s.b) < std::tie(t.a, t.b); });
  }
  /// nullptr: none.
  const CutSide* find(PlanPoint a, PlanPoint b) const {
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), std::tie(a, b),
                                     [](const CutSide& s, const auto& t) { return std::tie(s.a, s.b) < t; });
    return at != sides_.end() && at->a == a && at->b == b ? &*at : nullptr;
  }

 private:
  std::vector<CutSide> sides_;
};

/// Triangles within the outline.
std::vector<char> inside(const Mesh& mesh, const CutOutline& outline) {
  const auto covers = flood_from_hull(mesh, 0, [&](int cover, std::uint32_t t, int k) {
    if (mesh.triangles[t].edge[static_cast<std::size_t>(k)] == kNone) return cover;
    const PlanPoint a = mesh.points[mesh.corner(t, k + 1)], b = mesh.points[mesh.corner(t, k + 2)];
    return cover + (outline.find(a, b) != nullptr) - (outline.find(b, a) != nullptr);
  });
  std::vector<char> is_inside;
  for (const int cover : covers) is_inside.push_back(cover > 0);
  return is_inside;
}

}  // namespace

/// The cells that the rim cuts, and the rim.
struct RimMap::Cut {
  std::vector<Segment> sides;        // of the rim, the sector on the left: with a loose end
  std::vector<Segment> tight_sides;  // from wall to wall, sorted
  std::vector<PlanPoint> loose;      // corners of the rim that stand at no wall
  std::vector<std::uint32_t> cells;  // sorted
};

RimMap::RimMap(const SightMap& sight, const LookMap& looks)
    : sight_(sight), looks_(looks), cells_(looks.cells), pieces_(looks.pieces), is_cut_(looks.cells.size(), 0) {}

void RimMap::put_back() {
  for (const Undo& undo : undo_) cells_[undo.side >> 2].beyond[undo.side & 3] = undo.beyond;
  undo_.clear();
  cells_.resize(looks_.cells.size());
  pieces_.resize(looks_.pieces.size());
  own_.clear();
}

void RimMap::turn_to(std::uint32_t sector) {
  put_back();
  Cut cut;
  if (looks_.is_loose[sector]) find_cut(cut, sector);
  for (std::uint32_t c = looks_.begin[sector]; c < looks_.begin[sector + 1]; ++c)
    if (!std::binary_search(cut.cells.begin(), cut.cells.end(), c)) own_.push_back(c);
  if (!cut.cells.empty()) triangulate(cut, sector);
}

void RimMap::find_cut(Cut& cut, std::uint32_t sector) {
  const auto add = [&](std::uint32_t cell) {
    if (is_cut_[cell]) return;
    is_cut_[cell] = 1;
    cut.cells.push_back(cell);
  };
  for (std::uint32_t c = sight_.begin[sector]; c < sight_.begin[sector + 1]; ++c)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beyond = sight_.cells[c].beyond[k];
      if (beyond >= kWall || sight_.cells[beyond >> 2].sector == sector) continue;
      const Segment side = side_of(sight_.cells[c].corner, k);
      const bool is_a_loose = looks_.is_loose_corner(c, (k + 1) % 3),
                 is_b_loose = looks_.is_loose_corner(c, (k + 2) % 3);
      if (is_a_loose) cut.loose.push_back(side.a);
      if (!is_a_loose && !is_b_loose) {
        cut.tight_sides.push_back(side);
        continue;
      }
      cut.sides.push_back(side);
      for (const std::uint32_t ground : {c, beyond >> 2})
        for (std::uint32_t i = looks_.first_of[ground]; i < looks_.first_of[ground + 1]; ++i)
          if (meet(side, looks_.cells[looks_.cells_of[i]].corner)) add(looks_.cells_of[i]);
    }
  // No corner of the rim may lie within a side towards a cell that stays.
  for (std::size_t i = 0; i < cut.cells.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const LookCell& cell = looks_.cells[cut.cells[i]];
      if (cell.beyond[k] >= kWall || is_cut_[cell.beyond[k] >> 2]) continue;
      const Segment side = side_of(cell.corner, k);
      if (std::any_of(cut.loose.begin(), cut.loose.end(), [&](PlanPoint p) { return on_segment(side.a, side.b, p); }))
        add(cell.beyond[k] >> 2);
    }
  for (const std::uint32_t cell : cut.cells) is_cut_[cell] = 0;
  std::sort(cut.cells.begin(), cut.cells.end());
  std::sort(cut.tight_sides.begin(), cut.tight_sides.end());
}

void RimMap::triangulate(const Cut& cut, std::uint32_t sector) {
  std::vector<PlanPoint> points;
  std::vector<Edge> edges;
  const auto add_edge = [&](Segment side) {
    const auto at = static_cast<std::uint32_t>(points.size());
    points.push_back(side.a);
    points.push_back(side.b);
    edges.push_back({at, at + 1});
  };
  CutOutline outline;
  std::vector<GroundPiece> below;
  for (const std::uint32_t c : cut.cells) {
    const LookCell& cell = looks_.cells[c];
    for (std::size_t k = 0; k < 3; ++k) {
      const Segment side = side_of(cell.corner, k);
      if (cell.beyond[k] >= kWall || !std::binary_search(cut.cells.begin(), cut.cells.end(), cell.beyond[k] >> 2)) {
        outline.add(side, cell.beyond[k]);
        add_edge(side);
      } else if (std::binary_search(cut.tight_sides.begin(), cut.tight_sides.end(), side)) {
        add_edge(side);
      }
    }
    if (cell.sector != kNowhere) below.push_back({cell.corner, cell.sector, 0});
    below.insert(below.end(), looks_.pieces.begin() + cell.first_piece, looks_.pieces.begin() + cell.pieces_behind);
  }
  for (const Segment& side : cut.sides) add_edge(side);
  outline.finish();

  const Mesh mesh = triangulate_edges(points, edges);
  const std::vector<char> is_inside = inside(mesh, outline);
  std::vector<std::uint32_t> number(mesh.triangles.size(), kNowhere);
  for (std::uint32_t t = 0, n = static_cast<std::uint32_t>(cells_.size()); t < number.size(); ++t)
    if (is_inside[t]) number[t] = n++;
  for (std::uint32_t t = 0; t < number.size(); ++t) {
    if (!is_inside[t]) continue;
    LookCell cell;
    for (int k = 0; k < 3; ++k) {
      const auto side = static_cast<std::size_t>(k);
      const PlanPoint a = mesh.points[mesh.corner(t, k + 1)], b = mesh.points[mesh.corner(t, k + 2)];
      cell.corner[side] = mesh.points[mesh.corner(t, k)];
      if (const CutSide* border = outline.find(a, b); border != nullptr) {
        cell.beyond[side] = border->beyond;
        if (border->beyond < kWall) link(border->beyond, 4 * number[t] + static_cast<std::uint32_t>(k));
      } else {
        cell.beyond[side] =
            4 * number[mesh.triangles[t].neighbour[side]] + static_cast<std::uint32_t>(mesh.twin_side(t, k));
      }
    }
    describe(cell, below, sector);
    if (cell.sector == sector) own_.push_back(number[t]);
    cells_.push_back(cell);
  }
}

void RimMap::link(std::uint32_t side, std::uint32_t to) {
  std::uint32_t& beyond = cells_[side >> 2].beyond[side & 3];
  undo_.push_back({side, beyond});
  beyond = to;
}

/// The rim is made of sides: one piece of the sector tells that all of the cell is in it.
void RimMap::describe(LookCell& cell, const std::vector<GroundPiece>& below, std::uint32_t sector) {
  cell.first_piece = static_cast<std::uint32_t>(pieces_.size());
  for (const GroundPiece& piece : below) {
    if (!overlap(piece.corner, cell.corner)) continue;
    pieces_.push_back(piece);
    if (piece.sector == sector) cell.sector = sector;
  }
  cell.pieces_behind = static_cast<std::uint32_t>(pieces_.size());
}

}  // namespace vicus
