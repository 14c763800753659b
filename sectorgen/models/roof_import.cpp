#include "sectorgen/models/roof_import.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/models/plan_cover.hpp"
#include "sectorgen/models/roof_crossings.hpp"
#include "sectorgen/models/roof_flat.hpp"
#include "sectorgen/models/solid_check.hpp"

namespace vicus {
namespace {

constexpr std::size_t kMostFaces = 20'000;
constexpr double kLeastEave_m = 0.5;
constexpr int kMostCuts = 3;            // times that the plan is cut again where faces cross, and then at pinches
constexpr std::int32_t kNotch_mm = 50;  // how far round a pinch the roof bends to let go

/// What stands at one corner of a triangle: a level of its mesh point. Levels of a point are numbered from the lowest.
class Levels {
 public:
  explicit Levels(const PlanCover& cover)
      : cover_(cover), level_(cover.face.size()), heights_(cover.mesh.points.size()) {
    std::vector<std::vector<std::pair<double, std::uint32_t>>> corners(cover.mesh.points.size());
    for (std::uint32_t t = 0; t < cover.face.size(); ++t) {
      if (cover.face[t] == kNone) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = cover.mesh.corner(t, k);
        const PlanPoint p = cover.mesh.points[v];
        corners[v].emplace_back(cover.planes[cover.face[t]].up_at(p.x, p.y), 3 * t + static_cast<std::uint32_t>(k));
      }
    }
    for (std::uint32_t v = 0; v < corners.size(); ++v) {
      auto& list = corners[v];
      std::sort(list.begin(), list.end());
      for (std::size_t i = 0; i < list.size();) {
        double sum = 0;
        std::size_t end = i;
        for (; end < list.size() && (end == i || list[end].first - list[end - 1].first <= kJoin_m); ++end)
          sum += list[end].first;
        for (std::size_t c = i; c < end; ++c)
          level_[list[c].second / 3][list[c].second % 3] = static_cast<std::uint32_t>(heights_[v].size());
        heights_[v].push_back(roof_steps(sum / static_cast<double>(end - i)));
        i = end;
      }
    }
  }

  std::int32_t up(std::uint32_t t, int k) const {
    const auto corner = static_cast<std::size_t>(k % 3);
    return heights_[cover_.mesh.triangles[t].corner[corner]][level_[t][corner]];
  }
  /// Heights at a mesh point, ascending; equal ones may repeat.
  const std::vector<std::int32_t>& at(std::uint32_t v) const { return heights_[v]; }

  /// The lowest that any face comes to.
  std::int32_t lowest() const {
    std::int32_t least = INT32_MAX;
    for (const auto& list : heights_)
      if (!list.empty()) least = std::min(least, list.front());
    return least;
  }

  /// Every level of the point that is within `reach` of `up` becomes `up`.
  void pull(std::uint32_t v, std::int32_t up, std::int32_t reach) {
    for (auto& h : heights_[v])
      if (std::abs(h - up) <= reach) h = up;
  }
  /// The two levels of a point, and those between, become one.
  void join(std::uint32_t v, std::int32_t low, std::int32_t high) {
    for (auto& h : heights_[v])
      if (h >= low && h <= high) h = low + (high - low) / 2;
  }

 private:
  const PlanCover& cover_;
  std::vector<std::array<std::uint32_t, 3>> level_;
  std::vector<std::vector<std::int32_t>> heights_;
};

/// Where two faces cross above an inner edge, the end where they are nearer is joined. False: by more than kMostBend_m.
bool uncross(const PlanCover& cover, Levels& levels) {
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::uint32_t t = 0; t < cover.face.size(); ++t) {
      if (cover.face[t] == kNone) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t n = cover.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
        if (n == kNone || n < t || cover.face[n] == kNone) continue;
        const int m = cover.mesh.twin_side(t, k);
        const std::int32_t ta = levels.up(t, k + 1), tb = levels.up(t, k + 2), na = levels.up(n, m + 2),
                           nb = levels.up(n, m + 1);
        if (!((ta > na && tb < nb) || (ta < na && tb > nb))) continue;
        const bool is_first = std::abs(ta - na) <= std::abs(tb - nb);
        const std::int32_t low = is_first ? std::min(ta, na) : std::min(tb, nb),
                           high = is_first ? std::max(ta, na) : std::max(tb, nb);
        if (high - low > roof_steps(kMostBend_m)) return false;
        levels.join(cover.mesh.corner(t, k + (is_first ? 1 : 2)), low, high);
        has_changed = true;
      }
    }
  }
  return true;
}

