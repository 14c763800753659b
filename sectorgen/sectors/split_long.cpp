#include <algorithm>
#include <cmath>
#include <map>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/cells.hpp"
#include "sectorgen/sectors/corridors.hpp"
#include "sectorgen/sectors/min_cut.hpp"

namespace vicus {
namespace {

// A visitor should not load 490 m of grass at once; a garden of 200 m square stays whole.
constexpr double kLongest = 240;  // m
constexpr double kPiece = 200;    // m: pieces about this long
constexpr double kBand = 0.15;    // of the piece: how far from its place a cut may lie
constexpr double kLeastPieceM2 = 300;
constexpr std::int64_t kPerMille = 1000;
constexpr std::int64_t kAlongKerb = 300;      // per mille: a cut along a plot line or an outline is the natural one
constexpr std::int64_t kAcrossIsland = 1500;  // the island becomes an obstacle, and the ground is cut anew

/// The long side of the smallest rectangle around a convex ring.
struct Lengthwise {
  PlanPoint origin;
  double x = 1, y = 0;  // unit vector
  std::int64_t length_mm = 0, from = 0;
  std::int64_t project(PlanPoint p) const {
    return static_cast<std::int64_t>(std::llround((double(p.x) - origin.x) * x + (double(p.y) - origin.y) * y));
  }
  std::int64_t along(PlanPoint p) const { return project(p) - from; }
};

Lengthwise lengthwise(const Ring& hull) {
  Lengthwise best;
  double least = -1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const PlanPoint a = hull[i], b = hull[(i + 1) % hull.size()];
    const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::hypot(dx, dy);
    Lengthwise sides[2] = {{hull[0], dx / length, dy / length}, {hull[0], -dy / length, dx / length}};
    for (Lengthwise& s : sides) {
      if (s.x < 0 || (s.x == 0 && s.y < 0)) s.x = -s.x, s.y = -s.y;  // the same from either end
      std::int64_t low = 0, high = 0;
      for (PlanPoint p : hull) low = std::min(low, s.project(p)), high = std::max(high, s.project(p));
      s.from = low;
      s.length_mm = high - low;
    }
    const double area = double(sides[0].length_mm) * double(sides[1].length_mm);
    if (least >= 0 && area >= least) continue;
    least = area;
    best = sides[sides[0].length_mm >= sides[1].length_mm ? 0 : 1];
  }
  return best;
}

class Splitter {
 public:
  Splitter(const Ground& g, const CutOptions& options, Cells& cells)
      : g_(g), options_(options), cells_(cells), across_(edges_across_islands(g)), slot_(cells.of.size(), kNone) {}

  void run() {
    std::vector<std::vector<std::uint32_t>> members(cells_.kind.size());
    for (std::uint32_t t = 0; t < cells_.of.size(); ++t)
      if (cells_.of[t] != kNone) members[cells_.of[t]].push_back(t);
    while (!members.empty()) {
      std::vector<std::vector<std::uint32_t>> parts;
      for (auto& m : members)
        if (!m.empty()) split(m, parts);
      members = std::move(parts);
    }
  }

 private:
  /// Cuts the piece in two or more if it is too long; all parts but the one that keeps the cell get new cells.
  void split(const std::vector<std::uint32_t>& piece, std::vector<std::vector<std::uint32_t>>& parts) {
    std::vector<PlanPoint> points;
    for (std::uint32_t t : piece)
      for (int k = 0; k < 3; ++k) points.push_back(g_.mesh.points[g_.mesh.corner(t, k)]);
    const Ring hull = convex_hull(std::move(points));
    const Lengthwise axis = lengthwise(hull);
    if (metres(axis.length_mm) <= kLongest) return;
    const std::vector<char> side = sides(piece, axis);
    if (side.empty()) return;
    std::vector<std::vector<std::uint32_t>> components = connected(piece, side);
    if (components.size() < 2) return;
    // The first keeps the cell's number: the one with the smallest triangle.
    for (std::size_t i = 1; i < components.size(); ++i) {
      const auto number = static_cast<std::uint32_t>(cells_.kind.size());
      cells_.kind.push_back(cells_.kind[cells_.of[piece.front()]]);
      for (std::uint32_t t : components[i]) cells_.of[t] = number;
    }
    for (auto& c : components) parts.push_back(std::move(c));
  }

  /// `off`: per mille of the band away from the place for the cut.
  std::int64_t cost(std::uint32_t t, int k, std::int64_t off) const {
    const std::uint32_t id = g_.edge_id(t, k);
    const std::int64_t length = (length_mm(g_.from(t, k), g_.to(t, k)) + 1) * (kPerMille + off) / kPerMille;
    if (across_[id] != kNone) return options_.join_across_islands ? kNever : length * kAcrossIsland / kPerMille;
    const bool is_kerb = g_.mesh.triangles[t].edge[static_cast<std::size_t>(k)] != kNone;
    return is_kerb ? length * kAlongKerb / kPerMille + 1 : length;
  }

  /// Which side of a cut each triangle is on; empty: there is none that leaves enough on both sides.
  std::vector<char> sides(const std::vector<std::uint32_t>& piece, const Lengthwise& axis) {
    const std::int64_t n = std::max<std::int64_t>(2, axis.length_mm / lattice_mm(kPiece) + 1);
    for (std::int64_t k = n / 2; k < n; ++k)  // nearest to the middle first
      for (const std::int64_t at : {k, n - k}) {
        std::vector<char> side = sides_at(piece, axis, axis.length_mm * at / n);
        if (!side.empty()) return side;
      }
    return {};
  }

