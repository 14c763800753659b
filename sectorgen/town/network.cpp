#include "sectorgen/town/network.hpp"

#include <algorithm>

#include "sectorgen/town/random.hpp"

namespace vicus::town {

namespace {

constexpr double kBendStep = 13;  // m between the points of a bent street

/// Where the cutting line meets a face: an existing vertex of its ring, or a place on one of its edges.
struct Hit {
  std::size_t index = 0;  ///< ring position of the edge, or of the vertex when is_vertex
  bool is_vertex = false;
  Vec at;
};

bool is_junction_inside_side(const Network& n, const Face& f, std::size_t i) {
  const HalfEdge before = f.ring[(i + f.ring.size() - 1) % f.ring.size()];
  return n.edges[before.edge].line == n.edges[f.ring[i].edge].line;
}

std::optional<Hit> settle_hit(const Network& n, const Face& f, std::size_t i, Vec at, const CutRules& rules) {
  const std::size_t size = f.ring.size();
  std::optional<Hit> best;
  double nearest = 1e30, nearest_snap = rules.snap;
  // Vertices of the same side only: those of other sides are far from a convex ring's crossing or forbid it below.
  for (std::size_t k = 0; k < size; ++k) {
    const Vec v = n.vertices[n.start_of(f.ring[k])];
    const double d = distance(v, at);
    nearest = std::min(nearest, d);
    const bool is_on_side = n.edges[f.ring[k].edge].line == n.edges[f.ring[i].edge].line;
    if (is_on_side && is_junction_inside_side(n, f, k) && d <= nearest_snap) nearest_snap = d, best = Hit{k, true, v};
  }
  if (best) return best;
  if (nearest < rules.clear) return std::nullopt;
  return Hit{i, false, at};
}

bool is_steep(const Network& n, const Face& f, const Hit& hit, Vec along, double min_sine) {
  const Edge& e = n.edges[f.ring[hit.index].edge];
  const Vec side = unit(n.vertices[e.to] - n.vertices[e.from]);
  const double s = cross(side, along);
  return s * s >= min_sine * min_sine;
}

/// Splits the edge at ring position i of face f, in both faces; returns the new vertex.
std::size_t split_edge(Network& n, std::size_t edge, Vec at) {
  n.vertices.push_back(at);
  const std::size_t v = n.vertices.size() - 1, fresh = n.edges.size();
  Edge rest = n.edges[edge];
  rest.from = v;
  n.edges[edge].to = v;
  n.edges.push_back(rest);
  for (const std::size_t face : {rest.left, rest.right}) {
    if (face == Edge::kNoFace) continue;
    auto& ring = n.faces[face].ring;
    const auto it = std::find_if(ring.begin(), ring.end(), [&](HalfEdge h) { return h.edge == edge; });
    const HalfEdge added{fresh, it->is_forward};
    ring.insert(it->is_forward ? it + 1 : it, added);
  }
  return v;
}

std::size_t position_of(const Network& n, const Face& f, std::size_t vertex) {
  for (std::size_t i = 0; i < f.ring.size(); ++i)
    if (n.start_of(f.ring[i]) == vertex) return i;
  return f.ring.size();
}

bool parts_are_wide(const Network& n, const Face& f, const Hit& in, const Hit& out, double min_width) {
  Ring left, right;  // `in`: where the line enters the face; left of the line lies what follows `out`
  const std::size_t size = f.ring.size();
  const auto collect = [&](Ring& ring, const Hit& a, const Hit& b) {
    ring.push_back(a.at);
    for (std::size_t k = (a.index + 1) % size;; k = (k + 1) % size) {
      if (b.is_vertex && k == b.index) break;
      ring.push_back(n.vertices[n.start_of(f.ring[k])]);
      if (!b.is_vertex && k == b.index) break;
    }
    ring.push_back(b.at);
  };
  collect(left, out, in);
  collect(right, in, out);
  Vec along;
  return area_of(left) > 0 && area_of(right) > 0 && width_of_convex(left, along) >= min_width &&
         width_of_convex(right, along) >= min_width;
}

void divide(Network& n, std::size_t face, std::size_t in, std::size_t out, const Line& line) {
  const std::size_t fresh = n.faces.size(), edge = n.edges.size();
  n.lines.push_back(line);
  n.lines.back().from = n.vertices[in];
  n.lines.back().to = n.vertices[out];
  n.faces.push_back(n.faces[face]);
  Edge e;
  e.from = in, e.to = out, e.line = n.lines.size() - 1, e.left = face, e.right = fresh;
  n.edges.push_back(e);
  const std::vector<HalfEdge> old = n.faces[face].ring;
  const std::size_t i = position_of(n, n.faces[face], in), o = position_of(n, n.faces[face], out);
  auto& left = n.faces[face].ring;
  auto& right = n.faces[fresh].ring;
  left.assign(1, {edge, true});
  right.assign(1, {edge, false});
  for (std::size_t k = o; k != i; k = (k + 1) % old.size()) left.push_back(old[k]);
  for (std::size_t k = i; k != o; k = (k + 1) % old.size()) right.push_back(old[k]);
  for (const HalfEdge h : right) (h.is_forward ? n.edges[h.edge].left : n.edges[h.edge].right) = fresh;
}

}  // namespace

Ring Network::ring_of(std::size_t face) const {
  Ring ring;
  for (const HalfEdge h : faces[face].ring) ring.push_back(vertices[start_of(h)]);
  return ring;
}

Network make_network(const Ring& ring, const std::vector<Line>& lines) {
  Network n;
  n.vertices = ring;
  n.lines = lines;
  n.faces.emplace_back();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Edge e;
    e.from = i, e.to = (i + 1) % ring.size(), e.line = i, e.left = 0;
    n.lines[i].from = ring[i];
    n.lines[i].to = ring[e.to];
    n.edges.push_back(e);
    n.faces[0].ring.push_back({i, true});
  }
  return n;
}

