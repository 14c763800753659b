#include "sectorgen/models/roof_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/models/roof_flat.hpp"

namespace vicus {
namespace {

constexpr double kOnLine_mm = 0.5;       // points nearer to a line belong to it: facets stay planar within 1 mm
constexpr double kSameNode_m = 5e-4;     // nodes of the wavefront nearer to each other in plan and clock are one
constexpr std::int32_t kSameSteps = 40;  // 4 mm of height at one place in plan: one point

double off_line_mm(PlanPoint a, PlanPoint b, PlanPoint p) {
  return std::abs(static_cast<double>(orient(a, b, p))) / std::sqrt(static_cast<double>(distance2(a, b)));
}

/// Indices of the ring's points at which a new edge of the outline begins.
std::vector<std::size_t> corners_of(const Ring& ring, const std::vector<bool>& is_upright, std::size_t first_edge) {
  const std::size_t n = ring.size();
  const auto may_drop = [&](std::size_t i) {
    return !is_upright[first_edge + i] && !is_upright[first_edge + (i + n - 1) % n] &&
           off_line_mm(ring[(i + n - 1) % n], ring[(i + 1) % n], ring[i]) <= kOnLine_mm &&
           dot(ring[i], ring[(i + n - 1) % n], ring[(i + 1) % n]) < 0;
  };
  std::size_t start = 0;
  while (start < n && may_drop(start)) ++start;
  std::vector<std::size_t> all(n), corners;
  for (std::size_t i = 0; i < n; ++i) all[i] = i;
  if (start == n) return all;
  corners.push_back(start);
  for (std::size_t k = 1; k < n; ++k) {
    const std::size_t i = (start + k) % n, next = (i + 1) % n;
    bool is_on_line = may_drop(i);
    // All that was left out since the last corner must be on the line to the next point too.
    for (std::size_t j = (corners.back() + 1) % n; is_on_line && j != next; j = (j + 1) % n)
      is_on_line =
          ring[corners.back()] != ring[next] && off_line_mm(ring[corners.back()], ring[next], ring[j]) <= kOnLine_mm;
    if (!is_on_line) corners.push_back(i);
  }
  return corners.size() < 3 ? all : corners;
}

double height_at(const RoofProfile& profile, double d) {
  for (std::size_t i = 1; i < profile.size(); ++i)
    if (d <= profile[i].first || i + 1 == profile.size()) {
      const auto [d0, z0] = profile[i - 1];
      const auto [d1, z1] = profile[i];
      return z0 + (z1 - z0) * (d - d0) / (d1 - d0);
    }
  return 0;
}

/// The lattice point nearest to (x, y), in mm, that is not outside of the upright edges.
PlanPoint rounded(double x, double y, const std::vector<std::pair<PlanPoint, PlanPoint>>& upright) {
  const auto near = [](double v) { return static_cast<std::int32_t>(std::llround(v)); };
  PlanPoint best{near(x), near(y)};
  if (upright.empty()) return best;
  double least = std::numeric_limits<double>::max();
  for (std::int32_t i = -2; i <= 2; ++i)
    for (std::int32_t k = -2; k <= 2; ++k) {
      const PlanPoint p{near(x) + i, near(y) + k};
      const double distance = std::hypot(p.x - x, p.y - y);
      if (distance < least &&
          std::all_of(upright.begin(), upright.end(), [&](const auto& e) { return orient(e.first, e.second, p) >= 0; }))
        least = distance, best = p;
    }
  return best;
}

/// Loops of directed edges; each passes no point twice. False: an edge leads nowhere.
bool take_loops(std::vector<std::pair<std::uint32_t, std::uint32_t>> edges,
                std::vector<std::vector<std::uint32_t>>& loops) {
  std::sort(edges.begin(), edges.end());
  // What is walked both ways is no border.
  std::vector<char> is_used(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_used[i] || edges[i].first > edges[i].second) continue;
    const std::pair back{edges[i].second, edges[i].first};
    for (auto it = std::lower_bound(edges.begin(), edges.end(), back); it != edges.end() && *it == back; ++it)
      if (auto& used = is_used[static_cast<std::size_t>(it - edges.begin())]; !used) {
        used = is_used[i] = 1;
        break;
      }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_used[i]) continue;
    std::vector<std::uint32_t> path{edges[i].first};
    std::uint32_t here = edges[i].second;
    is_used[i] = 1;
    for (;;) {
      if (const auto seen = std::find(path.begin(), path.end(), here); seen != path.end()) {
        loops.emplace_back(seen, path.end());
        path.erase(seen, path.end());
        if (path.empty()) break;
      }
      path.push_back(here);
      auto it = std::lower_bound(edges.begin(), edges.end(), std::pair(here, std::uint32_t{0}));
      while (it != edges.end() && it->first == here && is_used[static_cast<std::size_t>(it - edges.begin())]) ++it;
      if (it == edges.end() || it->first != here) return false;
      is_used[static_cast<std::size_t>(it - edges.begin())] = 1;
      here = it->second;
    }
  }
  return true;
}

