#include "sectorgen/sectors/domain.hpp"

#include <algorithm>
#include <map>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"

namespace vicus {
namespace {

constexpr double kCell = 6;  // m

/// A stretch of an axis outside the closed outline; `anchored`: that end is inside.
struct Stretch {
  Line line;
  double half_width = 0;
  bool anchored[2] = {false, false};
};

/// Axes cut where they share a vertex with another axis and where they pass the outline.
std::vector<Stretch> stretches_outside(const SourceMap& map, const Raster& raster, const Mask& inside) {
  std::map<PlanPoint, int> uses;
  const auto is_out = [&](PlanPoint p) { return !inside[raster.cell_at(p)]; };
  for (const auto& axis : map.axes)
    for (PlanPoint p : axis.line)
      if (is_out(p)) ++uses[p];
  std::vector<Stretch> out;
  for (const auto& axis : map.axes) {
    Stretch s;
    const auto flush = [&] {
      if (s.line.size() > 1) out.push_back(s);
      s = {};
    };
    s.half_width = std::max(axis.width_m / 2 + 3, 7.0);
    for (std::size_t i = 0; i < axis.line.size(); ++i) {
      const PlanPoint p = axis.line[i];
      const bool first = i == 0;
      const bool out_here = is_out(p);
      if (!first) {
        const bool was_out = is_out(axis.line[i - 1]);
        if (!was_out && out_here) {
          s.line = {axis.line[i - 1]};
          s.anchored[0] = true;
        }
        if (was_out && !out_here) {
          s.line.push_back(p);
          s.anchored[1] = true;
          flush();
        }
      }
      s.half_width = std::max(axis.width_m / 2 + 3, 7.0);
      if (!out_here) continue;
      s.line.push_back(p);
      if (i + 1 < axis.line.size() && uses[p] > 1 && s.line.size() > 1) {
        flush();
        s.half_width = std::max(axis.width_m / 2 + 3, 7.0);
        s.line = {p};
      }
    }
    flush();
  }
  return out;
}

double span_m(const PlanBox& box) { return box.is_empty() ? 0 : metres(length_mm(box.min, box.max)); }

/// Stretches that hang together and come back where they left (the two carriageways of a road out of the city) are no
/// connection: they go when they reach farther than the places they join lie apart.
void drop_excursions(const std::vector<Stretch>& all, std::vector<char>& dead) {
  std::map<PlanPoint, std::vector<std::size_t>> at;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!dead[i])
      for (int end = 0; end < 2; ++end)
        if (!all[i].anchored[end]) at[end == 0 ? all[i].line.front() : all[i].line.back()].push_back(i);
  std::vector<char> seen(all.size(), 0);
  for (std::size_t seed = 0; seed < all.size(); ++seed) {
    if (dead[seed] || seen[seed]) continue;
    std::vector<std::size_t> group{seed};
    seen[seed] = 1;
    PlanBox anchors, whole;
    for (std::size_t j = 0; j < group.size(); ++j) {
      const Stretch& s = all[group[j]];
      for (PlanPoint p : s.line) whole.add(p);
      for (int end = 0; end < 2; ++end) {
        const PlanPoint p = end == 0 ? s.line.front() : s.line.back();
        if (s.anchored[end]) {
          anchors.add(p);
          continue;
        }
        for (std::size_t other : at[p])
          if (!seen[other]) {
            seen[other] = 1;
            group.push_back(other);
          }
      }
    }
    if (span_m(whole) > 1.5 * span_m(anchors) + 30)
      for (std::size_t i : group) dead[i] = 1;
  }
}

/// Drops what leads nowhere until every end is anchored or meets another stretch.
std::vector<Stroke> connecting(std::vector<Stretch> all) {
  std::map<PlanPoint, int> degree;
  for (const auto& s : all) {
    if (!s.anchored[0]) ++degree[s.line.front()];
    if (!s.anchored[1]) ++degree[s.line.back()];
  }
  std::vector<char> dead(all.size(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      auto& s = all[i];
      if (dead[i]) continue;
      const bool loose =
          (!s.anchored[0] && degree[s.line.front()] < 2) || (!s.anchored[1] && degree[s.line.back()] < 2);
      if (!loose) continue;
      dead[i] = 1;
      changed = true;
      if (!s.anchored[0]) --degree[s.line.front()];
      if (!s.anchored[1]) --degree[s.line.back()];
    }
  }
  drop_excursions(all, dead);
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!dead[i]) strokes.push_back({simplify(all[i].line, 0.5), all[i].half_width});
  return strokes;
}

PlanBox extent(const SourceMap& map, const Blocks& blocks) {
  PlanBox box;
  for (const auto& h : blocks.houses)
    for (PlanPoint p : h.area.outer) box.add(p);
  if (box.is_empty())
    for (const auto& axis : map.axes)
      for (PlanPoint p : axis.line) box.add(p);
  return box;
}

}  // namespace

