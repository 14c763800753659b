#include "sectorgen/geom/noding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "city_db/issues.hpp"
#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

/// One distinct undirected piece (a < b) and the point list it was cut from.
struct Piece {
  PlanPoint a, b;
  bool is_new;
};

struct CellEntry {
  std::uint64_t cell;
  std::uint32_t piece;
  bool operator<(const CellEntry& o) const { return cell != o.cell ? cell < o.cell : piece < o.piece; }
};

struct Split {
  std::uint32_t piece;
  PlanPoint at;
};

std::int32_t cell_of(std::int32_t v) {
  return v >= 0 ? v / kNodingCellMm : -((-v + kNodingCellMm - 1) / kNodingCellMm);
}
std::uint64_t cell_key(std::int32_t cx, std::int32_t cy) {
  return (std::uint64_t{static_cast<std::uint32_t>(cx) ^ 0x80000000u} << 32) |
         (static_cast<std::uint32_t>(cy) ^ 0x80000000u);
}

/// Every cell the piece, widened by 1 mm, may touch: column by column, so that long slanted ones stay cheap.
template <class Visit>
void visit_cells(const Piece& p, Visit visit) {
  const std::int32_t x0 = cell_of(p.a.x - 1), x1 = cell_of(p.b.x + 1);  // a < b, so a.x <= b.x
  const double dx = static_cast<double>(p.b.x) - p.a.x, dy = static_cast<double>(p.b.y) - p.a.y;
  for (std::int32_t cx = x0; cx <= x1; ++cx) {
    double ya = p.a.y, yb = p.b.y;
    if (x1 > x0 && dx > 0) {
      const double left = std::max<double>(static_cast<double>(cx) * kNodingCellMm - 2, p.a.x);
      const double right = std::min<double>((static_cast<double>(cx) + 1) * kNodingCellMm + 2, p.b.x);
      ya = p.a.y + dy * (left - p.a.x) / dx;
      yb = p.a.y + dy * (right - p.a.x) / dx;
    }
    const auto low = static_cast<std::int32_t>(std::floor(std::min(ya, yb))) - 2;
    const auto high = static_cast<std::int32_t>(std::ceil(std::max(ya, yb))) + 2;
    for (std::int32_t cy = cell_of(low); cy <= cell_of(high); ++cy) visit(cell_key(cx, cy));
  }
}

/// Nearest lattice point to the crossing of ab and cd.   Needs  they cross properly.
PlanPoint crossing(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d) {
  const Int128 numerator = orient(c, d, a);
  const Int128 denominator = numerator - orient(c, d, b);
  const auto along = [&](std::int32_t from, std::int32_t to) {
    Int128 n = numerator * (std::int64_t{to} - from), m = denominator;
    if (m < 0) n = -n, m = -m;
    const Int128 twice = 2 * n + m;  // rounded to nearest, halves up
    Int128 q = twice / (2 * m);
    if (twice % (2 * m) < 0) --q;
    return static_cast<std::int32_t>(from + static_cast<std::int64_t>(q));
  };
  return {along(a.x, b.x), along(a.y, b.y)};
}

/// p is no end of ab and closer than kSnapMm to its inside.
bool passes(const Piece& s, PlanPoint p) {
  if (p == s.a || p == s.b) return false;
  if (dot(s.a, s.b, p) <= 0 || dot(s.b, s.a, p) <= 0) return false;
  const auto area = static_cast<double>(orient(s.a, s.b, p));
  // area / length is the distance; exact enough: both sides carry 53 bits and the limit is not critical.
  return area * area < kSnapMm * kSnapMm * static_cast<double>(distance2(s.a, s.b));
}

void test_pair(const std::vector<Piece>& pieces, std::uint32_t i, std::uint32_t j, std::vector<Split>& splits) {
  const Piece &s = pieces[i], &t = pieces[j];
  if (!s.is_new && !t.is_new) return;
  if (s.b.x + 1 < t.a.x || t.b.x + 1 < s.a.x) return;
  if (std::max(s.a.y, s.b.y) + 1 < std::min(t.a.y, t.b.y) || std::max(t.a.y, t.b.y) + 1 < std::min(s.a.y, s.b.y))
    return;
  bool touched = false;
  const auto pass = [&](std::uint32_t k, const Piece& piece, PlanPoint p) {
    if (!passes(piece, p)) return;
    splits.push_back({k, p});
    touched = true;
  };
  pass(i, s, t.a);
  pass(i, s, t.b);
  pass(j, t, s.a);
  pass(j, t, s.b);
  if (touched || !cross_properly(s.a, s.b, t.a, t.b)) return;
  const PlanPoint x = crossing(s.a, s.b, t.a, t.b);
  splits.push_back({i, x});
  splits.push_back({j, x});
}

std::vector<Split> find_splits(const std::vector<Piece>& pieces) {
  std::vector<CellEntry> entries;
  entries.reserve(pieces.size() * 2);
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    visit_cells(pieces[i], [&](std::uint64_t cell) { entries.push_back({cell, i}); });
  std::sort(entries.begin(), entries.end());
  std::vector<Split> splits;
  for (std::size_t begin = 0; begin < entries.size();) {
    std::size_t end = begin;
    bool any_new = false;
    for (; end < entries.size() && entries[end].cell == entries[begin].cell; ++end)
      any_new = any_new || pieces[entries[end].piece].is_new;
    if (any_new)
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t j = i + 1; j < end; ++j) test_pair(pieces, entries[i].piece, entries[j].piece, splits);
    begin = end;
  }
  const auto key = [&](const Split& s) { return std::make_pair(s.piece, s.at); };
  std::sort(splits.begin(), splits.end(), [&](const Split& a, const Split& b) { return key(a) < key(b); });
  splits.erase(
      std::unique(splits.begin(), splits.end(), [&](const Split& a, const Split& b) { return key(a) == key(b); }),
      splits.end());
  return splits;
}

