#include <algorithm>
#include <map>
#include <set>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/cells.hpp"

namespace vicus {
namespace {

// Thresholds of research/SECTORS.md §4.8, set by eye there.
constexpr double kOwnCrossroadsM2 = 900, kOwnCrossroadsSpan = 55;  // m2, m
constexpr double kLengthAim = 162;                                 // m
constexpr double kYardFront = 0.4;                                 // of the smaller yard's span
constexpr double kStripWidth = 6, kStripFront = 0.5;               // m; of the strip's span
constexpr double kSliverM2 = 80, kSliverSpan = 12;
constexpr double kJoinSpan = 120, kJoinConvexity = 0.8;  // pieces of one street

struct Border {
  std::int64_t mm = 0;       // all edges between the two cells
  std::int64_t used_mm = 0;  // those a street crosses
};

struct Cell {
  CellKind kind = CellKind::street;
  double area = 0;
  Ring hull;
  std::map<std::uint32_t, std::int64_t> names;
  std::map<std::uint32_t, Border> to;
  bool alive = true;

  double span() const { return diameter_m(hull); }
  double convexity() const { return area / hull_area(hull); }
  static double hull_area(const Ring& h) { return std::max(1e-6, static_cast<double>(area2(h)) / 2e6); }
  std::uint32_t main_name() const {
    std::uint32_t best = kNone;
    std::int64_t most = 0;
    for (const auto& [name, mm] : names)
      if (mm > most) best = name, most = mm;
    return best;
  }
};

class Merger {
 public:
  Merger(const Ground& g, const StreetRoutes& r, Cells& cells)
      : cells_(cells), cell_(cells.kind.size()), root_(cells.kind.size()) {
    std::vector<std::vector<PlanPoint>> points(cell_.size());
    for (std::uint32_t c = 0; c < cell_.size(); ++c) {
      cell_[c].kind = cells.kind[c];
      root_[c] = c;
    }
    for (std::uint32_t t = 0; t < cells.of.size(); ++t) {
      const std::uint32_t c = cells.of[t];
      if (c == kNone) continue;
      const auto& corner = g.mesh.triangles[t].corner;
      cell_[c].area +=
          static_cast<double>(orient(g.mesh.points[corner[0]], g.mesh.points[corner[1]], g.mesh.points[corner[2]])) /
          2e6;
      for (std::uint32_t p : corner) points[c].push_back(g.mesh.points[p]);
      for (int k = 0; k < 3; ++k) {
        if (!g.is_crossable(t, k)) continue;
        const std::uint32_t d = cells.of[g.beyond(t, k)];
        if (d == kNone || d == c) continue;
        const std::int64_t length = length_mm(g.from(t, k), g.to(t, k));
        Border& b = cell_[c].to[d];
        b.mm += length;
        if (r.is_used[g.edge_id(t, k)]) b.used_mm += length;
      }
    }
    for (const auto& use : r.uses)
      if (cells.of[use.triangle] != kNone) cell_[cells.of[use.triangle]].names[use.name] += use.mm;
    for (std::uint32_t c = 0; c < cell_.size(); ++c) {
      cell_[c].hull = convex_hull(std::move(points[c]));
      if (cell_[c].area <= 0) cell_[c].alive = false;
    }
  }

  void absorb_crossroads() {
    for_smallest([&](std::uint32_t c) {
      const Cell& j = cell_[c];
      if (j.kind != CellKind::junction) return kNone;
      const bool own = (j.area >= kOwnCrossroadsM2 || j.span() >= kOwnCrossroadsSpan) && used_neighbours(c) > 2;
      return own ? kNone : best_street_for(c);
    });
  }

  /// Wedges at the corners of a square, whose mouth is as wide as they are long.
  void open_wedges() {
    for_smallest([&](std::uint32_t c) {
      const Cell& b = cell_[c];
      if (b.kind == CellKind::yard) return kNone;
      std::uint32_t best = kNone;
      double best_convexity = 0;
      const double span = b.span();
      for (const auto& [d, border] : b.to) {
        const Cell& a = cell_[d];
        if (border.used_mm == 0 || a.area < b.area || a.kind == CellKind::yard) continue;
        if (metres(border.used_mm) <= 0.65 * span) continue;
        const Ring hull = joint_hull(a, b);
        const double joint = (a.area + b.area) / Cell::hull_area(hull);
        if (joint < 0.78 || joint < a.convexity() - 0.12) continue;
        if (diameter_m(hull) > std::max(kLengthAim, 1.15 * a.span())) continue;
        if (joint > best_convexity) best = d, best_convexity = joint;
      }
      return best;
    });
  }

  /// A person joins short pieces of one street (research/SECTORS.md §8.3).
  void join_pieces() {
    for_smallest([&](std::uint32_t c) {
      const Cell& b = cell_[c];
      if (b.kind != CellKind::street) return kNone;
      std::uint32_t best = kNone;
      double best_convexity = kJoinConvexity;
      for (const auto& [d, border] : b.to) {
        const Cell& a = cell_[d];
        if (border.used_mm == 0 || a.kind != CellKind::street || a.main_name() != b.main_name()) continue;
        const Ring hull = joint_hull(a, b);
        if (diameter_m(hull) > kJoinSpan) continue;
        const double joint = (a.area + b.area) / Cell::hull_area(hull);
        if (joint > best_convexity) best = d, best_convexity = joint;
      }
      return best;
    });
  }

  /// A strip of front gardens before a row of houses is part of its street, fence or not.
  void absorb_strips() {
    for_smallest([&](std::uint32_t c) {
      const Cell& b = cell_[c];
      if (b.kind != CellKind::yard || b.area >= kStripWidth * b.span()) return kNone;
      std::uint32_t best = kNone;
      double widest = kStripFront * b.span();
      for (const auto& [d, border] : b.to) {
        if (cell_[d].kind == CellKind::yard || metres(border.mm) <= widest) continue;
        best = d;
        widest = metres(border.mm);
      }
      return best;
    });
  }

