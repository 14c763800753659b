#include "sectorgen/models/ground_covers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/run_parallel.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"
#include "sectorgen/sectors/overlay.hpp"

namespace vicus {
namespace {

constexpr double kReach_m = 12;        // farther things do not shape the ground
constexpr double kKerbRadius_m = 2.5;  // of a pavement's corner at a junction
constexpr double kLineTolerance_m = 0.08;
constexpr double kRailWidth_m = 0.09;
constexpr double kLeastPatch_m2 = 0.6;  // smaller ones are crumbs of overlays

using Polygons = std::vector<Polygon>;

/// Things of one sort, found again by box.
template <class T>
class Near {
 public:
  Near(std::vector<T> things, const std::vector<PlanBox>& boxes) : things_(std::move(things)), index_(boxes) {}
  std::vector<const T*> meeting(const PlanBox& box) const {
    std::vector<const T*> out;
    for (const std::uint32_t i : index_.meeting(box)) out.push_back(&things_[i]);
    return out;
  }

 private:
  std::vector<T> things_;
  BoxIndex index_;
};

template <class T, class BoxOf>
Near<T> near_of(std::vector<T> things, BoxOf box_of_thing) {
  std::vector<PlanBox> boxes;
  for (const T& thing : things) boxes.push_back(box_of_thing(thing));
  return Near<T>(std::move(things), boxes);
}

struct WideLine {
  Line line;
  double width_m = 0;
};

/// The treads of a flight: quadrangles across its line, neighbours share an edge.
Polygons treads_of(const Axis& axis) {
  double length = 0;
  for (std::size_t i = 1; i < axis.line.size(); ++i)
    length += std::sqrt(static_cast<double>(distance2(axis.line[i - 1], axis.line[i]))) / kMmPerMetre;
  const int count = std::clamp(static_cast<int>(length / kTread_m), 1, kMostTreads);
  std::vector<PlanPoint> left, right;
  std::size_t segment = 1;
  double before = 0;
  for (int i = 0; i <= count; ++i) {
    const double at = length * i / count;
    const auto size = [&](std::size_t k) {
      return std::sqrt(static_cast<double>(distance2(axis.line[k - 1], axis.line[k]))) / kMmPerMetre;
    };
    while (segment + 1 < axis.line.size() && before + size(segment) < at) before += size(segment++);
    const PlanPoint a = axis.line[segment - 1], b = axis.line[segment];
    const double l = size(segment), t = std::clamp((at - before) / l, 0.0, 1.0);
    const double ux = metres(b.x - a.x) / l, uy = metres(b.y - a.y) / l, half = axis.width_m / 2;
    const double x = metres(a.x) + ux * l * t, y = metres(a.y) + uy * l * t;
    left.push_back({lattice_mm(x - uy * half), lattice_mm(y + ux * half)});
    right.push_back({lattice_mm(x + uy * half), lattice_mm(y - ux * half)});
  }
  Polygons out;
  for (std::size_t i = 0; i + 1 < left.size(); ++i) {
    Polygon tread{{right[i], right[i + 1], left[i + 1], left[i]}, {}};
    if (area2(tread) > 0) out.push_back(std::move(tread));
  }
  return out;
}

Polygons rails_of(const Track& track) {
  const auto band = [&](double width_m) { return stroke_outlines({{track.line, width_m / 2}}, Cap::flat); };
  return subtract(band(track.width_m + kRailWidth_m), band(track.width_m - kRailWidth_m));
}

class Patches {
 public:
  Patches(const SourceMap& map, const City& city)
      : city_(city),
        roads_(wide_lines(map, [](const Axis& a) { return a.is_passage || a.is_steps ? 0 : a.carriageway_m; })),
        shared_(wide_lines(map, [](const Axis& a) { return is_shared(a) ? a.width_m : 0; })),
        paths_(path_lines(map)),
        steps_(near_of(flights(map), [](const Axis& a) { return grown(box_of(a.line), lattice_mm(a.width_m)); })),
        rails_(near_of(rail_tracks(map), [](const Track& t) { return grown(box_of(t.line), lattice_mm(t.width_m)); })),
        covers_(near_of(map.covers, [](const GroundCover& c) { return box_of(c.area); })),
        areas_(near_of(map.areas, [](const Area& a) { return box_of(a.area); })),
        walls_(near_of(walls(city), [](const Line& l) { return box_of(l); })) {}

  std::vector<Patch> of(std::size_t sector) const {
    const Sector& s = city_.sectors[sector];
    const PlanBox box = grown(box_of(s.ground), lattice_mm(kReach_m));
    std::vector<Patch> out;
    const auto add = [&](SurfaceKind kind, const Polygons& areas, bool is_tread = false) {
      for (Polygon& area : intersect(s.ground, areas))
        if (is_tread || kind == SurfaceKind::rail || area_m2(area) >= kLeastPatch_m2)
          out.push_back({sector, kind, std::move(area), is_tread});
    };
    const Polygons roads = carriageway(box);
    if (!roads.empty()) add(SurfaceKind::carriageway, roads);
    Polygons greens, earths, lots, squares;
    for (const GroundCover* c : covers_.meeting(box))
      (c->kind == SurfaceKind::grass ? greens : c->kind == SurfaceKind::earth ? earths : lots).push_back(c->area);
    for (const Area* a : areas_.meeting(box)) {
      if (a->kind == AreaKind::park || a->kind == AreaKind::plot) greens.push_back(a->area);
      if (a->kind == AreaKind::square) squares.push_back(a->area);
    }
    if (!greens.empty()) add(SurfaceKind::grass, unite(greens));
    if (!earths.empty()) add(SurfaceKind::earth, unite(earths));
    if (!lots.empty()) add(SurfaceKind::carriageway, keep_off(unite(lots), margins(box), Cap::flat));
    squares_and_shared(squares, box, add);
    const bool is_green = s.kind == SectorKind::open || !greens.empty();
    if (const auto paths = strokes(paths_, box); is_green && !paths.empty())
      add(SurfaceKind::path, stroke_outlines(paths, Cap::round));
    for (const Axis* flight : steps_.meeting(box))
      for (const Polygon& tread : treads_of(*flight)) add(SurfaceKind::steps, {tread}, true);
    for (const Track* track : rails_.meeting(box)) add(SurfaceKind::rail, rails_of(*track));
    return out;
  }

