#include "sectorgen/models/roof_form.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sectorgen/geom/polygon.hpp"

namespace vicus {
namespace {

constexpr std::pair<RoofForm, const char*> kForms[] = {
    {RoofForm::flat, "flat"},       {RoofForm::skillion, "skillion"},
    {RoofForm::gabled, "gabled"},   {RoofForm::half_hipped, "half-hipped"},
    {RoofForm::hipped, "hipped"},   {RoofForm::pyramidal, "pyramidal"},
    {RoofForm::gambrel, "gambrel"}, {RoofForm::mansard, "mansard"},
    {RoofForm::dome, "dome"},       {RoofForm::onion, "onion"},
    {RoofForm::cone, "cone"},       {RoofForm::round, "round"},
    {RoofForm::saltbox, "saltbox"}};
// Other spellings and near relations in the maps.
constexpr std::pair<RoofForm, const char*> kSynonyms[] = {{RoofForm::half_hipped, "half_hipped"},
                                                          {RoofForm::skillion, "lean_to"},
                                                          {RoofForm::skillion, "monopitch"},
                                                          {RoofForm::gabled, "pitched"},
                                                          {RoofForm::gabled, "gable"},
                                                          {RoofForm::hipped, "hip"},
                                                          {RoofForm::hipped, "side_hipped"},
                                                          {RoofForm::saltbox, "double_saltbox"},
                                                          {RoofForm::cone, "conical"},
                                                          {RoofForm::gabled, "gabled_height_moved"},
                                                          {RoofForm::pyramidal, "pyramid"},
                                                          {RoofForm::round, "barrel"},
                                                          {RoofForm::hipped, "hipped-and-gabled"}};

constexpr double kSideBendSine = 0.17365;  // 10 degrees

/// Sine of the turn at the point between two edges, and whether the walk goes on forwards.
std::pair<double, bool> turn_at(PlanPoint a, PlanPoint b, PlanPoint c) {
  const double length =
      std::sqrt(static_cast<double>(distance2(a, b))) * std::sqrt(static_cast<double>(distance2(b, c)));
  return {static_cast<double>(orient(a, b, c)) / length, dot(b, a, c) < 0};
}

void add_sides(const Ring& ring, std::size_t first_edge, std::vector<RoofSide>& sides) {
  const std::size_t n = ring.size(), first_side = sides.size();
  const auto turn = [&](std::size_t i) { return turn_at(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]); };
  const auto is_corner = [&](std::size_t i) {
    const auto [sine, is_forward] = turn(i);
    return !is_forward || std::abs(sine) >= kSideBendSine;
  };
  std::size_t start = 0;
  while (start < n && !is_corner(start)) ++start;
  const bool is_smooth = start == n;  // a round plan: every edge is a side
  if (is_smooth) start = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k == 0 || is_smooth || is_corner(i)) sides.emplace_back();
    sides.back().edges.push_back(static_cast<std::uint32_t>(first_edge + i));
  }
  const std::size_t count = sides.size() - first_side;
  for (std::size_t s = 0; s < count; ++s) {
    RoofSide& side = sides[first_side + s];
    side.before = first_side + (s + count - 1) % count;
    side.after = first_side + (s + 1) % count;
    const std::size_t from = side.edges.front() - first_edge, to = (side.edges.back() - first_edge + 1) % n;
    const double dx = metres(std::int64_t{ring[to].x} - ring[from].x),
                 dy = metres(std::int64_t{ring[to].y} - ring[from].y);
    side.length_m = std::hypot(dx, dy);
    if (side.length_m > 0) side.nx = dy / side.length_m, side.ny = -dx / side.length_m;
    side.is_convex = turn(from).first > 0 && turn(to).first > 0;
  }
}

}  // namespace

const char* name_of(RoofForm form) {
  for (const auto& [f, name] : kForms)
    if (f == form) return name;
  return "?";
}

std::optional<RoofForm> roof_form_of(const std::string& shape) {
  for (const auto& [form, name] : kForms)
    if (shape == name) return form;
  for (const auto& [form, name] : kSynonyms)
    if (shape == name) return form;
  return std::nullopt;
}

std::vector<RoofSide> sides_of(const Polygon& footprint) {
  std::vector<RoofSide> sides;
  add_sides(footprint.outer, 0, sides);
  std::size_t first_edge = footprint.outer.size();
  for (const auto& hole : footprint.holes) {
    add_sides(hole, first_edge, sides);
    first_edge += hole.size();
  }
  return sides;
}

PlanRectangle rectangle_around(const Polygon& footprint) {
  const Ring hull = convex_hull(footprint.outer);
  PlanRectangle best;
  double least = -1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const PlanPoint a = hull[i], b = hull[(i + 1) % hull.size()];
    const double length = std::sqrt(static_cast<double>(distance2(a, b)));
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    double low = 0, high = 0, depth = 0;
    for (const PlanPoint p : hull) {
      const double dx = metres(std::int64_t{p.x} - a.x), dy = metres(std::int64_t{p.y} - a.y);
      low = std::min(low, dx * ux + dy * uy);
      high = std::max(high, dx * ux + dy * uy);
      depth = std::max(depth, dy * ux - dx * uy);
    }
    const double area = (high - low) * depth;
    if (least >= 0 && area >= least * (1 - 1e-9)) continue;
    least = area;
    const bool is_along = high - low >= depth;
    best = {is_along ? ux : -uy, is_along ? uy : ux, std::max(high - low, depth), std::min(high - low, depth)};
  }
  return best;
}

std::optional<PlanPoint> star_centre(const Polygon& footprint) {
  if (!footprint.holes.empty()) return std::nullopt;
  const Ring& ring = footprint.outer;
  const PlanPoint o = ring.front();
  double x = 0, y = 0, sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint p = ring[i], q = ring[(i + 1) % ring.size()];
    const double px = p.x - o.x, py = p.y - o.y, qx = q.x - o.x, qy = q.y - o.y, cross = px * qy - py * qx;
    x += (px + qx) * cross;
    y += (py + qy) * cross;
    sum += cross;
  }
  const PlanPoint c{o.x + static_cast<std::int32_t>(std::llround(x / (3 * sum))),
                    o.y + static_cast<std::int32_t>(std::llround(y / (3 * sum)))};
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (orient(ring[i], ring[(i + 1) % ring.size()], c) <= 0) return std::nullopt;
  return c;
}

}  // namespace vicus
