#include <algorithm>
#include <array>
#include <cmath>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"
#include "sectorgen/sectors/domain.hpp"

namespace vicus {
namespace {

constexpr double kPieceM = 4;           // outlines are taken or dropped in pieces about this long
constexpr double kFromObstacleM = 1.5;  // nearer ones bound what the obstacle bounds: only a sliver would come of them
// An outline may not close in on a street: what is left between would look like its mouth.
constexpr double kPlotFromAxisM = 2, kGreenFromAxisM = 10;
constexpr double kStreetParcelM = 20, kLeastPieceM = 0.5;
constexpr double kFromKerbM = 6, kFromEdgeM = 4;
constexpr double kLeastAreaM2 = 2'000;  // of parks and squares whose outline counts

double distance_m(PlanPoint p, PlanPoint a, PlanPoint b) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, px = double(p.x) - a.x, py = double(p.y) - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(px - t * dx, py - t * dy) / kMmPerMetre;
}

/// What outlines keep away from: lines found again by place, each with its distance.
class Keepers {
 public:
  void add(const Line& line, bool is_ring, double away_m) {
    for (std::size_t i = 0; i + (is_ring ? 0 : 1) < line.size(); ++i)
      pieces_.push_back({line[i], line[(i + 1) % line.size()], away_m});
  }
  void add(const Polygon& polygon, double away_m) {
    add(polygon.outer, true, away_m);
    for (const auto& hole : polygon.holes) add(hole, true, away_m);
  }
  void index() {
    std::vector<PlanBox> boxes;
    for (const auto& p : pieces_) {
      PlanBox box;
      box.add(p.a);
      box.add(p.b);
      const std::int32_t d = lattice_mm(p.away_m);
      boxes.push_back({{box.min.x - d, box.min.y - d}, {box.max.x + d, box.max.y + d}});
    }
    index_ = BoxIndex(std::move(boxes));
  }
  bool allow(PlanPoint p) const {
    for (std::uint32_t i : index_.meeting({p, p}))
      if (distance_m(p, pieces_[i].a, pieces_[i].b) < pieces_[i].away_m) return false;
    return true;
  }

 private:
  struct Piece {
    PlanPoint a, b;
    double away_m;
  };
  std::vector<Piece> pieces_;
  BoxIndex index_;
};

PlanPoint between(PlanPoint a, PlanPoint b, std::int64_t i, std::int64_t n) {
  return {static_cast<std::int32_t>(a.x + (std::int64_t{b.x} - a.x) * i / n),
          static_cast<std::int32_t>(a.y + (std::int64_t{b.y} - a.y) * i / n)};
}

/// Runs of one side whose every piece is allowed, as straight lines: from the smaller end, so that neighbours' common
/// side gives the same points.
void add_side(PlanPoint from, PlanPoint to, const Keepers& keepers, std::vector<Line>& out) {
  const PlanPoint a = std::min(from, to), b = std::max(from, to);
  const std::int64_t n = length_mm(a, b) / lattice_mm(kPieceM) + 1;
  std::int64_t start = -1;
  const auto flush = [&](std::int64_t end) {
    if (start >= 0 && end > start) out.push_back({between(a, b, start, n), between(a, b, end, n)});
    start = -1;
  };
  for (std::int64_t i = 0; i <= n; ++i) {
    const bool is_allowed =
        keepers.allow(between(a, b, i, n)) && (i == 0 || keepers.allow(between(a, b, 2 * i - 1, 2 * n)));
    if (!is_allowed) flush(i - 1);
    if (start < 0 && keepers.allow(between(a, b, i, n))) start = i;
  }
  flush(n);
}

/// A street's own parcel: its lines across the street bound nothing.
bool is_street_parcel(const Area& plot, const SourceMap& map, const BoxIndex& axes) {
  double inside = 0;
  PlanPoint middle;
  for (std::uint32_t i : axes.meeting(box_of(plot.area)))
    for (std::size_t k = 0; k + 1 < map.axes[i].line.size(); ++k)
      inside += inside_length_m(map.axes[i].line[k], map.axes[i].line[k + 1], plot.area, middle);
  return inside > kStreetParcelM;
}

/// The domain's outline, without what lies inside another of its polygons.
void add_city_edge(const std::vector<Polygon>& domain, Keepers& keepers) {
  std::vector<PlanBox> boxes;
  for (const auto& p : domain) boxes.push_back(box_of(p));
  const BoxIndex index(std::move(boxes));
  const auto ring = [&](const Ring& r, std::uint32_t self) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      const PlanPoint a = r[i], b = r[(i + 1) % r.size()], middle = between(a, b, 1, 2);
      const auto near = index.meeting({middle, middle});
      const bool is_inner = std::any_of(near.begin(), near.end(), [&](std::uint32_t j) {
        return j != self && locate(domain[j], middle) == Side::inside;
      });
      if (!is_inner) keepers.add({a, b}, false, kFromEdgeM);
    }
  };
  for (std::uint32_t i = 0; i < domain.size(); ++i) {
    ring(domain[i].outer, i);
    for (const auto& hole : domain[i].holes) ring(hole, i);
  }
}

void add_outlines(const std::vector<const Area*>& areas, const SourceMap& map, const Blocks& blocks,
                  const std::vector<Polygon>& domain, const std::vector<Line>& kerbs, double from_axis_m,
                  std::vector<Line>& out) {
  if (areas.empty()) return;
  Keepers keepers;
  add_city_edge(domain, keepers);
  for (const auto& h : blocks.houses)
    if (!h.is_overhead) keepers.add(h.area, kFromObstacleM);
  for (const auto& w : blocks.water) keepers.add(w, kFromObstacleM);
  for (const auto& w : blocks.walls) keepers.add(w.area, kFromObstacleM);
  for (const auto& axis : map.axes) keepers.add(axis.line, false, from_axis_m);
  for (const auto& kerb : kerbs) keepers.add(kerb, false, kFromKerbM);
  keepers.index();
  const auto ring = [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) add_side(r[i], r[(i + 1) % r.size()], keepers, out);
  };
  for (const Area* area : areas) {
    ring(area->area.outer);
    for (const auto& hole : area->area.holes) ring(hole);
  }
}

}  // namespace

std::vector<Line> outline_kerbs(const SourceMap& map, const Blocks& blocks, const std::vector<Polygon>& domain,
                                const std::vector<Line>& kerbs) {
  std::vector<PlanBox> boxes;
  for (const auto& axis : map.axes) {
    boxes.emplace_back();
    for (PlanPoint p : axis.line) boxes.back().add(p);
  }
  const BoxIndex axes(std::move(boxes));
  std::vector<const Area*> plots, greens;
  for (const auto& area : map.areas) {
    if (area.kind == AreaKind::plot && !is_street_parcel(area, map, axes)) plots.push_back(&area);
    if ((area.kind == AreaKind::park || area.kind == AreaKind::square) && area_m2(area.area) >= kLeastAreaM2)
      greens.push_back(&area);
  }
  std::vector<Line> out;
  add_outlines(plots, map, blocks, domain, kerbs, kPlotFromAxisM, out);
  add_outlines(greens, map, blocks, domain, kerbs, kGreenFromAxisM, out);
  std::erase_if(out, [](const Line& line) { return metres(length_mm(line[0], line[1])) < kLeastPieceM; });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace vicus