/// Cuts pieces at their splits; also tells where each old piece went, as point lists a .. b.
struct Refined {
  std::vector<std::vector<PlanPoint>> chains;  // per split piece
  std::vector<std::uint32_t> chain_of;         // per piece, kNoChain: unchanged
};
constexpr std::uint32_t kNoChain = 0xFFFFFFFFu;

Refined refine(const std::vector<Piece>& pieces, const std::vector<Split>& splits) {
  Refined out;
  out.chain_of.assign(pieces.size(), kNoChain);
  for (std::size_t begin = 0; begin < splits.size();) {
    const std::uint32_t i = splits[begin].piece;
    const Piece& piece = pieces[i];
    std::vector<PlanPoint> chain{piece.a};
    std::size_t end = begin;
    for (; end < splits.size() && splits[end].piece == i; ++end) chain.push_back(splits[end].at);
    chain.push_back(piece.b);
    std::sort(chain.begin() + 1, chain.end() - 1, [&](PlanPoint p, PlanPoint q) {
      const std::int64_t dp = dot(piece.a, piece.b, p), dq = dot(piece.a, piece.b, q);
      return dp != dq ? dp < dq : p < q;
    });
    chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
    out.chain_of[i] = static_cast<std::uint32_t>(out.chains.size());
    out.chains.push_back(std::move(chain));
    begin = end;
  }
  return out;
}

bool less_piece(const Piece& p, const Piece& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; }

std::size_t find_piece(const std::vector<Piece>& pieces, PlanPoint a, PlanPoint b) {
  const Piece wanted{std::min(a, b), std::max(a, b), false};
  return static_cast<std::size_t>(std::lower_bound(pieces.begin(), pieces.end(), wanted, less_piece) - pieces.begin());
}

void add_piece(std::vector<Piece>& pieces, PlanPoint a, PlanPoint b, bool is_new) {
  if (a != b) pieces.push_back({std::min(a, b), std::max(a, b), is_new});
}

/// Sorted and unique; a piece that exists already as an old one is not new.
void make_distinct(std::vector<Piece>& pieces) {
  std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
    return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.is_new < q.is_new;
  });
  pieces.erase(std::unique(pieces.begin(), pieces.end(),
                           [](const Piece& p, const Piece& q) { return p.a == q.a && p.b == q.b; }),
               pieces.end());
}

}  // namespace

Noded node_segments(const std::vector<Segment>& segments) {
  constexpr int kMaxRounds = 50;
  std::vector<Piece> pieces;
  pieces.reserve(segments.size());
  for (const Segment& s : segments) add_piece(pieces, s.a, s.b, true);
  make_distinct(pieces);
  // chains[i]: the points of the input's i-th distinct piece that was ever cut.
  const std::vector<Piece> original = pieces;
  std::vector<std::uint32_t> chain_of(original.size(), kNoChain);
  std::vector<std::vector<PlanPoint>> chains;

  Noded noded;
  for (;; ++noded.rounds) {
    const std::vector<Split> splits = find_splits(pieces);
    if (splits.empty()) break;
    if (noded.rounds == kMaxRounds) throw CityError("noding: no rest after 50 rounds; please report the input");
    const Refined refined = refine(pieces, splits);
    for (std::size_t i = 0; i < original.size(); ++i) {  // carry the cuts over to the input's pieces
      if (chain_of[i] == kNoChain) {
        const std::size_t k = find_piece(pieces, original[i].a, original[i].b);
        if (refined.chain_of[k] == kNoChain) continue;
        chain_of[i] = static_cast<std::uint32_t>(chains.size());
        chains.push_back({original[i].a, original[i].b});
      }
      auto& chain = chains[chain_of[i]];
      std::vector<PlanPoint> longer{chain.front()};
      for (std::size_t j = 0; j + 1 < chain.size(); ++j) {
        const std::size_t k = find_piece(pieces, chain[j], chain[j + 1]);
        if (refined.chain_of[k] == kNoChain) {
          longer.push_back(chain[j + 1]);
          continue;
        }
        const auto& cut = refined.chains[refined.chain_of[k]];
        if (chain[j] < chain[j + 1])
          longer.insert(longer.end(), cut.begin() + 1, cut.end());
        else
          longer.insert(longer.end(), cut.rbegin() + 1, cut.rend());
      }
      chain = std::move(longer);
    }
    std::vector<Piece> next;
    next.reserve(pieces.size() + 2 * splits.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (refined.chain_of[k] == kNoChain) {
        next.push_back({pieces[k].a, pieces[k].b, false});
        continue;
      }
      const auto& cut = refined.chains[refined.chain_of[k]];
      for (std::size_t j = 0; j + 1 < cut.size(); ++j) add_piece(next, cut[j], cut[j + 1], true);
    }
    make_distinct(next);
    pieces = std::move(next);
  }

  noded.begin.reserve(segments.size() + 1);
  for (const Segment& s : segments) {
    noded.begin.push_back(static_cast<std::uint32_t>(noded.points.size()));
    noded.points.push_back(s.a);
    if (s.a == s.b) continue;
    const std::uint32_t chain = chain_of[find_piece(original, s.a, s.b)];
    if (chain == kNoChain) {
      noded.points.push_back(s.b);
    } else if (s.a < s.b) {
      noded.points.insert(noded.points.end(), chains[chain].begin() + 1, chains[chain].end());
    } else {
      noded.points.insert(noded.points.end(), chains[chain].rbegin() + 1, chains[chain].rend());
    }
  }
  noded.begin.push_back(static_cast<std::uint32_t>(noded.points.size()));
  return noded;
}

}  // namespace vicus