/// Mesh points where two steps stand on one upright edge, the same side of it: high and low roofs meet there like
/// fields of a chessboard. The solid would only touch itself in that edge.
std::vector<std::uint32_t> pinches(const PlanCover& cover, const Levels& levels, std::int32_t eave) {
  std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>> rises(cover.mesh.points.size());
  for (std::uint32_t t = 0; t < cover.face.size(); ++t) {
    if (cover.face[t] == kNone) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t n = cover.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
      const bool is_rim = n == kNone || cover.face[n] == kNone;
      const int m = is_rim ? 0 : cover.mesh.twin_side(t, k);
      const auto add = [&](int mine, int its) {
        const std::int32_t low = is_rim ? eave : levels.up(n, its), high = levels.up(t, mine);
        if (low < high) rises[cover.mesh.corner(t, mine)].emplace_back(low, high);
      };
      add(k + 1, m + 2);  // only there the edge begins: seen from the point, each edge is met once from each side
    }
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; v < rises.size(); ++v) {
    auto& list = rises[v];
    std::sort(list.begin(), list.end());
    for (std::size_t i = 1; i < list.size(); ++i)
      if (list[i].first < list[i - 1].second) {
        out.push_back(v);
        break;
      } else if (list[i].second < list[i - 1].second) {
        list[i].second = list[i - 1].second;
      }
  }
  return out;
}

class RoofWriter {
 public:
  RoofWriter(const PlanCover& cover, const Levels& levels, std::int32_t eave)
      : cover_(cover), levels_(levels), eave_(eave) {}

  Roof write() {
    add_tops();
    add_steps();
    for (const auto& chain : cover_.chains) add_gable(chain);
    triangulate_facets(roof_);
    return std::move(roof_);
  }

 private:
  using Side = std::pair<std::uint32_t, int>;  // triangle, side

  std::uint32_t point(std::uint32_t v, std::int32_t up) {
    const auto [at, is_new] = index_.try_emplace({v, up}, static_cast<std::uint32_t>(roof_.points.size()));
    if (is_new) roof_.points.push_back({cover_.mesh.points[v], up});
    return at->second;
  }
  std::uint32_t corner(std::uint32_t t, int k) { return point(cover_.mesh.corner(t, k), levels_.up(t, k)); }

  /// Do both triangles lie in one facet across the side?
  bool is_joined(std::uint32_t t, int k) const {
    const std::uint32_t n = cover_.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
    if (n == kNone || cover_.face[n] != cover_.face[t]) return false;
    const int m = cover_.mesh.twin_side(t, k);
    return levels_.up(t, k + 1) == levels_.up(n, m + 2) && levels_.up(t, k + 2) == levels_.up(n, m + 1);
  }

  void add_tops() {
    std::vector<char> is_done(cover_.face.size(), 0);
    for (std::uint32_t first = 0; first < cover_.face.size(); ++first) {
      if (cover_.face[first] == kNone || is_done[first]) continue;
      std::vector<std::uint32_t> region = {first};
      is_done[first] = 1;
      for (std::size_t i = 0; i < region.size(); ++i)
        for (int k = 0; k < 3; ++k)
          if (is_joined(region[i], k))
            if (const std::uint32_t n = cover_.mesh.triangles[region[i]].neighbour[static_cast<std::size_t>(k)];
                !is_done[n])
              is_done[n] = 1, region.push_back(n);
      if (!add_region(region))
        for (const std::uint32_t t : region) add_facet({{corner(t, 0), corner(t, 1), corner(t, 2)}});
    }
  }

  void add_facet(std::vector<std::vector<std::uint32_t>> rings) {
    RoofFacet facet{FacetKind::top, std::move(rings), {}};
    for (const auto& ring : facet.rings)
      for (const std::uint32_t i : ring)
        if (roof_.points[i].up != roof_.points[facet.rings[0][0]].up) facet.kind = FacetKind::slope;
    roof_.facets.push_back(std::move(facet));
  }

