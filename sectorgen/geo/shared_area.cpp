#include "sectorgen/geo/shared_area.hpp"

#include <algorithm>
#include <vector>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {

namespace {

/// Edge of a polygon seen as a function y(x), x0 < x1, metres from the common box's lower left corner.
struct Span {
  double x0, y0, x1, y1;
  double sign;  // +1: the polygon lies below the edge
  double at(double x) const { return y0 + (y1 - y0) * ((x - x0) / (x1 - x0)); }
};

void append_spans(const Ring& ring, const PlanBox& box, std::vector<Span>& spans) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    PlanPoint a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a.x == b.x) continue;
    const double sign = a.x < b.x ? -1 : 1;
    if (a.x > b.x) std::swap(a, b);
    // What ends below the box has nothing above its lower edge.
    if (b.x <= box.min.x || a.x >= box.max.x || std::max(a.y, b.y) <= box.min.y) continue;
    spans.push_back({metres(std::int64_t{a.x} - box.min.x), metres(std::int64_t{a.y} - box.min.y),
                     metres(std::int64_t{b.x} - box.min.x), metres(std::int64_t{b.y} - box.min.y), sign});
  }
}

std::vector<Span> spans_of(const Polygon& polygon, const PlanBox& box) {
  std::vector<Span> spans;
  append_spans(polygon.outer, box, spans);
  for (const Ring& hole : polygon.holes) append_spans(hole, box, spans);
  return spans;
}

/// Integral of the positive part of a straight line from y0 to y1 over `width`.
double positive_part(double y0, double y1, double width) {
  if (y0 >= 0 && y1 >= 0) return (y0 + y1) / 2 * width;
  if (y0 <= 0 && y1 <= 0) return 0;
  const double above = std::max(y0, y1), below = std::min(y0, y1);
  return above * above / (above - below) / 2 * width;
}

/// Integral of max(0, min(a, b)) where both are defined, inside [0, width].
double common_area(const Span& a, const Span& b, double width) {
  const double from = std::max({a.x0, b.x0, 0.0}), to = std::min({a.x1, b.x1, width});
  if (from >= to) return 0;
  const double a0 = a.at(from), a1 = a.at(to), b0 = b.at(from), b1 = b.at(to);
  const double d0 = a0 - b0, d1 = a1 - b1;
  if (d0 <= 0 && d1 <= 0) return positive_part(a0, a1, to - from);
  if (d0 >= 0 && d1 >= 0) return positive_part(b0, b1, to - from);
  const double share = d0 / (d0 - d1), middle = a0 + (a1 - a0) * share, split = (to - from) * share;
  const bool a_first = d0 < 0;
  return positive_part(a_first ? a0 : b0, middle, split) + positive_part(middle, a_first ? b1 : a1, to - from - split);
}

}  // namespace

double shared_area_m2(const Polygon& a, const Polygon& b) {
  const PlanBox box_a = box_of(a), box_b = box_of(b);
  const PlanBox common{{std::max(box_a.min.x, box_b.min.x), std::max(box_a.min.y, box_b.min.y)},
                       {std::min(box_a.max.x, box_b.max.x), std::min(box_a.max.y, box_b.max.y)}};
  if (common.min.x >= common.max.x || common.min.y >= common.max.y) return 0;
  const double width = metres(std::int64_t{common.max.x} - common.min.x);
  const std::vector<Span> spans_a = spans_of(a, common), spans_b = spans_of(b, common);
  double sum = 0;
  for (const Span& s : spans_a)
    for (const Span& t : spans_b) sum += s.sign * t.sign * common_area(s, t, width);
  return std::max(sum, 0.0);
}

double common_box_m2(const PlanBox& a, const PlanBox& b) {
  const auto extent = [](std::int32_t low, std::int32_t high) { return metres(std::int64_t{high} - low); };
  return std::max(0.0, extent(std::max(a.min.x, b.min.x), std::min(a.max.x, b.max.x))) *
         std::max(0.0, extent(std::max(a.min.y, b.min.y), std::min(a.max.y, b.max.y)));
}

}  // namespace vicus
