#include <algorithm>
#include <optional>

#include "sectorgen/town/site.hpp"

/// Market with church, the angular second square with its island.
namespace vicus::town {

namespace {

constexpr double kPavement = 0.4;  // m between a square and houses that are built with it

void add_square(Site& site, const Ring& ring, const std::string& name) {
  Tags tags{{"place", "square"}, {"name", name}};
  if (!site.features.no_streets) {
    tags.insert(tags.end(), {{"highway", "pedestrian"}, {"area", "yes"}, {"surface", "sett"}});
    ++site.counts.streets;
  }
  site.map.closed_way(site.map.nodes_of(ring), std::move(tags));
}

void put(Site& site, const Ring& ring, const Ring& keep_out, Vec at, Tags tags) {
  if (contains_with_margin(ring, at, 1.5) && (keep_out.empty() || !contains(keep_out, at)))
    site.map.point(at, std::move(tags));
}

/// Direction of the ring's longest side.
Vec long_axis(const Ring& ring) {
  Vec best;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (length(ring[i] - ring[j]) > length(best)) best = ring[i] - ring[j];
  return unit(best);
}

void furnish_market(Site& site, const Ring& ring, Vec c, Vec u, Vec v, double hx, double hy, const Ring& church) {
  put(site, ring, church, c - v * (hy * 0.35) - u * (hx * 0.3), {{"amenity", "fountain"}, {"name", "Röhrbrunnen"}});
  put(site, ring, church, c - v * (hy * 0.35) + u * (hx * 0.35),
      {{"historic", "memorial"}, {"memorial", "statue"}, {"name", "Das Mädchen mit dem Krug"}, {"height", "6"}});
  for (int i = -3; i <= 3; ++i) {
    const Vec row = c - v * (hy * 0.78) + u * (hx * 0.24 * i);
    put(site, ring, church, row, {{"natural", "tree"}, {"height", "9"}});
    if (i % 2) put(site, ring, church, row + v * 2.5, {{"amenity", "bench"}, {"backrest", "yes"}});
    put(site, ring, church, c + v * (hy * 0.86) + u * (hx * 0.26 * i), {{"highway", "street_lamp"}});
  }
  put(site, ring, church, c - v * (hy * 0.1) + u * (hx * 0.8), {{"amenity", "waste_basket"}});
  put(site, ring, church, c - v * (hy * 0.05) - u * (hx * 0.8), {{"amenity", "clock"}, {"support", "pole"}});
}

/// The roomiest place of a square for a few houses that stand free on it.
std::optional<Ring> room_for_island(const Ring& square, Vec along) {
  Vec low = square[0], high = square[0];
  for (const Vec p : square) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr int kGrid = 24;
  Vec best = low;
  double clearance = 0;
  for (int i = 1; i < kGrid; ++i)
    for (int j = 1; j < kGrid; ++j) {
      const Vec p{low.x + (high.x - low.x) * i / kGrid, low.y + (high.y - low.y) * j / kGrid};
      const double c = contains(square, p) ? distance_to_ring(p, square) : 0;
      if (c > clearance) clearance = c, best = p;
    }
  for (double size = 9; size > 6; size -= 0.5) {
    const Ring island = rectangle(best, along, size, size * 0.88);
    if (std::all_of(island.begin(), island.end(), [&](Vec p) { return contains_with_margin(square, p, 3); }))
      return island;
  }
  return std::nullopt;
}

}  // namespace

/// Nave, apse in the east, tower in the west; `at` is the middle of the nave.
void build_church(Site& site, Vec at, Vec east, double scale) {
  const Vec north = left_of(east);
  const auto p = [&](double e, double n) { return at + east * (e * scale) + north * (n * scale); };
  const Ring tower = {p(-17, -3.2), p(-11, -3.2), p(-11, 3.2), p(-17, 3.2)};
  const Ring nave = {p(-11, -6), p(8, -6), p(8, 6), p(-11, 6), p(-11, 3.2), p(-11, -3.2)};
  const Ring apse = {p(8, -4.5), p(11, -4), p(13.5, -1.8), p(13.5, 1.8), p(11, 4), p(8, 4.5)};
  const Ring outline = {p(-17, -3.2), p(-11, -3.2), p(-11, -6), p(8, -6), p(8, -4.5), p(11, -4),   p(13.5, -1.8),
                        p(13.5, 1.8), p(11, 4),     p(8, 4.5),  p(8, 6),  p(-11, 6),  p(-11, 3.2), p(-17, 3.2)};
  build_other(site, outline,
              {{"building", "church"},
               {"amenity", "place_of_worship"},
               {"religion", "christian"},
               {"height", "46"},
               {"name", "Sankt-Ägidien-Kirche"},
               {"building:colour", "#d8cbb0"}});
  const auto part = [&](const Ring& ring, Tags tags) {
    tags.insert(tags.begin(), {"building:part", "yes"});
    site.map.closed_way(site.map.nodes_of(ring), std::move(tags));
  };
  part(nave, {{"height", "21"}, {"roof:shape", "gabled"}, {"roof:height", "8"}, {"roof:colour", "#8c3b2a"}});
  part(tower, {{"height", "46"}, {"roof:shape", "pyramidal"}, {"roof:height", "14"}, {"roof:colour", "#5b7f6a"}});
  part(apse, {{"height", "14"}, {"roof:shape", "half-hipped"}, {"roof:height", "4"}});
}

void build_market(Site& site, std::size_t face) {
  const auto sides = facade_sides(site.network, face, {0, kWallSetback}, 0);
  const Ring ring = ring_of(sides);
  if (sides.empty() || !is_simple(ring)) return;
  add_square(site, ring, "Großer Markt");
  const Vec u = long_axis(ring), v = left_of(u), c = centroid_of(ring);
  double hx = 0, hy = 0;
  for (const Vec p : ring) hx = std::max(hx, std::abs(dot(p - c, u))), hy = std::max(hy, std::abs(dot(p - c, v)));
  const Vec east = u.x > 0 ? u : u * -1;
  Ring church;
  for (double scale = std::min({1.15, hx / 24, hy / 13}); scale > 0.3 && church.empty(); scale *= 0.93)
    for (const double aside : {0.3, 0.15, 0.0}) {
      const Vec at = c + v * (hy * aside);
      const Ring room = rectangle(at - east * (1.7 * scale), east, 16.5 * scale, 7.5 * scale);
      if (!std::all_of(room.begin(), room.end(), [&](Vec p) { return contains_with_margin(ring, p, 1); })) continue;
      build_church(site, at, east, scale);
      site.sights |= kChurch;
      church = room;
      break;
    }
  furnish_market(site, ring, c, u, v, hx, hy, church);
}

/// An L: the block less its first corner, where houses stand; an island of houses at the opposite end.
void build_second_square(Site& site, std::size_t face) {
  auto sides = facade_sides(site.network, face, {0, kWallSetback}, 0);
  if (sides.size() < 4) return;
  std::size_t best = 0;  // the corner nearest to a right angle
  double straightest = 2;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& before = sides[(i + sides.size() - 1) % sides.size()];
    const double c = std::abs(
        dot(unit(before.front.back() - before.front.front()), unit(sides[i].front.back() - sides[i].front.front())));
    const double shorter = std::min(length_of(before.front), length_of(sides[i].front));
    if (shorter > 40 && c < straightest) straightest = c, best = i;
  }
  std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(best), sides.end());
  const Side &first = sides.front(), &last = sides.back();
  const Vec corner = first.front.front();
  const double a = length_of(first.front) * 0.5, b = length_of(last.front) * 0.5;
  const Vec on_first = point_along(first.front, a), on_last = point_along(last.front, length_of(last.front) - b);
  const Vec elbow = on_first + on_last - corner;
  const Vec u = unit(on_first - corner), v = left_of(u), off_u = u * kPavement;
  const Vec off_v = unit(on_last - corner) * kPavement;
  Ring square{elbow + off_u + off_v, on_first + off_u};
  const Ring all = ring_of(sides);
  double walked = 0;
  for (std::size_t i = 1; i < first.front.size(); ++i) {
    walked += distance(first.front[i - 1], first.front[i]);
    if (walked > a + 1) square.push_back(first.front[i]);
  }
  for (std::size_t s = 1; s + 1 < sides.size(); ++s)
    square.insert(square.end(), sides[s].front.begin() + 1, sides[s].front.end());
  walked = 0;
  for (std::size_t i = 1; i < last.front.size(); ++i) {
    walked += distance(last.front[i - 1], last.front[i]);
    if (walked < length_of(last.front) - b - 1) square.push_back(last.front[i]);
  }
  square.push_back(on_last + off_v);
  if (!is_simple(square) || area_of(square) < 500) return;
  const Ring block{corner, on_first, elbow, on_last};
  std::vector<Side> block_sides;
  for (std::size_t i = 0; i < 4; ++i) block_sides.push_back({{block[i], block[(i + 1) % 4]}, first.line, true, 0, 60});
  if (!build_rows(site, block_sides, Edge::kNoFace)) build_island(site, block, first.line);
  add_square(site, square, "Kohlmarkt");
  const Vec far = square[square.size() / 2];
  Ring keep_out;
  if (const auto island = room_for_island(square, u)) {
    build_island(site, *island, first.line);
    site.sights |= kIsland;
    keep_out = rectangle(centroid_of(*island), u, 11, 10);
  }
  put(site, square, keep_out, mix(on_first, far, 0.25) + v * 3, {{"natural", "tree"}});
  put(site, square, keep_out, mix(on_last, far, 0.25) + u * 3, {{"natural", "tree"}});
  put(site, square, keep_out, mix(on_last, far, 0.15) + u * 4, {{"amenity", "bench"}});
  put(site, square, keep_out, mix(on_first, far, 0.15) + v * 4, {{"amenity", "drinking_water"}});
}

}  // namespace vicus::town
