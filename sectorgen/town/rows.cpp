#include <algorithm>

#include "sectorgen/town/site.hpp"

/// Houses wall to wall around a block:
///
///      V---+----+-----+---W     V..W facade line; every wall is shared by two houses
///      |   |    |     |   |     I    the inner corner of a corner house, where its two party walls meet
///      |   |    +--+  |   |
///      +---I..+    |..I---+     dotted: the courtyard, whose ring takes every step of the rear walls
///      |   :  +----+  :   |
namespace vicus::town {

namespace {

constexpr double kLeastDepth = 6, kMostDepth = 15;
constexpr double kLeastStep = 0.9;  // m: rear walls of neighbours differ by this or not at all
constexpr double kTypicalFront = 9.5;
constexpr double kCourtBefore = 4;  // m of open court that a passage needs before it
constexpr double kShortSide = 17;

/// A wall across the row: from the facade inwards. `before`, `after`: depth of the houses on both sides.
struct Wall {
  Vec front, inward;
  double at = 0;  ///< along the side
  double before = 0, after = 0;
  double joint_depth = -1;  ///< at this depth stands `joint`, the corner's inner point, to the last bit
  Vec joint;
  Vec rear(double depth) const { return depth == joint_depth ? joint : front + inward * depth; }
};

/// A corner house's inner point and the legs it takes of both sides.
struct Corner {
  double leg_before = 0, leg_after = 0;
  Vec inner;
};

struct Row {
  const Side* side = nullptr;
  double size = 0;
  std::vector<Wall> walls;  ///< first and last are the corner houses'
};

Wall wall_at(const Row& row, double at) {
  Wall w;
  Vec forward;
  w.front = point_along(row.side->front, at, &forward);
  w.inward = left_of(forward);
  w.at = at;
  return w;
}

/// Legs that give the corner house the depth; where the point of the corner is cut off, the cut counts.
double leg_of(const Side& before, const Side& after, double depth) {
  const Vec u = unit(before.front[before.front.size() - 2] - before.front.back());
  const Vec v = unit(after.front[1] - after.front.front());
  const double c = dot(u, v), s = cross(v, u);  // of the inner angle
  if (s < 0.2) return 0;
  const double cut_off = distance(before.front.back(), after.front.front()) / (2 * std::sqrt((1 - c) / 2));
  return std::clamp(depth * (1 + c) / s - cut_off, kLeastDepth - cut_off / 4 < 4 ? 4 : kLeastDepth, 17.0);
}

/// Walls of one side, the corners' legs given; none when the side is too short for both.
bool place_walls(Row& row, double first, double last, Rng& rng) {
  double room = row.size - first - last;
  if (room < 0 && room > -0.35 * row.size) {
    first *= row.size / (first + last);
    room = 0;
  }
  if (room < 0 || first < 4 || row.size - first < 4) return false;
  if (room < 5) {
    row.walls = {wall_at(row, first + room / 2)};
    return true;
  }
  const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(room / rng.between(8.2, 10.8) + 0.5));
  std::vector<double> share;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) share.push_back(rng.between(0.75, 1.3)), sum += share.back();
  double at = first;
  row.walls = {wall_at(row, first)};
  for (std::size_t i = 0; i < count; ++i) {
    at += share[i] * room / sum;
    row.walls.push_back(wall_at(row, i + 1 == count ? first + room : at));
  }
  return true;
}

/// Where the corner house's two party walls meet; false when too near or too far from either facade.
bool close_corner(Wall& before, Wall& after, Vec& inner) {
  const auto t = meeting_on_line(before.front, before.front + before.inward, after.front, after.front + after.inward);
  const auto s = meeting_on_line(after.front, after.front + after.inward, before.front, before.front + before.inward);
  if (!t || !s || *t < kLeastDepth - 1 || *s < kLeastDepth - 1 || *t > 19 || *s > 19) return false;
  inner = before.rear(*t);
  before.after = *t;
  after.before = after.joint_depth = *s;
  after.joint = inner;
  return true;
}

bool fits(double depth, double neighbour) {
  const double step = depth > neighbour ? depth - neighbour : neighbour - depth;
  return step == 0 || step >= kLeastStep;
}

/// Next to a corner no house is deeper than the corner house: two deeper ones would meet behind its inner point.
void draw_depths(Row& row, double typical, Rng& rng) {
  for (std::size_t i = 0; i + 1 < row.walls.size(); ++i) {
    const double left = row.walls[i].before;
    const bool is_first = i == 0, is_last = i + 2 == row.walls.size();
    const double right = is_last ? row.walls[i + 1].after : 1e9;
    const double most = std::min(is_first ? left : 1e9, right);
    double depth = rng.chance(0.6) ? typical * rng.between(0.8, 1.2) : left;
    depth = std::min(depth, most);
    if (!fits(depth, left) || !fits(depth, right)) depth = std::min(left, most);
    if (!fits(depth, left) || !fits(depth, right)) depth = std::min(left, right) - kLeastStep;
    row.walls[i].after = depth;
    row.walls[i + 1].before = depth;
  }
}