bool cut_face(Network& n, std::size_t face, Vec at, Vec along, const Line& line, const CutRules& rules) {
  const Face& f = n.faces[face];
  const Vec end = at + along;
  std::optional<Hit> in, out;
  for (std::size_t i = 0; i < f.ring.size(); ++i) {
    const Vec a = n.vertices[n.start_of(f.ring[i])];
    const Vec b = n.vertices[n.start_of(f.ring[(i + 1) % f.ring.size()])];
    const double sa = cross(along, a - at), sb = cross(along, b - at);
    if ((sa > 0) == (sb > 0)) continue;
    const auto t = meeting_on_line(a, b, at, end);
    if (!t || *t <= 1e-3 || *t >= 1 - 1e-3) return false;
    auto& hit = sa > 0 ? in : out;  // counter-clockwise: the ring passes from left to right where the line enters
    hit = settle_hit(n, f, i, mix(a, b, *t), rules);
    if (!hit) return false;
  }
  if (!in || !out || distance(in->at, out->at) < 1) return false;
  const Vec settled = unit(out->at - in->at);
  if (!is_steep(n, f, *in, settled, rules.min_sine) || !is_steep(n, f, *out, settled, rules.min_sine)) return false;
  if (!parts_are_wide(n, f, *in, *out, rules.min_width)) return false;
  const std::size_t edge_in = f.ring[in->index].edge, edge_out = f.ring[out->index].edge;
  const std::size_t vertex_in = in->is_vertex ? n.start_of(f.ring[in->index]) : Edge::kNoFace;
  const std::size_t vertex_out = out->is_vertex ? n.start_of(f.ring[out->index]) : Edge::kNoFace;
  const std::size_t a = in->is_vertex ? vertex_in : split_edge(n, edge_in, in->at);
  const std::size_t b = out->is_vertex ? vertex_out : split_edge(n, edge_out, out->at);
  divide(n, face, a, b, line);
  return true;
}

Bend::Bend(double amplitude, std::uint64_t seed) {
  Rng rng(seed);
  // Long waves bend whole streets, short ones give them their wobble; curvature stays above a radius of about 60 m.
  constexpr double kWavelength[] = {900, 520, 310, 210, 150, 120}, kShare[] = {1.6, 1.1, 0.8, 0.45, 0.25, 0.12};
  for (std::size_t i = 0; i < 6; ++i) {
    const Vec towards = direction_of_turn(rng.unit()), shift = direction_of_turn(rng.unit());
    waves_.push_back({towards * (1 / kWavelength[i]), shift * (amplitude * kShare[i]), rng.unit()});
  }
}

Vec Bend::operator()(Vec p) const {
  Vec moved = p;
  for (const Wave& w : waves_) moved = moved + w.shift * sine_of_turn(dot(w.towards, p) + w.phase);
  return moved;
}

void bend_network(Network& n, const Bend& bend) {
  for (Edge& e : n.edges) {
    const Vec a = n.vertices[e.from], b = n.vertices[e.to];
    const auto steps = static_cast<std::size_t>(distance(a, b) / kBendStep) + 1;
    for (std::size_t i = 0; i <= steps; ++i)
      e.centre.push_back(bend(i == 0       ? a
                              : i == steps ? b
                                           : mix(a, b, static_cast<double>(i) / static_cast<double>(steps))));
  }
  n.straight = n.vertices;
  for (Vec& v : n.vertices) v = bend(v);
}

NodeId join_street(Network& n, OsmMap& map, std::size_t face, std::size_t line, Vec p) {
  double best = 1e30;
  Edge* edge = nullptr;
  Junction found;
  Vec place;
  for (const HalfEdge h : n.faces[face].ring) {
    Edge& e = n.edges[h.edge];
    if (e.line != line) continue;
    double before = 0;
    for (std::size_t i = 1; i < e.centre.size(); ++i) {
      const Vec a = e.centre[i - 1], b = e.centre[i];
      const double step = distance(a, b), t = std::clamp(dot(p - a, b - a) / (step * step), 0.0, 1.0);
      const double d = distance(p, mix(a, b, t));
      if (d < best) best = d, edge = &e, place = mix(a, b, t), found.at = before + step * t;
      before += step;
    }
  }
  found.node = map.node(place);
  edge->junctions.push_back(found);
  return found.node;
}

}  // namespace vicus::town
