#include "city_db/rules_plane.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "city_db/rules_sets.hpp"

namespace vicus::rules {
namespace {

/// Adds the edge's own step from its right side to its left.
void step_to_left(Cover& cover, std::span<const EdgeUse> uses) {
  for (const auto& use : uses) {
    const std::int32_t step = use.forward ? 1 : -1;
    if (use.layer == Layer::domain) cover.domain += step;
    if (use.layer == Layer::sector) cover.sectors += step;
    if (use.layer == Layer::building || use.layer == Layer::obstacle) cover.blocks += step;
  }
}

/// Below before above, for edges whose x ranges meet and which do not cross.
struct LowerEdge {
  using is_transparent = void;
  const std::vector<Edge>* edges;
  bool operator()(std::uint32_t a, std::uint32_t b) const {
    const Edge &ea = (*edges)[a], &eb = (*edges)[b];
    if (ea.lo == eb.lo) return orient(ea.lo, ea.hi, eb.hi) > 0;
    if (ea.lo < eb.lo) return orient(ea.lo, ea.hi, eb.lo) > 0;
    return orient(eb.lo, eb.hi, ea.lo) < 0;
  }
  bool operator()(std::uint32_t a, PlanPoint p) const { return orient((*edges)[a].lo, (*edges)[a].hi, p) > 0; }
};

/// The sweep line and what it has found so far.
class Sweep {
 public:
  explicit Sweep(const EdgeTable& table)
      : table_(table),
        outer_(static_cast<std::uint32_t>(2 * table.edges.size())),
        status_(LowerEdge{&table.edges}),
        place_(table.edges.size()),
        sides_(2 * table.edges.size() + 1) {
    plane_.left.resize(table.edges.size());
    plane_.right.resize(table.edges.size());
  }

  Plane run() {
    std::vector<std::uint32_t> starts, ends;
    for (std::uint32_t e = 0; e < table_.edges.size(); ++e)
      if (table_.has_ring(e)) starts.push_back(e);
    ends = starts;
    const auto& edges = table_.edges;
    std::sort(ends.begin(), ends.end(), [&](auto a, auto b) { return edges[a].hi < edges[b].hi; });
    std::vector<std::uint32_t> west, east;
    for (std::size_t s = 0, t = 0; t < ends.size();) {
      const PlanPoint p = s < starts.size() ? std::min(edges[starts[s]].lo, edges[ends[t]].hi) : edges[ends[t]].hi;
      west.clear(), east.clear();
      while (t < ends.size() && edges[ends[t]].hi == p) west.push_back(ends[t++]);
      while (s < starts.size() && edges[starts[s]].lo == p) east.push_back(starts[s++]);
      pass_vertex(p, west, east);
    }
    name_faces();
    return std::move(plane_);
  }

 private:
  std::uint32_t above(std::uint32_t e) const { return 2 * e; }
  std::uint32_t below(std::uint32_t e) const { return 2 * e + 1; }

  ///  west edges end at p, east edges begin there; both lists from below to above
  ///
  ///     \ west[1]  / east[1]
  ///       ------ p ------ east[0]        the face under p is the one above `under`
  ///     / west[0]
  ///  ------------------------------ under
  void pass_vertex(PlanPoint p, std::vector<std::uint32_t>& west, std::vector<std::uint32_t>& east) {
    const auto& edges = table_.edges;
    std::sort(west.begin(), west.end(), [&](auto a, auto b) { return orient(edges[b].lo, p, edges[a].lo) < 0; });
    std::sort(east.begin(), east.end(), [&](auto a, auto b) { return orient(p, edges[a].hi, edges[b].hi) > 0; });
    auto over = west.empty() ? status_.lower_bound(p) : place_[west.front()];
    const bool has_under = over != status_.begin();
    const std::uint32_t under = has_under ? *std::prev(over) : 0;
    for (const auto e : west) over = status_.erase(place_[e]);

    Cover cover = has_under ? plane_.left[under] : Cover{};
    std::uint32_t face = has_under ? above(under) : outer_;
    for (const auto e : east) {
      plane_.right[e] = cover;
      step_to_left(cover, table_.uses_of(e));
      plane_.left[e] = cover;
      sides_.unite(face, below(e));
      face = above(e);
      place_[e] = status_.emplace_hint(over, e);
    }
    // Round the vertex on the west side; the first and last wedge are shared with the east side.
    std::uint32_t west_face = has_under ? above(under) : outer_;
    for (const auto e : west) {
      sides_.unite(west_face, below(e));
      west_face = above(e);
    }
    sides_.unite(face, west_face);
  }

  void name_faces() {
    const auto& edges = table_.edges;
    std::vector<std::uint32_t> name(2 * edges.size() + 1, 0);
    std::uint32_t count = 1;
    const std::uint32_t unbounded = sides_.find(outer_);
    const auto face_of = [&](std::uint32_t side, const Cover& cover) {
      const std::uint32_t root = sides_.find(side);
      if (root == unbounded) return 0u;
      if (name[root] == 0) {
        name[root] = count++;
        plane_.face_covers.push_back(cover);
      }
      return name[root];
    };
    plane_.face_covers = {Cover{}};
    plane_.left_face.assign(edges.size(), 0);
    plane_.right_face.assign(edges.size(), 0);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (!table_.has_ring(e)) continue;
      plane_.left_face[e] = face_of(above(e), plane_.left[e]);
      plane_.right_face[e] = face_of(below(e), plane_.right[e]);
    }
    plane_.face_twice_mm2.assign(count, 0);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      plane_.face_twice_mm2[plane_.left_face[e]] += cross(edges[e].lo, edges[e].hi);
      plane_.face_twice_mm2[plane_.right_face[e]] -= cross(edges[e].lo, edges[e].hi);
    }
    plane_.is_noded = true;
  }

  const EdgeTable& table_;
  std::uint32_t outer_;
  std::set<std::uint32_t, LowerEdge> status_;
  std::vector<std::set<std::uint32_t, LowerEdge>::iterator> place_;
  DisjointSets sides_;
  Plane plane_;
};

}  // namespace

Plane plane_of_faces(const EdgeTable& table) { return Sweep(table).run(); }

Plane plane_of_rings(const EdgeTable& table) {
  Plane plane;
  plane.left.resize(table.edges.size());
  plane.right.resize(table.edges.size());
  for (std::size_t e = 0; e < table.edges.size(); ++e) {
    bool on_rim = false;
    for (const auto& use : table.uses_of(e)) {
      Cover& inside = use.forward ? plane.left[e] : plane.right[e];
      if (use.layer == Layer::domain) on_rim = true, ++inside.domain;
      if (use.layer == Layer::sector) ++inside.sectors;
      if (use.layer == Layer::building || use.layer == Layer::obstacle) ++inside.blocks;
    }
    for (Cover* side : {&plane.left[e], &plane.right[e]})
      if (!on_rim && side->sectors + side->blocks > 0) side->domain = 1;
  }
  return plane;
}

}  // namespace vicus::rules