  /// Yards that meet along a wide front are one yard.
  void join_yards() {
    for_smallest([&](std::uint32_t c) {
      const Cell& b = cell_[c];
      if (b.kind != CellKind::yard) return kNone;
      std::uint32_t best = kNone;
      double widest = kYardFront * b.span();
      for (const auto& [d, border] : b.to) {
        if (cell_[d].kind != CellKind::yard || metres(border.mm) <= widest) continue;
        best = d;
        widest = metres(border.mm);
      }
      return best;
    });
  }

  void absorb_slivers() {
    for_smallest([&](std::uint32_t c) {
      const Cell& b = cell_[c];
      if (b.area >= kSliverM2 && b.span() >= kSliverSpan) return kNone;
      std::uint32_t best = kNone;
      double best_score = 0;
      std::int64_t all = 0;
      for (const auto& [d, border] : b.to) all += border.mm;
      for (const auto& [d, border] : b.to) {
        const double score = (cell_[d].area + b.area) / Cell::hull_area(joint_hull(cell_[d], b)) +
                             0.5 * static_cast<double>(border.mm) / static_cast<double>(std::max<std::int64_t>(1, all));
        if (score > best_score) best = d, best_score = score;
      }
      return best;
    });
  }

  void write_back() {
    std::vector<std::uint32_t> number(cell_.size(), kNone);
    std::vector<CellKind> kind;
    for (auto& c : cells_.of) {
      if (c == kNone) continue;
      const std::uint32_t root = find(c);
      if (number[root] == kNone) {
        number[root] = static_cast<std::uint32_t>(kind.size());
        kind.push_back(cell_[root].kind);
      }
      c = number[root];
    }
    cells_.kind = std::move(kind);
  }

 private:
  std::uint32_t find(std::uint32_t c) const {
    while (root_[c] != c) c = root_[c];
    return c;
  }

  static Ring joint_hull(const Cell& a, const Cell& b) {
    std::vector<PlanPoint> points = a.hull;
    points.insert(points.end(), b.hull.begin(), b.hull.end());
    return convex_hull(std::move(points));
  }

  int used_neighbours(std::uint32_t c) const {
    int n = 0;
    for (const auto& [d, border] : cell_[c].to) n += border.used_mm > 0;
    return n;
  }

  std::uint32_t best_street_for(std::uint32_t c) const {
    const Cell& j = cell_[c];
    std::int64_t mouths = 0;
    for (const auto& [d, border] : j.to) mouths += border.used_mm;
    std::uint32_t best = kNone;
    double best_score = -1e9;
    const std::uint32_t name = j.main_name();
    for (const auto& [d, border] : j.to) {
      if (border.used_mm == 0 || cell_[d].kind == CellKind::yard) continue;
      const Ring hull = joint_hull(j, cell_[d]);
      double score = (j.area + cell_[d].area) / Cell::hull_area(hull);
      if (name != kNone && name == cell_[d].main_name()) score += 0.10;
      score += 0.15 * static_cast<double>(border.used_mm) / static_cast<double>(std::max<std::int64_t>(1, mouths));
      if (cell_[d].kind != CellKind::street) score -= 0.2;
      const double too_long = diameter_m(hull) - kLengthAim;
      if (too_long > 0) score -= 0.1 + too_long / 200;
      if (score > best_score) best = d, best_score = score;
    }
    return best;
  }

  void merge(std::uint32_t c, std::uint32_t into) {
    Cell &b = cell_[c], &a = cell_[into];
    a.hull = joint_hull(a, b);
    a.area += b.area;
    for (const auto& [name, mm] : b.names) a.names[name] += mm;
    a.to.erase(c);
    for (const auto& [d, border] : b.to) {
      if (d == into) continue;
      Border& mine = a.to[d];
      mine.mm += border.mm;
      mine.used_mm += border.used_mm;
      cell_[d].to.erase(c);
      Border& theirs = cell_[d].to[into];
      theirs.mm += border.mm;
      theirs.used_mm += border.used_mm;
    }
    b.alive = false;
    b.to.clear();
    root_[c] = into;
  }

  /// Visits the cells from small to large; the choice names the cell to merge into, or kNone. Merged cells queue again.
  template <class Choose>
  void for_smallest(Choose choose) {
    using Key = std::tuple<double, PlanPoint, std::uint32_t>;
    const auto key = [&](std::uint32_t c) { return Key{cell_[c].area, cell_[c].hull.front(), c}; };
    std::set<Key> queue;
    for (std::uint32_t c = 0; c < cell_.size(); ++c)
      if (cell_[c].alive) queue.insert(key(c));
    while (!queue.empty()) {
      const std::uint32_t c = std::get<2>(*queue.begin());
      queue.erase(queue.begin());
      if (!cell_[c].alive) continue;
      const std::uint32_t into = choose(c);
      if (into == kNone) continue;
      queue.erase(key(into));
      merge(c, into);
      queue.insert(key(into));
    }
  }

  Cells& cells_;
  std::vector<Cell> cell_;
  std::vector<std::uint32_t> root_;
};

}  // namespace

void merge_cells(const Ground& g, const StreetRoutes& r, Cells& cells) {
  Merger merger(g, r, cells);
  merger.absorb_crossroads();
  merger.open_wedges();
  merger.absorb_strips();
  merger.join_yards();
  merger.absorb_slivers();
  merger.join_pieces();
  merger.write_back();
}

}  // namespace vicus
