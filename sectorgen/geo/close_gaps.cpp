#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "city_db/boxes.hpp"
#include "sectorgen/geo/box_pairs.hpp"
#include "sectorgen/geo/neighbours.hpp"
#include "sectorgen/geo/repair.hpp"
#include "sectorgen/geo/ring_check.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {

namespace {

constexpr double kReachMm = 100;
// Two roundings to the lattice part what lies on one line by less; noding joins that.
constexpr double kRoundingMm = 1.5;
// Below, a gap is an accident of the source's own decimals: OpenStreetMap's are 11 mm.
constexpr double kGapMm = 10;

double distance_mm(PlanPoint a, PlanPoint b) {
  return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y);
}

struct Foot {
  double distance_mm = std::numeric_limits<double>::infinity();
  double share = 0;  // along the edge, 0..1
  PlanPoint at;      // rounded
};

Foot foot_on_edge(PlanPoint p, PlanPoint a, PlanPoint b) {
  const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
  const double px = static_cast<double>(p.x) - a.x, py = static_cast<double>(p.y) - a.y;
  const double share = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double fx = share * dx, fy = share * dy;
  return {std::hypot(px - fx, py - fy),
          share,
          {static_cast<std::int32_t>(std::llround(a.x + fx)), static_cast<std::int32_t>(std::llround(a.y + fy))}};
}

bool is_near(PlanPoint p, const PlanBox& box) {
  constexpr auto kReach = static_cast<std::int32_t>(kReachMm);
  return p.x >= box.min.x - kReach && p.x <= box.max.x + kReach && p.y >= box.min.y - kReach &&
         p.y <= box.max.y + kReach;
}

/// What of the earlier houses lies near one house.
struct Surroundings {
  struct Vertex {
    PlanPoint at;
    std::size_t house;
  };
  struct Edge {
    PlanPoint a, b;
    PlanBox box;
    std::size_t house;
  };
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;

  void add(const Ring& ring, std::size_t house, const PlanBox& box) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (is_near(a, box)) vertices.push_back({a, house});
      const PlanBox edge_box = box_of(a, b);
      constexpr auto kReach = static_cast<std::int32_t>(kReachMm);
      if (edge_box.min.x <= box.max.x + kReach && edge_box.max.x >= box.min.x - kReach &&
          edge_box.min.y <= box.max.y + kReach && edge_box.max.y >= box.min.y - kReach)
        edges.push_back({a, b, edge_box, house});
    }
  }
};

struct Gap {
  std::size_t house;
  double width_mm;
  PlanPoint at;
};

/// One house on its way to its neighbours. `gaps` collects what is closed, whether it becomes an issue or not.
class Approach {
 public:
  Approach(const Surroundings& around, const std::vector<Footprint>& footprints)
      : around_(around), footprints_(footprints) {}

  std::vector<Gap> gaps;

  Ring moved(const Ring& ring) {
    Ring moved;
    for (PlanPoint p : ring) moved.push_back(target_of(p));
    return with_neighbours_vertices(moved);
  }

 private:
  /// A vertex that already is a neighbour's stays; else the nearest vertex in reach, else the nearest point of an edge.
  PlanPoint target_of(PlanPoint p) {
    double nearest = kReachMm;
    const Surroundings::Vertex* vertex = nullptr;
    for (const Surroundings::Vertex& v : around_.vertices) {
      if (v.at == p) return p;
      if (!is_near(p, {v.at, v.at})) continue;
      if (const double d = distance_mm(v.at, p); d <= nearest && (d < nearest || !vertex || v.at < vertex->at)) {
        nearest = d;
        vertex = &v;
      }
    }
    if (vertex) {
      note(p, vertex->house, nearest);
      return vertex->at;
    }
    Foot best;
    std::size_t house = 0;
    for (const Surroundings::Edge& edge : around_.edges) {
      if (!is_near(p, edge.box)) continue;
      if (const Foot foot = foot_on_edge(p, edge.a, edge.b); foot.distance_mm < best.distance_mm) {
        best = foot;
        house = edge.house;
      }
    }
    if (best.distance_mm > kReachMm || best.distance_mm <= kRoundingMm) return p;
    note(p, house, best.distance_mm);
    return best.at;
  }