struct Plot {
  Ring ring;              ///< counter-clockwise, starting with the front
  std::vector<Vec> rear;  ///< its part of the courtyard's ring, in the order of the facade
  const Side* side = nullptr;
  double middle_m = 0;  ///< chainage along the street
  bool is_corner = false;
};

void add_wall_step(Ring& ring, const Wall& w, double own, double other) {
  if (other > 0 && other < own) ring.push_back(w.rear(other));
}

double chainage(const Row& row, double at) {
  const double t = at / row.size;
  return row.side->first_m + (row.side->last_m - row.side->first_m) * t;
}

Plot corner_plot(const Row& before, const Row& after, Vec inner) {
  const Wall &a = before.walls.back(), &b = after.walls.front();
  Plot p;
  p.ring = {a.front, before.side->front.back()};
  if (!(p.ring.back() == after.side->front.front())) p.ring.push_back(after.side->front.front());
  p.ring.push_back(b.front);
  add_wall_step(p.ring, b, b.before, b.after);
  p.ring.push_back(inner);
  add_wall_step(p.ring, a, a.after, a.before);
  p.rear = {inner};
  p.side = after.side;
  p.middle_m = chainage(after, b.at / 2);
  p.is_corner = true;
  return p;
}

Plot row_plot(const Row& row, std::size_t i) {
  const Wall &a = row.walls[i], &b = row.walls[i + 1];
  Plot p;
  p.ring = {a.front, b.front};
  add_wall_step(p.ring, b, b.before, b.after);
  p.ring.push_back(b.rear(b.before));
  p.ring.push_back(a.rear(a.after));
  add_wall_step(p.ring, a, a.after, a.before);
  p.rear = {a.rear(a.after), b.rear(b.before)};
  p.side = row.side;
  p.middle_m = chainage(row, (a.at + b.at) / 2);
  return p;
}

/// One try with one depth; empty when the block is too narrow or too odd for it.
std::vector<Plot> divide_block(const std::vector<Side>& sides, double depth, Rng rng) {
  const std::size_t n = sides.size();
  std::vector<Row> rows(n);
  std::vector<Vec> inner(n);  // inner[i]: at the start of side i
  for (std::size_t i = 0; i < n; ++i) {
    rows[i].side = &sides[i];
    rows[i].size = length_of(sides[i].front);
    const double first = leg_of(sides[(i + n - 1) % n], sides[i], depth);
    const double last = leg_of(sides[i], sides[(i + 1) % n], depth);
    if (first == 0 || last == 0 || !place_walls(rows[i], first, last, rng)) return {};
  }
  for (std::size_t i = 0; i < n; ++i)
    if (!close_corner(rows[(i + n - 1) % n].walls.back(), rows[i].walls.front(), inner[i])) return {};
  for (Row& row : rows) {
    if (row.walls.size() > 1) draw_depths(row, depth, rng);
    const Wall& only = row.walls.front();
    if (row.walls.size() == 1 && !fits(only.before, only.after)) return {};
  }
  std::vector<Plot> plots;
  for (std::size_t i = 0; i < n; ++i) {
    plots.push_back(corner_plot(rows[(i + n - 1) % n], rows[i], inner[i]));
    for (std::size_t k = 0; k + 1 < rows[i].walls.size(); ++k) plots.push_back(row_plot(rows[i], k));
  }
  for (const Plot& p : plots)
    if (area_of(p.ring) < 25 || !is_simple(p.ring)) return {};
  return plots;
}

Ring court_of(const std::vector<Plot>& plots) {
  Ring court;
  for (const Plot& p : plots)
    for (const Vec v : p.rear)
      if (court.empty() || !(court.back() == v)) court.push_back(v);
  if (court.size() > 1 && court.front() == court.back()) court.pop_back();
  return court;
}

Passage passage_of(const Plot& p) {
  Passage passage;
  passage.outer = mix(p.ring[0], p.ring[1], 0.5);
  passage.inner = mix(p.rear.front(), p.rear.back(), 0.5);
  passage.inward = unit(passage.inner - passage.outer);
  passage.line = p.side->line;
  return passage;
}

/// A way through the house: a node in the middle of its front and of its rear wall.
Passage break_passage(Plot& p) {
  const auto rear = std::find(p.ring.begin(), p.ring.end(), p.rear.back()) - p.ring.begin();
  const Passage passage = passage_of(p);
  p.ring.insert(p.ring.begin() + rear + 1, passage.inner);
  p.ring.insert(p.ring.begin() + 1, passage.outer);
  return passage;
}

bool suits_passage(const Site& site, const Plot& p, const Ring& court) {
  if (p.is_corner || distance(p.ring[0], p.ring[1]) < 7) return false;
  const StreetKind kind = site.network.lines[p.side->line].kind;
  const bool is_street = kind == StreetKind::street || kind == StreetKind::main || kind == StreetKind::ring;
  const Passage way = passage_of(p);
  return is_street && !is_walled(site.network, *p.side) &&
         !meets_ring(court, way.inner + way.inward * 0.05, way.inner + way.inward * kCourtBefore);
}