/// For each node the first of those that are one with it.
std::vector<std::uint32_t> first_alike(const std::vector<WaveNode>& nodes) {
  std::vector<std::uint32_t> order(nodes.size()), alike(nodes.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = alike[i] = i;
  std::sort(order.begin(), order.end(),
            [&](auto i, auto k) { return std::tie(nodes[i].x, i) < std::tie(nodes[k].x, k); });
  const auto root = [&](std::uint32_t i) {
    while (alike[i] != i) i = alike[i] = alike[alike[i]];
    return i;
  };
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const WaveNode &p = nodes[order[a]], &q = nodes[order[b]];
      if (q.x - p.x > kSameNode_m) break;
      if (std::abs(q.y - p.y) > kSameNode_m || std::abs(q.d - p.d) > kSameNode_m) continue;
      const std::uint32_t r = root(order[a]), s = root(order[b]);
      alike[std::max(r, s)] = std::min(r, s);
    }
  for (std::uint32_t i = 0; i < alike.size(); ++i) alike[i] = root(i);
  return alike;
}

class MeshMaker {
 public:
  MeshMaker(const RoofOutline& outline, const Wave& wave, const RoofProfile& profile, double eave_m)
      : outline_(outline), wave_(wave) {
    place_nodes(profile, roof_steps(eave_m));
  }