  Ring with_neighbours_vertices(const Ring& ring) {
    Ring full;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      full.push_back(a);
      if (a == b) continue;
      const PlanBox edge_box = box_of(a, b);
      std::vector<std::pair<double, const Surroundings::Vertex*>> between;
      for (const Surroundings::Vertex& v : around_.vertices) {
        if (v.at == a || v.at == b || !is_near(v.at, edge_box)) continue;
        const Foot foot = foot_on_edge(v.at, a, b);
        const bool is_beside_end = foot.share <= 0 || foot.share >= 1;
        if (!is_beside_end && foot.distance_mm <= kReachMm && foot.distance_mm > kRoundingMm)
          between.emplace_back(foot.share, &v);
      }
      std::sort(between.begin(), between.end(), [](const auto& v, const auto& w) {
        return std::pair(v.first, v.second->at) < std::pair(w.first, w.second->at);
      });
      for (const auto& [share, vertex] : between) {
        note(vertex->at, vertex->house, foot_on_edge(vertex->at, a, b).distance_mm);
        full.push_back(vertex->at);
      }
    }
    return full;
  }

  void note(PlanPoint at, std::size_t house, double width_mm) { gaps.push_back({house, width_mm, at}); }

  const Surroundings& around_;
  const std::vector<Footprint>& footprints_;
};

Polygon approached(const Polygon& area, Approach& approach) {
  Polygon closed{without_repeats(approach.moved(area.outer)), {}};
  for (const Ring& hole : area.holes) closed.holes.push_back(without_repeats(approach.moved(hole)));
  return closed;
}

bool is_sound(const Polygon& polygon) {
  if (polygon.outer.size() < 3 || area2(polygon.outer) <= 0) return false;
  for (const Ring& hole : polygon.holes)
    if (hole.size() < 3 || area2(hole) >= 0) return false;
  return is_valid(polygon);
}

/// One issue per neighbour: the widest gap to it, of those that are gaps (outside of both) and not overlaps.
void report(const std::vector<Gap>& gaps, const std::vector<Footprint>& footprints, std::size_t house,
            const Polygon& before, bool is_closed, std::vector<Issue>& issues) {
  std::map<std::size_t, Gap> widest;
  for (const Gap& gap : gaps) {
    if (gap.width_mm < kGapMm || locate(footprints[gap.house].area, gap.at) == Side::inside ||
        locate(before, gap.at) == Side::inside)
      continue;
    const auto [found, is_new] = widest.emplace(gap.house, gap);
    if (!is_new && gap.width_mm > found->second.width_mm) found->second = gap;
  }
  for (const auto& [neighbour, gap] : widest) {
    char text[80];
    std::snprintf(text, sizeof text, "A gap of %.0f cm to ", gap.width_mm / 10);
    issues.push_back({IssueCode::gap,
                      text + footprints[neighbour].source_id + (is_closed ? "; closed." : "; it could not be closed."),
                      footprints[house].source_id, gap.at});
  }
}

}  // namespace

void close_gaps(std::vector<Footprint>& footprints, std::vector<Issue>& issues) {
  std::vector<PlanBox> boxes;
  for (const Footprint& footprint : footprints)
    boxes.push_back(footprint.is_part || footprint.base_m > 0 ? PlanBox{} : box_of(footprint.area.outer));
  const auto pairs = box_pairs(boxes, static_cast<std::int32_t>(kReachMm));
  for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
    const std::size_t house = pairs[begin].second;
    Footprint& footprint = footprints[house];
    Surroundings around;
    for (; end < pairs.size() && pairs[end].second == house; ++end) {
      const Polygon& earlier = footprints[pairs[end].first].area;
      around.add(earlier.outer, pairs[end].first, boxes[house]);
      for (const Ring& hole : earlier.holes) around.add(hole, pairs[end].first, boxes[house]);
    }
    Approach approach(around, footprints);
    Polygon closed = approached(footprint.area, approach);
    if (approach.gaps.empty()) continue;
    const bool is_closed = is_sound(closed);
    report(approach.gaps, footprints, house, footprint.area, is_closed, issues);
    if (is_closed) footprint.area = std::move(closed);
  }
}

}  // namespace vicus