std::vector<Passage> break_passages(Site& site, std::vector<Plot>& plots, const Ring& court, Rng& rng) {
  std::vector<Passage> passages;
  const std::size_t wanted = rng.chance(0.5) ? rng.chance(0.5) ? 2 : 1 : 0;
  const std::size_t start = rng.below(plots.size());
  for (std::size_t k = 0; k < plots.size() && passages.size() < wanted; ++k) {
    Plot& p = plots[(start + k) % plots.size()];
    if (!suits_passage(site, p, court) || (!passages.empty() && passages.back().line == p.side->line)) continue;
    passages.push_back(break_passage(p));
  }
  return passages;
}

Ring light_well(const Plot& p, Rng& rng) {
  if (p.is_corner || p.ring.size() != 4 || distance(p.ring[0], p.ring[1]) < 9.5 ||
      distance(p.ring[1], p.ring[2]) < 10 || !rng.chance(0.3))
    return {};
  const Vec c = centroid_of(p.ring);
  const double half_wide = rng.between(1.3, 2), half_deep = rng.between(1.3, 2);
  Ring well = rectangle(c, unit(p.ring[1] - p.ring[0]), half_wide, half_deep);
  for (const Vec v : well)
    if (!contains_with_margin(p.ring, v, 2)) return {};
  return well;
}

/// Houses back to back between two fronts that run the same way.
void build_double_row(Site& site, const Polyline& front, const Polyline& rear, std::size_t line) {
  const double size = length_of(front), rear_size = length_of(rear);
  const auto count = std::max<std::size_t>(2, static_cast<std::size_t>(size / kTypicalFront));
  const auto at = [&](std::size_t i, double across) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    return mix(point_along(front, size * t), point_along(rear, rear_size * t), across);
  };
  for (std::size_t i = 0; i < count; ++i)
    for (const bool is_rear : {false, true}) {
      Ring ring{at(i, 0), at(i + 1, 0), at(i + 1, 0.5), at(i, 0.5)};
      if (is_rear) ring = {at(i + 1, 1), at(i, 1), at(i, 0.5), at(i + 1, 0.5)};
      build_house(site, ring, {line, static_cast<int>(2 * i + (is_rear ? 1 : 2)), true, false});
    }
}

}  // namespace

bool build_rows(Site& site, std::vector<Side> sides, std::size_t face) {
  if (sides.size() > 3)  // a side too short for two corner houses is the cut-off point of one
    std::erase_if(sides, [](const Side& s) { return length_of(s.front) < kShortSide; });
  if (sides.size() < 3) return false;
  Rng rng = site.rng.fork();
  std::vector<Plot> plots;
  Ring court;
  for (double depth = rng.between(9.5, 13); depth > 6; depth *= 0.94) {
    plots = divide_block(sides, std::min(depth, kMostDepth), rng.fork());
    court = court_of(plots);
    if (!plots.empty() && is_simple(court) && area_of(court) > 25) break;
    plots.clear();
  }
  if (plots.empty()) return false;
  const bool is_face = face != Edge::kNoFace;
  std::vector<Passage> passages;
  if (is_face && static_cast<int>(plots.size()) <= site.houses_left) passages = break_passages(site, plots, court, rng);
  bool is_closed = true;
  for (Plot& p : plots) {
    const Lot lot{p.side->line, 2 * static_cast<int>(p.middle_m / 6) + (p.side->is_left ? 1 : 2), true, false};
    const Ring quad = p.ring;
    is_closed = build_house(site, p.ring, lot, light_well(p, rng)) && is_closed;
    if (!is_closed) break;
    if (rng.chance(0.22)) open_shop(site, mix(mix(quad[0], quad[1], 0.5), centroid_of(quad), 0.3));
    if (site.interiors == 0 && quad.size() == 4) furnish_house(site, quad, lot);
  }
  if (is_closed) lay_out_courtyard(site, court, passages, face);
  return true;
}

bool build_narrow_block(Site& site, std::size_t face) {
  auto sides = facade_sides(site.network, face, {0, kWallSetback}, 0);
  if (sides.size() != 4) return false;
  const auto size = [&](std::size_t i) { return (length_of(sides[i].front) + length_of(sides[i + 2].front)) / 2; };
  if (size(0) < size(1)) std::rotate(sides.begin(), sides.begin() + 1, sides.end());
  if (size(1) < 12 || size(1) > 31) return false;
  Polyline rear = sides[2].front;
  std::reverse(rear.begin(), rear.end());
  build_double_row(site, sides[0].front, rear, sides[0].line);
  return true;
}

void build_island(Site& site, const Ring& corners, std::size_t line) {
  const std::size_t first = distance(corners[0], corners[1]) >= distance(corners[1], corners[2]) ? 0 : 1;
  const auto corner = [&](std::size_t i) { return corners[(i + first) % 4]; };
  build_double_row(site, {corner(0), corner(1)}, {corner(3), corner(2)}, line);
}

}  // namespace vicus::town