  /// The region as one facet; false where it is not planar or its rim passes a point twice.
  bool add_region(const std::vector<std::uint32_t>& region) {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const std::uint32_t t : region)
      for (int k = 0; k < 3; ++k)
        if (!is_joined(t, k) && !next.emplace(corner(t, k + 1), corner(t, k + 2)).second) return false;
    std::vector<std::vector<std::uint32_t>> rings;
    while (!next.empty()) {
      rings.emplace_back();
      for (auto at = next.begin(); at != next.end(); at = next.find(rings.back().back())) {
        rings.back().push_back(at->second);
        next.erase(at);
      }
    }
    const auto area = [&](const auto& ring) {
      std::int64_t sum = 0;
      const PlanPoint o = roof_.points[ring[0]].at;
      for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum += orient(o, roof_.points[ring[i]].at, roof_.points[ring[i + 1]].at);
      return sum;
    };
    std::stable_sort(rings.begin(), rings.end(), [&](const auto& a, const auto& b) { return area(a) > area(b); });
    if (rings.size() > 1 && area(rings[1]) > 0) return false;
    if (off_plane_m(roof_, {FacetKind::slope, rings, {}}) >= kMostOffPlane_m / 2) return false;
    add_facet(std::move(rings));
    return true;
  }

  /// Levels strictly between, in the order of from -> to.
  void add_between(std::uint32_t v, std::int32_t from, std::int32_t to, std::vector<std::uint32_t>& ring) {
    std::set<std::int32_t> between;
    for (const std::int32_t h : levels_.at(v))
      if (h > std::min(from, to) && h < std::max(from, to)) between.insert(h);
    if (from < to)
      for (auto h = between.begin(); h != between.end(); ++h) ring.push_back(point(v, *h));
    else
      for (auto h = between.rbegin(); h != between.rend(); ++h) ring.push_back(point(v, *h));
  }

  /// Upright faces above inner edges, from the lower triangle's edge a -> b (higher triangle on the left) up to the
  /// higher one's.
  void add_steps() {
    for (std::uint32_t t = 0; t < cover_.face.size(); ++t) {
      if (cover_.face[t] == kNone) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t n = cover_.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
        if (n == kNone || cover_.face[n] == kNone) continue;
        const int m = cover_.mesh.twin_side(t, k);
        const std::uint32_t a = cover_.mesh.corner(t, k + 1), b = cover_.mesh.corner(t, k + 2);
        const std::int32_t high_a = levels_.up(t, k + 1), high_b = levels_.up(t, k + 2), low_a = levels_.up(n, m + 2),
                           low_b = levels_.up(n, m + 1);
        add_step(a, b, {low_a, low_b}, {high_a, high_b});
      }
    }
  }

  using Ends = std::array<std::int32_t, 2>;

  void add_step(std::uint32_t a, std::uint32_t b, Ends low, Ends high) {
    if (high[0] < low[0] || high[1] < low[1] || (high[0] == low[0] && high[1] == low[1])) return;
    std::vector<std::uint32_t> ring = {point(a, low[0]), point(b, low[1])};
    add_between(b, low[1], high[1], ring);
    if (high[1] != low[1]) ring.push_back(point(b, high[1]));
    if (high[0] != low[0]) ring.push_back(point(a, high[0]));
    add_between(a, high[0], low[0], ring);
    roof_.facets.push_back({FacetKind::step, {std::move(ring)}, {}});
  }

  Side triangle_on(std::uint32_t a, std::uint32_t b) {
    if (sides_.empty())
      for (std::uint32_t t = 0; t < cover_.face.size(); ++t)
        if (cover_.face[t] != kNone)
          for (int k = 0; k < 3; ++k) sides_[{cover_.mesh.corner(t, k + 1), cover_.mesh.corner(t, k + 2)}] = {t, k};
    return sides_.at({a, b});
  }

  /// From the eave up to the roof, over one edge of the footprint.
  void add_gable(const std::vector<std::uint32_t>& chain) {
    const std::uint32_t a = chain.front(), b = chain.back();
    std::vector<std::uint32_t> ring = {point(a, eave_), point(b, eave_)};
    std::int32_t up = eave_;
    std::uint32_t last = b;
    const auto rise = [&](std::uint32_t v, std::int32_t to) {
      if (v == last) add_between(v, up, to, ring);
      last = v;
      if (const std::uint32_t p = point(v, to); p != ring.back() && p != ring.front()) ring.push_back(p);
      up = to;
    };
    for (std::size_t i = chain.size() - 1; i > 0; --i) {
      const auto [t, k] = triangle_on(chain[i - 1], chain[i]);
      rise(chain[i], levels_.up(t, k + 2));
      rise(chain[i - 1], levels_.up(t, k + 1));
    }
    rise(a, eave_);
    if (ring.size() <= 2) return;
    if (off_plane_m(roof_, {FacetKind::gable, {ring}, {}}) < kMostOffPlane_m || !add_folded_gable(chain))
      roof_.facets.push_back({FacetKind::gable, {std::move(ring)}, {}});
  }

  /// Where the roof's rim stands back from the footprint's edge by a millimetre or two here and there: a ledge at the
  /// eave, and steps along the rim. False: it meets the edge between its ends.
  bool add_folded_gable(const std::vector<std::uint32_t>& chain) {
    const PlanPoint a = cover_.mesh.points[chain.front()], b = cover_.mesh.points[chain.back()];
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
      if (orient(a, b, cover_.mesh.points[chain[i]]) <= 0) return false;
    std::vector<std::uint32_t> ledge = {point(chain.front(), eave_)};
    for (std::size_t i = chain.size() - 1; i > 0; --i) ledge.push_back(point(chain[i], eave_));
    add_facet({std::move(ledge)});
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const auto [t, k] = triangle_on(chain[i], chain[i + 1]);
      add_step(chain[i], chain[i + 1], {eave_, eave_}, {levels_.up(t, k + 1), levels_.up(t, k + 2)});
    }
    return true;
  }

  const PlanCover& cover_;
  const Levels& levels_;
  const std::int32_t eave_;
  Roof roof_;
  std::map<std::pair<std::uint32_t, std::int32_t>, std::uint32_t> index_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Side> sides_;
};