std::vector<Polygon> make_domain(const SourceMap& map, const Blocks& blocks) {
  if (!map.boundary.empty()) return map.boundary;
  const PlanBox box = extent(map, blocks);
  if (box.is_empty()) return {};
  const Raster raster = Raster::over(box, kCell, kCityGrow + 4 * kCell);
  Mask built(raster.size(), 0);
  for (const auto& h : blocks.houses)
    if (!h.is_overhead) paint(raster, h.area, built);
  const bool has_houses = std::any_of(built.begin(), built.end(), [](char c) { return c != 0; });
  if (!has_houses)
    for (const auto& axis : map.axes) paint(raster, axis.line, built);
  // Closing by distances: grown = within kCityGrow of a house; kept = farther than kCityShrink from what is not grown.
  const std::vector<float> to_house = distance_m(raster, built);
  Mask outside(raster.size());
  for (std::size_t i = 0; i < outside.size(); ++i) outside[i] = to_house[i] > static_cast<float>(kCityGrow);
  const std::vector<float> to_outside = distance_m(raster, outside);
  Mask inside(raster.size());
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = to_outside[i] > static_cast<float>(kCityShrink);
  std::vector<Polygon> domain = outlines(raster, inside);
  for (auto& p : stroke_outlines(connecting(stretches_outside(map, raster, inside)), Cap::flat))
    domain.push_back(std::move(p));
  return domain;
}

namespace {

constexpr double kOpenRadius = 8;    // m
constexpr double kKerbRun = 20;      // m: shorter open sides get no kerb
constexpr double kKerbSpacing = 12;  // m between its vertices: where a cut may begin
constexpr double kKerbJoin = 6;      // m: carriageways nearer than twice this share one strip

/// Points every kKerbSpacing along the ring at most.
Line densified(const Ring& ring) {
  Line out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const int n = static_cast<int>(metres(length_mm(a, b)) / kKerbSpacing) + 1;
    for (int k = 0; k < n; ++k)
      out.push_back({static_cast<std::int32_t>(a.x + (std::int64_t{b.x} - a.x) * k / n),
                     static_cast<std::int32_t>(a.y + (std::int64_t{b.y} - a.y) * k / n)});
  }
  return out;
}

/// The point `m` metres to the right of the direction from a to b, at p.
PlanPoint right_of(PlanPoint a, PlanPoint b, PlanPoint p, double m) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::sqrt(dx * dx + dy * dy);
  if (length == 0) return p;
  return {p.x + lattice_mm(m * dy / length), p.y - lattice_mm(m * dx / length)};
}

/// Runs of the closed line whose points pass the test, if longer than kKerbRun.
template <class Test>
void add_runs(const Line& closed, Test test, std::vector<Line>& out) {
  const std::size_t n = closed.size();
  std::size_t start = 0;
  while (start < n && test(start)) ++start;
  if (start == n) {
    Line whole = closed;
    whole.push_back(closed.front());
    out.push_back(std::move(whole));
    return;
  }
  Line run;
  double length = 0;
  for (std::size_t k = 1; k <= n; ++k) {
    const PlanPoint p = closed[(start + k) % n];
    if (test((start + k) % n)) {
      if (!run.empty()) length += metres(length_mm(run.back(), p));
      run.push_back(p);
      continue;
    }
    if (length >= kKerbRun) out.push_back(run);
    run.clear();
    length = 0;
  }
}

}  // namespace

