#include <algorithm>

#include "sectorgen/town/site.hpp"

namespace vicus::town {

namespace {

/// The block's ring beginning with the side of the door, so that an entrance in the first wall is in the front; the
/// passage's node in its middle.
Ring walls_from(const std::vector<Side>& sides, std::size_t door, const Vec* passage) {
  const Polyline& front = sides[door].front;
  const double half = length_of(front) / 2;
  Ring ring{front[0]};
  double walked = 0;
  for (std::size_t i = 1; i < front.size(); ++i) {
    const double before = walked;
    walked += distance(front[i - 1], front[i]);
    if (passage && before < half && half <= walked) ring.push_back(*passage);
    ring.push_back(front[i]);
  }
  ring.pop_back();
  for (std::size_t k = 1; k < sides.size(); ++k) {
    const Polyline& other = sides[(door + k) % sides.size()].front;
    ring.insert(ring.end(), other.begin(), other.end() - 1);
  }
  return ring;
}

/// court[i] lies behind corners[i + 1]; empty when the block is too small.
Ring court_behind(const Ring& corners, const Ring& walls) {
  Polyline closed = corners;
  closed.insert(closed.end(), corners.begin(), corners.begin() + 2);
  for (double depth = 11; depth > 6.5; --depth) {
    const Polyline inset = offset_left(closed, depth);
    const Ring court(inset.begin() + 1, inset.end() - 1);
    if (is_simple(walls) && is_simple(court) && area_of(court) > 60 &&
        std::all_of(court.begin(), court.end(), [&](Vec p) { return contains_with_margin(walls, p, 5); }))
      return court;
  }
  return {};
}

}  // namespace

/// One house around a court of its own, entered by a passage from its longest side.
void build_palace(Site& site, std::size_t face) {
  const auto sides = facade_sides(site.network, face, {0.5, kWallSetback}, site.rng.next());
  const std::size_t n = sides.size();
  Ring corners;
  for (const Side& s : sides) corners.push_back(s.front.front());
  if (n < 3) return;
  const Ring court = court_behind(corners, ring_of(sides));
  if (court.empty()) {
    build_rows(site, sides, face);
    return;
  }
  std::size_t door = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (site.network.lines[sides[i].line].kind != StreetKind::avenue && !is_walled(site.network, sides[i]) &&
        length_of(sides[i].front) > length_of(sides[door].front))
      door = i;
  const Polyline& front = sides[door].front;
  Vec forward;
  Passage p;
  p.outer = point_along(front, length_of(front) / 2, &forward);
  p.inward = left_of(forward);
  p.line = sides[door].line;
  const Vec a = court[(door + n - 1) % n], b = court[door];
  const auto t = meeting_on_line(a, b, p.outer, p.outer + p.inward);
  const bool has_passage = t && *t > 0.1 && *t < 0.9;
  const Ring outer = walls_from(sides, door, has_passage ? &p.outer : nullptr);
  Ring well = court;
  if (has_passage) {
    p.inner = mix(a, b, *t);
    well.insert(well.begin() + static_cast<std::ptrdiff_t>((door + n - 1) % n) + 1, p.inner);
  }
  if (!build_house(site, outer, {p.line, 1, true, true}, well) || !has_passage) return;
  site.sights |= kPalace;
  lay_out_courtyard(site, court, {p}, face);
}

}  // namespace vicus::town