/// The lowest point of the roof's rim if all can rise from there; else a lip below it.
std::int32_t eave_of(const PlanCover& cover, Levels& levels) {
  std::int32_t lowest = INT32_MAX;
  for (const auto& chain : cover.chains)
    for (const std::uint32_t v : chain) lowest = std::min(lowest, levels.at(v).front());
  lowest = static_cast<std::int32_t>(std::floor(lowest / 10.0)) * 10;  // walls end at whole millimetres
  for (const auto& chain : cover.chains)
    for (const std::uint32_t v : chain) levels.pull(v, lowest, roof_steps(kJoin_m / 2));
  const bool is_clear = std::all_of(cover.chains.begin(), cover.chains.end(), [&](const auto& chain) {
    return std::all_of(chain.begin() + 1, chain.end() - 1, [&](auto v) { return levels.at(v).front() > lowest; });
  });
  return is_clear ? lowest : lowest - roof_steps(kLip_m);
}

/// One try. `cuts` and `pinched` grow where the next one would do better; `is_final`: there is none.
std::optional<ImportedRoof> try_roof(const Polygon& footprint, const HouseModel& model, bool is_final,
                                     std::vector<Segment>& cuts, std::set<PlanPoint>& pinched, std::string& fault) {
  const PlanCover cover = cover_plan(footprint, model, cuts);
  if (cover.covered < kLeastCover) {
    fault = "it covers only " + std::to_string(static_cast<int>(100 * cover.covered)) + " % of the footprint";
    return std::nullopt;
  }
  if (!is_final)
    if (const auto more = crossing_cuts(cover, kMostBend_m); !more.empty()) {
      cuts.insert(cuts.end(), more.begin(), more.end());
      return std::nullopt;
    }
  Levels levels(cover);
  std::int32_t eave = eave_of(cover, levels);
  if (!uncross(cover, levels)) {
    fault = "two of its faces cross";
    return std::nullopt;
  }
  for (std::uint32_t v = 0; v < cover.mesh.points.size(); ++v)
    if (pinched.contains(cover.mesh.points[v]) && !levels.at(v).empty())
      levels.join(v, levels.at(v).front(), levels.at(v).back());
  eave = std::min(eave, levels.lowest());
  if (eave < roof_steps(kLeastEave_m)) {
    fault = "it comes down to the ground";
    return std::nullopt;
  }
  if (!is_final) {
    const std::size_t before = cuts.size();
    for (const std::uint32_t v : pinches(cover, levels, eave))
      if (const PlanPoint p = cover.mesh.points[v]; pinched.insert(p).second)
        for (const Segment& s : lozenge(p, kNotch_mm)) cuts.push_back(s);
    if (cuts.size() > before) return std::nullopt;
  }
  ImportedRoof out;
  out.roof = RoofWriter(cover, levels, eave).write();
  out.eave_m = eave / kRoofStepsPerMetre;
  out.is_level = std::none_of(out.roof.facets.begin(), out.roof.facets.end(),
                              [](const RoofFacet& f) { return f.kind == FacetKind::slope; });
  if (auto found = fault_of_roof(footprint, out.eave_m, out.roof)) {
    fault = *found;
    return std::nullopt;
  }
  return out;
}

}  // namespace

std::optional<ImportedRoof> roof_from_model(const Polygon& footprint, const HouseModel& model, std::string& fault) {
  if (model.tops.size() > kMostFaces) {
    fault = "it has more than " + std::to_string(kMostFaces) + " faces";
    return std::nullopt;
  }
  std::vector<Segment> cuts;
  std::set<PlanPoint> pinched;
  for (int round = 0;; ++round) {
    const std::size_t before = cuts.size();
    auto out = try_roof(footprint, model, round == 2 * kMostCuts, cuts, pinched, fault);
    if (out || cuts.size() == before) return out;
  }
}

}  // namespace vicus