  /// The cheapest cut near the place that lies `target` mm along the axis.
  std::vector<char> sides_at(const std::vector<std::uint32_t>& piece, const Lengthwise& axis, std::int64_t target) {
    const auto band = static_cast<std::int64_t>(kBand * double(axis.length_mm));
    std::vector<std::uint32_t> low, high;
    std::vector<std::int64_t> off(piece.size());  // mm from the place for the cut
    for (std::uint32_t i = 0; i < piece.size(); ++i) {
      std::int64_t sum = 0;
      for (int k = 0; k < 3; ++k) sum += axis.along(g_.mesh.points[g_.mesh.corner(piece[i], k)]);
      const std::int64_t s = sum / 3 - target;
      off[i] = std::min(band, std::abs(s));
      if (s < -band) low.push_back(i);
      if (s > band) high.push_back(i);
    }
    const auto from = weighty(piece, low), to = weighty(piece, high);
    if (from.empty() || to.empty()) return {};
    MinCut cut(piece.size());
    for (std::uint32_t i = 0; i < piece.size(); ++i) slot_[piece[i]] = i;
    for (std::uint32_t i = 0; i < piece.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        if (!g_.is_crossable(piece[i], k)) continue;
        const std::uint32_t j = slot_[g_.beyond(piece[i], k)];
        if (j != kNone && i < j) cut.join(i, j, cost(piece[i], k, (off[i] + off[j]) * kPerMille / (2 * band)));
      }
    for (std::uint32_t t : piece) slot_[t] = kNone;
    return cut.source_side(from, to, kNever);
  }

  double area_of(std::uint32_t t) const {
    return static_cast<double>(orient(g_.from(t, 0), g_.to(t, 0), g_.to(t, 1))) / 2e6;
  }

  /// Of some of the piece's triangles (indices into it) those whose connected part is large enough for a sector.
  std::vector<std::uint32_t> weighty(const std::vector<std::uint32_t>& piece, const std::vector<std::uint32_t>& some) {
    for (std::uint32_t i : some) slot_[piece[i]] = i;
    std::vector<std::uint32_t> out;
    for (std::uint32_t seed : some) {
      if (slot_[piece[seed]] == kNone) continue;
      std::vector<std::uint32_t> part{seed};
      slot_[piece[seed]] = kNone;
      double area = 0;
      for (std::size_t i = 0; i < part.size(); ++i) {
        area += area_of(piece[part[i]]);
        for (int k = 0; k < 3; ++k) {
          if (!g_.is_crossable(piece[part[i]], k)) continue;
          std::uint32_t& slot = slot_[g_.beyond(piece[part[i]], k)];
          if (slot == kNone) continue;
          part.push_back(slot);
          slot = kNone;
        }
      }
      if (area >= kLeastPieceM2) out.insert(out.end(), part.begin(), part.end());
    }
    return out;
  }

  /// Connected parts of the two sides; parts too small for a sector go to the neighbour they share most with.
  std::vector<std::vector<std::uint32_t>> connected(const std::vector<std::uint32_t>& piece, std::vector<char> side) {
    for (std::uint32_t i = 0; i < piece.size(); ++i) slot_[piece[i]] = i;
    std::vector<std::uint32_t> part(piece.size(), kNone);
    std::vector<std::vector<std::uint32_t>> parts;
    std::vector<double> area;
    for (std::uint32_t seed = 0; seed < piece.size(); ++seed) {
      if (part[seed] != kNone) continue;
      const auto id = static_cast<std::uint32_t>(parts.size());
      parts.push_back({seed});
      area.push_back(0);
      part[seed] = id;
      for (std::size_t i = 0; i < parts[id].size(); ++i) {
        const std::uint32_t t = piece[parts[id][i]];
        area[id] += area_of(t);
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t j = g_.is_crossable(t, k) ? slot_[g_.beyond(t, k)] : kNone;
          if (j == kNone || part[j] != kNone || side[j] != side[seed]) continue;
          part[j] = id;
          parts[id].push_back(j);
        }
      }
    }
    for (std::uint32_t id = 0; id < parts.size(); ++id) {
      if (area[id] >= kLeastPieceM2) continue;
      std::map<std::uint32_t, std::int64_t> shared;
      for (std::uint32_t i : parts[id])
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t j = g_.is_crossable(piece[i], k) ? slot_[g_.beyond(piece[i], k)] : kNone;
          if (j != kNone && part[j] != id) shared[part[j]] += length_mm(g_.from(piece[i], k), g_.to(piece[i], k)) + 1;
        }
      std::uint32_t into = kNone;
      std::int64_t most = 0;
      for (const auto& [other, mm] : shared)
        if (mm > most) most = mm, into = other;
      if (into == kNone) continue;
      for (std::uint32_t i : parts[id]) part[i] = into;
      parts[into].insert(parts[into].end(), parts[id].begin(), parts[id].end());
      area[into] += area[id];
      parts[id].clear();
    }
    for (std::uint32_t t : piece) slot_[t] = kNone;
    std::vector<std::vector<std::uint32_t>> out;
    for (const auto& p : parts) {
      if (p.empty()) continue;
      out.emplace_back();
      for (std::uint32_t i : p) out.back().push_back(piece[i]);
      std::sort(out.back().begin(), out.back().end());
    }
    return out;
  }

  const Ground& g_;
  const CutOptions& options_;
  Cells& cells_;
  std::vector<std::uint32_t> across_;
  std::vector<std::uint32_t> slot_;  // per triangle: its index in the piece at hand
};

}  // namespace

void split_long_cells(const Ground& g, const CutOptions& options, Cells& cells) { Splitter(g, options, cells).run(); }

}  // namespace vicus
