#include "sectorgen/bake/prism_roof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "sectorgen/bake/prism_footprint.hpp"

namespace vicus {
namespace {

using Vector = std::array<double, 3>;
using Corners = std::vector<std::uint32_t>;

constexpr double kLeastArea_mm2 = 1;  // twice a fan's triangle: rounding makes none of these
constexpr double kUpPerMm = kRoofStepsPerMetre / kMmPerMetre;
constexpr std::int32_t kAtEave = 20;  // 2 mm, in steps of a roof's heights: so far a corner may lie off the eave

/// A part of a facet that is a fan from one of its corners.
struct Piece {
  bool is_gable = false;
  Vector normal{};
  Corners corners;  ///< of Roof::points
};

/// Twice the area's vector of a triangle, mm^2.
Vector area_of(const Roof& roof, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto side = [&](std::uint32_t from, std::uint32_t to) {
    const RoofPoint &p = roof.points[from], &q = roof.points[to];
    return Vector{double(q.at.x) - p.at.x, double(q.at.y) - p.at.y, (q.up - p.up) / kUpPerMm};
  };
  const Vector u = side(a, b), v = side(a, c);
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Do all triangles from corner `first` on look out?
bool is_fan(const Roof& roof, const Vector& normal, const Corners& corners, std::size_t first) {
  const std::size_t n = corners.size();
  for (std::size_t k = 1; k + 1 < n; ++k)
    if (dot(area_of(roof, corners[first], corners[(first + k) % n], corners[(first + k + 1) % n]), normal) <
        kLeastArea_mm2)
      return false;
  return true;
}
bool has_fan(const Roof& roof, const Vector& normal, const Corners& corners) {
  for (std::size_t first = 0; first < corners.size(); ++first)
    if (is_fan(roof, normal, corners, first)) return true;
  return false;
}

/// Triangles of a facet joined as long as what comes out is a fan.
void append_pieces(const Roof& roof, const RoofFacet& facet, std::vector<Piece>& out) {
  Vector normal{};
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3) {
    const auto& t = facet.triangles;
    const Vector area = area_of(roof, t[i], t[i + 1], t[i + 2]);
    for (std::size_t k = 0; k < 3; ++k) normal[k] += area[k];
    triangles.push_back({t[i], t[i + 1], t[i + 2]});
  }
  const double length = std::sqrt(dot(normal, normal));
  if (length <= 0) {
    for (Corners& t : triangles) out.push_back({facet.kind == FacetKind::gable, normal, std::move(t)});
    return;
  }
  for (double& v : normal) v /= length;
  const auto grow = [&](Corners& piece) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const std::uint32_t a = piece[i], b = piece[(i + 1) % piece.size()];
      for (auto t = triangles.begin(); t != triangles.end(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t c = (*t)[(k + 2) % 3];
          if ((*t)[k] != b || (*t)[(k + 1) % 3] != a || std::find(piece.begin(), piece.end(), c) != piece.end())
            continue;
          Corners larger = piece;
          larger.insert(larger.begin() + static_cast<std::ptrdiff_t>(i) + 1, c);
          if (!has_fan(roof, normal, larger)) continue;
          piece = std::move(larger);
          triangles.erase(t);
          return true;
        }
    }
    return false;
  };
  while (!triangles.empty()) {
    Piece piece{facet.kind == FacetKind::gable, normal, std::move(triangles.back())};
    triangles.pop_back();
    while (grow(piece.corners)) {
    }
    out.push_back(std::move(piece));
  }
}

/// From the roof's points to those of the house to be.
class RoundedRoof {
 public:
  RoundedRoof(const BakeHouse& house, PlanPoint corner, std::uint32_t step_mm, std::uint32_t up_step_mm)
      : house_(house), corner_(corner), step_mm_(step_mm), up_step_mm_(up_step_mm) {
    for (const RoofFacet& facet : house.facets.facets) append_pieces(house.facets, facet, pieces_);
  }