  std::optional<Roof> make() {
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> borders(wave_.faces.size());
    const auto contour = static_cast<std::uint32_t>(outline_.chains.size());
    for (std::uint32_t s = 0; s < wave_.sides.size(); ++s) {
      const auto& side = wave_.sides[s];
      if (s < contour) {  // the wavefront's first sides are the outline's edges, in order
        const auto& chain = chain_ids_[s];
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) borders[side.face].emplace_back(chain[i], chain[i + 1]);
      } else if (ids_[side.a] != ids_[side.b]) {
        borders[side.face].emplace_back(ids_[side.a], ids_[side.b]);
      }
    }
    for (std::uint32_t f = 0; f < borders.size(); ++f)
      if (!add_facets(wave_.faces[f], std::move(borders[f]))) return std::nullopt;
    return std::move(roof_);
  }

 private:
  /// Points of the footprint first, then the wavefront's nodes; what falls together is one.
  void place_nodes(const RoofProfile& profile, std::int32_t eave) {
    const std::size_t contour = outline_.chains.size();
    const auto alike = first_alike(wave_.nodes);
    std::vector<std::vector<std::pair<PlanPoint, PlanPoint>>> upright(wave_.nodes.size());
    for (const auto& side : wave_.sides) {
      const WaveFace& face = wave_.faces[side.face];
      if (!face.is_upright) continue;
      const auto& chain = outline_.chains[face.edge];
      for (const std::uint32_t node : {side.a, side.b}) upright[alike[node]].emplace_back(chain.front(), chain.back());
    }
    std::vector<std::pair<RoofPoint, std::uint32_t>> placed;  // with a number: chains' points, then nodes
    std::uint32_t number = 0;
    for (const auto& chain : outline_.chains)
      for (const PlanPoint p : chain) placed.push_back({{p, eave}, number++});
    const std::uint32_t first_node = number;
    for (std::size_t i = 0; i < wave_.nodes.size(); ++i) {
      const WaveNode& n = wave_.nodes[alike[i]];
      RoofPoint p;
      if (alike[i] < contour)
        p = {outline_.chains[alike[i]].front(), eave};
      else
        p = {rounded(outline_.origin.x + n.x * kMmPerMetre, outline_.origin.y + n.y * kMmPerMetre, upright[alike[i]]),
             eave + std::max(0, roof_steps(height_at(profile, n.d)))};
      placed.push_back({p, number++});
    }
    std::sort(placed.begin(), placed.end());
    std::vector<std::uint32_t> id_of(placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const RoofPoint& p = placed[i].first;
      if (roof_.points.empty() || roof_.points.back().at != p.at || p.up - roof_.points.back().up > kSameSteps)
        roof_.points.push_back(p);
      id_of[placed[i].second] = static_cast<std::uint32_t>(roof_.points.size() - 1);
    }
    number = 0;
    for (const auto& chain : outline_.chains) {
      chain_ids_.emplace_back();
      for (std::size_t i = 0; i < chain.size(); ++i) chain_ids_.back().push_back(id_of[number++]);
    }
    ids_.assign(id_of.begin() + first_node, id_of.end());
  }

  bool add_facets(const WaveFace& face, std::vector<std::pair<std::uint32_t, std::uint32_t>> border) {
    std::vector<std::vector<std::uint32_t>> loops;
    if (!take_loops(std::move(border), loops)) return false;
    std::vector<std::vector<std::uint32_t>> holes;
    const std::size_t first = roof_.facets.size();
    for (auto& loop : loops) {
      Ring ring;
      for (const std::uint32_t i : loop) ring.push_back(roof_.points[i].at);
      const bool is_hole = !face.is_upright && area2(ring) < 0;
      if (is_hole)
        holes.push_back(std::move(loop));
      else
        roof_.facets.push_back({face.is_upright ? FacetKind::gable
                                : face.is_top   ? FacetKind::top
                                                : FacetKind::slope,
                                {std::move(loop)},
                                {}});
    }
    for (auto& hole : holes)
      if (!add_hole(first, std::move(hole))) return false;
    return true;
  }

  bool add_hole(std::size_t first, std::vector<std::uint32_t> hole) {
    for (std::size_t f = first; f < roof_.facets.size(); ++f) {
      Polygon polygon;
      for (const std::uint32_t i : roof_.facets[f].rings[0]) polygon.outer.push_back(roof_.points[i].at);
      const bool is_in = std::none_of(hole.begin(), hole.end(), [&](std::uint32_t i) {
        return locate(polygon, roof_.points[i].at) == Side::outside;
      });
      if (!is_in) continue;
      roof_.facets[f].rings.push_back(std::move(hole));
      return true;
    }
    return false;
  }

  const RoofOutline& outline_;
  const Wave& wave_;
  std::vector<std::uint32_t> ids_;                     // per node of the wavefront: a point of the roof
  std::vector<std::vector<std::uint32_t>> chain_ids_;  // per edge of the outline
  Roof roof_;
};

}  // namespace

std::size_t edge_count(const Polygon& footprint) {
  std::size_t n = footprint.outer.size();
  for (const auto& hole : footprint.holes) n += hole.size();
  return n;
}

RoofOutline make_outline(const Polygon& footprint, const std::vector<bool>& is_upright) {
  RoofOutline outline;
  outline.origin = footprint.outer.front();
  std::size_t first_edge = 0;
  const auto add = [&](const Ring& ring) {
    const auto corners = corners_of(ring, is_upright, first_edge);
    const std::size_t n = ring.size();
    outline.rings.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t from = corners[k], to = corners[(k + 1) % corners.size()];
      outline.rings.back().push_back({metres(std::int64_t{ring[from].x} - outline.origin.x),
                                      metres(std::int64_t{ring[from].y} - outline.origin.y)});
      outline.chains.emplace_back();
      for (std::size_t i = from;; i = (i + 1) % n) {
        outline.chains.back().push_back(ring[i]);
        if (i == to && outline.chains.back().size() > 1) break;
      }
      outline.first_edge.push_back(static_cast<std::uint32_t>(first_edge + from));
    }
    first_edge += n;
  };
  add(footprint.outer);
  for (const auto& hole : footprint.holes) add(hole);
  return outline;
}

std::optional<Roof> roof_from_wave(const RoofOutline& outline, const Wave& wave, const RoofProfile& profile,
                                   double eave_m) {
  return MeshMaker(outline, wave, profile, eave_m).make();
}

}  // namespace vicus