namespace {

constexpr double kStrokePiece = 100;  // m: strokes are that long at most, so that a tile takes only what is near
constexpr std::int32_t kTileMm = 400'000, kTileMarginMm = 90'000;

PlanPoint point_between(PlanPoint a, PlanPoint b, int j, int n) {
  return {static_cast<std::int32_t>(a.x + (std::int64_t{b.x} - a.x) * j / n),
          static_cast<std::int32_t>(a.y + (std::int64_t{b.y} - a.y) * j / n)};
}

/// Axes with open ground on a side: elsewhere the facades bound the street.
template <class Clear>
std::vector<Stroke> open_strokes(const SourceMap& map, Clear clear_at) {
  std::vector<Stroke> open;
  for (const auto& axis : map.axes) {
    if (axis.is_passage) continue;
    Line run;
    double length = 0;
    const double half = std::clamp(axis.width_m / 2 + 2.5, 4.0, 14.0), beside = half + kOpenSide * 2 / 3;
    const auto flush = [&] {
      if (run.size() > 1) open.push_back({simplify(run, 0.3), half});
      run.clear();
      length = 0;
    };
    for (std::size_t i = 0; i + 1 < axis.line.size(); ++i) {
      const PlanPoint a = axis.line[i], b = axis.line[i + 1];
      const int n = static_cast<int>(metres(length_mm(a, b)) / kKerbSpacing) + 1;
      for (int k = 0; k < n; ++k) {
        const PlanPoint p = point_between(a, b, k, n), q = point_between(a, b, k + 1, n);
        if (clear_at(right_of(a, b, p, beside)) < kOpenRadius && clear_at(right_of(a, b, p, -beside)) < kOpenRadius) {
          flush();
          continue;
        }
        if (run.empty()) run.push_back(p);
        run.push_back(q);
        length += metres(length_mm(p, q));
        if (length > kStrokePiece) flush();
      }
    }
    flush();
  }
  return open;
}

/// Open stretches of the strip's outline whose edges have their middle in the tile.
template <class Clear>
void add_open_sides(const Polygon& strip, const PlanBox& tile, Clear clear_at, std::vector<Line>& kerbs) {
  const auto in_tile = [&](PlanPoint a, PlanPoint b) {
    const PlanPoint m = point_between(a, b, 1, 2);
    return m.x >= tile.min.x && m.x < tile.max.x && m.y >= tile.min.y && m.y < tile.max.y;
  };
  const auto ring = [&](const Ring& r) {
    const Line closed = densified(r);
    // Two discs side by side away from the street must be free of obstacles.
    const auto is_open = [&](std::size_t i) {
      const PlanPoint p = closed[i], a = closed[(i + closed.size() - 1) % closed.size()],
                      b = closed[(i + 1) % closed.size()];
      return clear_at(p) >= kOpenRadius / 2 && clear_at(right_of(a, b, p, kOpenSide * 2 / 3)) >= kOpenRadius &&
             clear_at(right_of(a, b, p, kOpenSide * 4 / 3)) >= kOpenRadius;
    };
    std::vector<Line> runs;
    add_runs(closed, is_open, runs);
    for (const Line& run : runs) {
      Line part;
      for (std::size_t i = 0; i + 1 < run.size(); ++i) {
        if (!in_tile(run[i], run[i + 1])) {
          if (part.size() > 1) kerbs.push_back(part);
          part.clear();
          continue;
        }
        if (part.empty()) part.push_back(run[i]);
        part.push_back(run[i + 1]);
      }
      if (part.size() > 1) kerbs.push_back(part);
    }
  };
  ring(strip.outer);
  for (const auto& hole : strip.holes) ring(hole);
}

/// Tile by tile, each with what is near: the union of a whole city's strips costs minutes, and an edit would reach far.
template <class Clear>
void add_tiled_kerbs(const std::vector<Stroke>& open, Clear clear_at, std::vector<Line>& kerbs) {
  std::vector<PlanBox> boxes;
  PlanBox all;
  for (const auto& stroke : open) {
    boxes.emplace_back();
    for (PlanPoint p : stroke.line) boxes.back().add(p), all.add(p);
  }
  if (all.is_empty()) return;
  const BoxIndex index(boxes);
  const auto tile_of = [](std::int32_t v) { return (v >= 0 ? v : v - kTileMm + 1) / kTileMm; };
  for (int ty = tile_of(all.min.y) - 1; ty <= tile_of(all.max.y) + 1; ++ty)
    for (int tx = tile_of(all.min.x) - 1; tx <= tile_of(all.max.x) + 1; ++tx) {
      const PlanBox tile{{tx * kTileMm, ty * kTileMm}, {(tx + 1) * kTileMm, (ty + 1) * kTileMm}};
      const PlanBox around{{tile.min.x - kTileMarginMm, tile.min.y - kTileMarginMm},
                           {tile.max.x + kTileMarginMm, tile.max.y + kTileMarginMm}};
      std::vector<Stroke> near;
      for (std::uint32_t i : index.meeting(around)) near.push_back(open[i]);
      for (const auto& strip : close_gaps(stroke_outlines(near, Cap::round), kKerbJoin))
        add_open_sides(strip, tile, clear_at, kerbs);
    }
}

}  // namespace

std::vector<Line> make_kerbs(const SourceMap& map, const Blocks& blocks, const std::vector<Polygon>& domain) {
  const PlanBox box = extent(map, blocks);
  std::vector<Line> kerbs;
  if (box.is_empty()) return kerbs;
  const Raster raster = Raster::over(box, kCell, kCityGrow);
  Mask blocked(raster.size(), 0);
  for (const auto& p : domain) paint(raster, p, blocked);
  for (char& c : blocked) c = static_cast<char>(!c);
  for (const auto& h : blocks.houses)
    if (!h.is_overhead) paint(raster, h.area, blocked);
  for (const auto& w : blocks.water) paint(raster, w, blocked);
  for (const auto& w : blocks.walls) paint(raster, w.area, blocked);
  const std::vector<float> clearance = distance_m(raster, blocked);
  const auto clear_at = [&](PlanPoint p) { return static_cast<double>(clearance[raster.cell_at(p)]); };

  const std::vector<Stroke> open = open_strokes(map, clear_at);
  add_tiled_kerbs(open, clear_at, kerbs);
  for (auto& line : outline_kerbs(map, blocks, domain, kerbs)) kerbs.push_back(std::move(line));
  return kerbs;
}

}  // namespace vicus