  bool set(PrismHouse& prism) {
    if (pieces_.empty() || !find_corners() || !(round_footprint(true) || round_footprint(false))) return false;
    const double per_step = up_step_mm_ * kUpPerMm;
    eave_ = std::lround(house_.eave_m * kRoofStepsPerMetre / per_step);
    for (std::uint32_t i = 0; i < house_.facets.points.size(); ++i) add_point(i, per_step);
    add_facets();
    if (!is_closed()) return false;
    sort_points();
    prism.kind = PrismKind::faceted;
    prism.rings = std::move(rings_);
    prism.eave = static_cast<std::uint32_t>(std::max(0L, eave_));
    prism.points = std::move(points_);
    prism.facets = std::move(facets_);
    prism.rise = highest_of(prism.points);
    return true;
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  /// Which point of the roof each corner of the footprint is.
  bool find_corners() {
    const auto eave = static_cast<std::int32_t>(std::lround(house_.eave_m * kRoofStepsPerMetre));
    std::map<PlanPoint, std::uint32_t> at_eave;
    for (std::uint32_t i = 0; i < house_.facets.points.size(); ++i)
      if (std::abs(house_.facets.points[i].up - eave) <= kAtEave) at_eave.emplace(house_.facets.points[i].at, i);
    const auto add = [&](const Ring& ring) {
      auto& out = footprint_.emplace_back();
      for (const PlanPoint p : ring) {
        const auto found = at_eave.find(p);
        if (found == at_eave.end()) return false;
        out.push_back(found->second);
      }
      return true;
    };
    if (!add(house_.footprint.outer)) return false;
    return std::all_of(house_.footprint.holes.begin(), house_.footprint.holes.end(), add);
  }

  /// Rings, and what each corner that stays is among their points. False: a ring vanishes, or a piece is no fan without
  /// the corners that are dropped.
  bool round_footprint(bool is_simplified) {
    std::vector<int> uses(house_.facets.points.size(), 0);
    for (const Piece& piece : pieces_)
      for (const std::uint32_t c : piece.corners) ++uses[c];
    rings_.clear();
    vertex_.assign(house_.facets.points.size(), std::nullopt);
    dropped_.clear();
    std::uint32_t count = 0;
    for (std::size_t r = 0; r < footprint_.size(); ++r) {
      const Ring& ring = r == 0 ? house_.footprint.outer : house_.footprint.holes[r - 1];
      std::vector<bool> forced;
      for (const std::uint32_t c : footprint_[r]) forced.push_back(!is_simplified || uses[c] != 1);
      std::vector<PlanPoint> points;
      std::vector<std::size_t> stay = simplified_ring(ring, step_mm_ / 2.0, forced);
      for (const std::size_t i : stay) {
        const PlanPoint q = steps_from(ring[i], corner_, step_mm_);
        if (points.empty() || points.back() != q) points.push_back(q);
        vertex_[footprint_[r][i]] = count + static_cast<std::uint32_t>(points.size()) - 1;
      }
      while (points.size() > 1 && points.front() == points.back()) {
        points.pop_back();
        for (auto& v : vertex_)
          if (v == count + points.size()) v = count;
      }
      if (points.size() < 3 || doubled_area(points) == 0) return false;
      count += static_cast<std::uint32_t>(points.size());
      for (std::size_t i = 0; i < ring.size(); ++i)
        if (!vertex_[footprint_[r][i]]) dropped_.insert(footprint_[r][i]);
      rings_.push_back(std::move(points));
    }
    return std::all_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
      const Corners left = without_dropped(piece.corners);
      return left.size() < 3 || left.size() == piece.corners.size() || has_fan(house_.facets, piece.normal, left);
    });
  }

  Corners without_dropped(Corners corners) const {
    std::erase_if(corners, [&](std::uint32_t c) { return dropped_.contains(c); });
    return corners;
  }

  std::uint32_t ring_points() const {
    std::size_t n = 0;
    for (const auto& ring : rings_) n += ring.size();
    return static_cast<std::uint32_t>(n);
  }

