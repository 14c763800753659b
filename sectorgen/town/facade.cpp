#include "sectorgen/town/facade.hpp"

#include <algorithm>

#include "sectorgen/town/random.hpp"

namespace vicus::town {

namespace {

constexpr double kReach = 40;  // m by which a side is prolonged to find its corner

struct Cut {
  std::size_t segment = 0;
  double t = 0;
  Vec at;
};

struct RawSide {
  Polyline offset;  ///< prolonged at both ends
  Cut first, last;
  std::size_t line = 0;
  bool is_left = true;
};

Polyline centre_of(const Network& n, HalfEdge h) {
  Polyline line = n.edges[h.edge].centre;
  if (!h.is_forward) std::reverse(line.begin(), line.end());
  return line;
}

void prolong(Polyline& line) {
  const std::size_t last = line.size() - 1;
  line.insert(line.begin(), line[0] + unit(line[0] - line[1]) * kReach);
  line.push_back(line[last + 1] + unit(line[last + 1] - line[last]) * kReach);
}

bool find_corner(RawSide& a, RawSide& b) {
  for (std::size_t j = 1; j < b.offset.size(); ++j)
    for (std::size_t i = a.offset.size() - 1; i > 0; --i) {
      const Vec p = a.offset[i - 1], q = a.offset[i], r = b.offset[j - 1], s = b.offset[j];
      if (!segments_meet(p, q, r, s)) continue;
      const auto t = meeting_on_line(p, q, r, s), u = meeting_on_line(r, s, p, q);
      if (!t || !u) return false;
      const Vec at = mix(p, q, *t);
      a.last = {i - 1, *t, at};
      b.first = {j - 1, *u, at};
      return true;
    }
  return false;
}

/// Along the straight line that the street was before it was bent; the bend moves a place by less than a block.
double chainage(const Line& line, Vec p) {
  const Vec d = line.to - line.from;
  return std::clamp(dot(p - line.from, d) / dot(d, d), 0.0, 1.0) * length(d);
}

}  // namespace

std::vector<Side> facade_sides(const Network& n, std::size_t face, const Setback& setback, std::uint64_t seed) {
  const auto& ring = n.faces[face].ring;
  std::size_t start = 0;  // a true corner
  while (start < ring.size() &&
         n.edges[ring[start].edge].line == n.edges[ring[(start + ring.size() - 1) % ring.size()].edge].line)
    ++start;
  if (start == ring.size()) return {};
  Rng rng(seed);
  std::vector<RawSide> raw;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const HalfEdge h = ring[(start + k) % ring.size()];
    const std::size_t line = n.edges[h.edge].line;
    if (raw.empty() || raw.back().line != line) {
      raw.emplace_back();
      raw.back().line = line;
      raw.back().is_left = h.is_forward;
    }
    Polyline centre = centre_of(n, h);
    auto& all = raw.back().offset;
    all.insert(all.end(), centre.begin() + (all.empty() ? 0 : 1), centre.end());
  }
  for (RawSide& r : raw) {
    const Line& line = n.lines[r.line];
    double by = line.half_width;
    if (line.kind != StreetKind::lane && line.kind != StreetKind::border) by += setback.jitter * rng.unit();
    if (line.has_wall && r.is_left) by += setback.wall;
    r.offset = offset_left(r.offset, by);
    prolong(r.offset);
  }
  std::vector<Side> sides;
  for (std::size_t i = 0; i < raw.size(); ++i)
    if (!find_corner(raw[i], raw[(i + 1) % raw.size()])) return {};
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const RawSide& r = raw[i];
    const auto where = [](const Cut& c) { return static_cast<double>(c.segment) + c.t; };
    if (where(r.first) >= where(r.last)) return {};
    Side side;
    side.line = r.line;
    side.is_left = r.is_left;
    side.front.push_back(r.first.at);
    for (std::size_t k = r.first.segment + 1; k <= r.last.segment; ++k)
      if (distance(r.offset[k], side.front.back()) > 0.5 && distance(r.offset[k], r.last.at) > 0.5)
        side.front.push_back(r.offset[k]);
    side.front.push_back(r.last.at);
    side.first_m = chainage(n.lines[r.line], r.first.at);
    side.last_m = chainage(n.lines[r.line], r.last.at);
    sides.push_back(std::move(side));
  }
  return sides;
}

Ring ring_of(const std::vector<Side>& sides) {
  Ring ring;
  for (const Side& s : sides) ring.insert(ring.end(), s.front.begin(), s.front.end() - 1);
  return ring;
}

}  // namespace vicus::town