 private:
  static bool is_shared(const Axis& a) {
    return !a.is_passage && (a.kind == "pedestrian" || a.kind == "living_street");
  }
  template <class WidthOf>
  static Near<WideLine> wide_lines(const SourceMap& map, WidthOf width_of) {
    std::vector<WideLine> lines;
    for (const Axis& a : map.axes)
      if (const double w = width_of(a); w > 0 && a.level >= 0) lines.push_back({simplify(a.line, kLineTolerance_m), w});
    return near_of(std::move(lines),
                   [](const WideLine& l) { return grown(box_of(l.line), lattice_mm(l.width_m / 2)); });
  }
  static Near<WideLine> path_lines(const SourceMap& map) {
    static const std::set<std::string> kPaths{"footway", "path", "cycleway", "bridleway", "track", "service"};
    std::vector<WideLine> lines;
    for (const Axis& a : map.axes)
      if (kPaths.contains(a.kind) && a.carriageway_m == 0)
        lines.push_back({simplify(a.line, kLineTolerance_m), a.width_m});
    for (const Track& t : map.tracks)
      if (t.kind == SurfaceKind::path) lines.push_back({simplify(t.line, kLineTolerance_m), t.width_m});
    return near_of(std::move(lines),
                   [](const WideLine& l) { return grown(box_of(l.line), lattice_mm(l.width_m / 2)); });
  }
  static std::vector<Axis> flights(const SourceMap& map) {
    std::vector<Axis> out;
    for (const Axis& a : map.axes)
      if (a.is_steps && a.level >= 0) out.push_back(a);
    return out;
  }
  static std::vector<Track> rail_tracks(const SourceMap& map) {
    std::vector<Track> out;
    for (const Track& t : map.tracks)
      if (t.kind == SurfaceKind::rail) out.push_back({t.source_id, t.kind, t.width_m, simplify(t.line, 0.03)});
    return out;
  }
  static std::vector<Line> walls(const City& city) {
    std::vector<Line> out;
    for (const Border& b : city.borders)
      if (b.line.size() >= 2) out.push_back(b.line);
    return out;
  }
  static std::vector<Stroke> strokes(const Near<WideLine>& lines, const PlanBox& box) {
    std::vector<Stroke> out;
    for (const WideLine* l : lines.meeting(box)) out.push_back({l->line, l->width_m / 2});
    return out;
  }

  /// What lies too near to a wall for a carriageway.
  std::vector<Stroke> margins(const PlanBox& box) const {
    std::vector<Stroke> out;
    for (const Line* line : walls_.meeting(box)) out.push_back({*line, kLeastPavement_m});
    return out;
  }

  /// Strokes of the roads, pavement corners rounded, off the walls, without necks.
  Polygons carriageway(const PlanBox& box) const {
    const auto roads = strokes(roads_, box);
    if (roads.empty()) return {};
    Polygons area = offset(offset(stroke_outlines(roads, Cap::round), kKerbRadius_m, false), -kKerbRadius_m, true);
    area = keep_off(area, margins(box), Cap::flat);
    return offset(offset(area, -kLeastCarriageway_m / 2, false), kLeastCarriageway_m / 2, false);
  }

  /// Paved squares, and streets that walkers and vehicles share; not where a carriageway is.
  template <class Add>
  void squares_and_shared(Polygons& paved, const PlanBox& box, Add add) const {
    if (const auto shared = strokes(shared_, box); !shared.empty())
      for (auto& p : stroke_outlines(shared, Cap::round)) paved.push_back(std::move(p));
    if (!paved.empty()) add(SurfaceKind::paving, unite(paved));
  }

  const City& city_;
  Near<WideLine> roads_, shared_, paths_;
  Near<Axis> steps_;
  Near<Track> rails_;
  Near<GroundCover> covers_;
  Near<Area> areas_;
  Near<Line> walls_;
};

}  // namespace

SurfaceKind plain_ground(SectorKind kind) {
  switch (kind) {
    case SectorKind::street:
    case SectorKind::crossroads:
      return SurfaceKind::pavement;
    case SectorKind::square:
    case SectorKind::passage:
      return SurfaceKind::paving;
    case SectorKind::yard:
    case SectorKind::interior:  // has a floor of its own
      return SurfaceKind::earth;
    case SectorKind::open:
      return SurfaceKind::grass;
  }
  return SurfaceKind::pavement;
}

std::vector<Patch> ground_patches(const SourceMap& map, const City& city, unsigned threads) {
  const Patches patches(map, city);
  std::vector<std::vector<Patch>> of_sector(city.sectors.size());
  run_parallel(city.sectors.size(), thread_count(threads),
               [&](std::size_t i, unsigned) { of_sector[i] = patches.of(i); });
  std::vector<Patch> all;
  for (auto& list : of_sector) std::move(list.begin(), list.end(), std::back_inserter(all));
  return all;
}

}  // namespace vicus