  void add_point(std::uint32_t i, double per_step) {
    if (vertex_[i] || dropped_.contains(i)) return;
    const RoofPoint& p = house_.facets.points[i];
    const PrismPoint rounded{steps_from(p.at, corner_, step_mm_),
                             static_cast<std::int32_t>(std::lround(p.up / per_step) - eave_)};
    const auto [at, is_new] = known_.emplace(rounded, ring_points() + static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(rounded);
    vertex_[i] = at->second;
  }

  void add_facets() {
    for (const Piece& piece : pieces_) {
      const Corners corners = without_dropped(piece.corners);
      if (corners.size() < 3) continue;
      // The fan that begins at the smallest index, so that facets of houses look alike to what packs them.
      std::optional<std::size_t> first;
      for (std::size_t k = 0; k < corners.size(); ++k)
        if (is_fan(house_.facets, piece.normal, corners, k) &&
            (!first || *vertex_[corners[k]] < *vertex_[corners[*first]]))
          first = k;
      PrismFacet facet{piece.is_gable, {}};
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t v = *vertex_[corners[(first.value_or(0) + k) % corners.size()]];
        if (facet.corners.empty() || facet.corners.back() != v) facet.corners.push_back(v);
      }
      while (facet.corners.size() > 1 && facet.corners.front() == facet.corners.back()) facet.corners.pop_back();
      if (facet.corners.size() >= 3) facets_.push_back(std::move(facet));
    }
  }

  /// Each edge as often one way as the other, where rings go round below it.
  bool is_closed() const {
    std::map<Edge, int> balance;
    const auto add = [&](std::uint32_t a, std::uint32_t b, int by) { balance[std::minmax(a, b)] += a < b ? by : -by; };
    for (const PrismFacet& facet : facets_)
      for (std::size_t k = 0; k < facet.corners.size(); ++k)
        add(facet.corners[k], facet.corners[(k + 1) % facet.corners.size()], 1);
    std::uint32_t first = 0;
    for (const auto& ring : rings_) {
      const auto n = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t i = 0; i < n; ++i) add(first + i, first + (i + 1) % n, -1);
      first += n;
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
  }

  /// By the nearest of the rings' points, and only those that a facet has: small numbers follow each other.
  void sort_points() {
    const std::uint32_t n = ring_points();
    std::vector<PlanPoint> ring_points;
    for (const auto& ring : rings_) ring_points.insert(ring_points.end(), ring.begin(), ring.end());
    std::set<std::uint32_t> used;
    for (const PrismFacet& facet : facets_) used.insert(facet.corners.begin(), facet.corners.end());
    std::vector<std::pair<std::size_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      if (used.contains(n + i)) order.push_back({nearest_to(points_[i].at, ring_points), i});
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      return std::tie(a.first, points_[a.second]) < std::tie(b.first, points_[b.second]);
    });
    std::vector<std::uint32_t> place(points_.size());
    std::vector<PrismPoint> sorted;
    for (const auto& [anchor, i] : order) {
      place[i] = n + static_cast<std::uint32_t>(sorted.size());
      sorted.push_back(points_[i]);
    }
    points_ = std::move(sorted);
    for (PrismFacet& facet : facets_) {
      for (std::uint32_t& c : facet.corners)
        if (c >= n) c = place[c - n];
    }
    std::stable_sort(facets_.begin(), facets_.end(),
                     [](const PrismFacet& a, const PrismFacet& b) { return a.corners < b.corners; });
  }

  const BakeHouse& house_;
  PlanPoint corner_;
  std::uint32_t step_mm_, up_step_mm_;
  std::vector<Piece> pieces_;
  std::vector<Corners> footprint_;  ///< of each ring's corners: points of the roof
  long eave_ = 0;                   ///< steps above the ground
  std::vector<std::vector<PlanPoint>> rings_;
  std::vector<std::optional<std::uint32_t>> vertex_;  ///< of the roof's points; none: dropped, or not yet
  std::set<std::uint32_t> dropped_;
  std::map<PrismPoint, std::uint32_t> known_;
  std::vector<PrismPoint> points_;
  std::vector<PrismFacet> facets_;
};

}  // namespace

bool set_own_roof(const BakeHouse& house, PlanPoint corner, std::uint32_t step_mm, std::uint32_t up_step_mm,
                  PrismHouse& prism) {
  return RoundedRoof(house, corner, step_mm, up_step_mm).set(prism);
}

}  // namespace vicus
