#include "sectorgen/town/plane.hpp"

#include <algorithm>

namespace vicus::town {

double sine_of_turn(double turn) {
  turn -= std::floor(turn + 0.5);  // now within half a turn of 0
  if (turn > 0.25) turn = 0.5 - turn;
  if (turn < -0.25) turn = -0.5 - turn;
  const double x = turn * 6.283185307179586, y = x * x;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) sum = (1 + sum) * (-y / (k * (k - 1)));
  return x * (1 + sum);
}

double area_of(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) twice += cross(ring[j], ring[i]);
  return twice / 2;
}

Vec centroid_of(const Ring& ring) {
  const Vec o = ring.front();
  Vec sum;
  double twice = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double c = cross(ring[j] - o, ring[i] - o);
    sum = sum + ((ring[j] - o) + (ring[i] - o)) * c;
    twice += c;
  }
  return o + sum * (1 / (3 * twice));
}

bool contains(const Ring& ring, Vec p) {
  bool is_inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec a = ring[j], b = ring[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) is_inside = !is_inside;
  }
  return is_inside;
}

double distance_to_segment(Vec p, Vec a, Vec b) {
  const Vec d = b - a;
  const double l = dot(d, d);
  const double t = l > 0 ? std::clamp(dot(p - a, d) / l, 0.0, 1.0) : 0.0;
  return distance(p, a + d * t);
}

double distance_to_ring(Vec p, const Ring& ring) {
  double best = 1e30;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    best = std::min(best, distance_to_segment(p, ring[j], ring[i]));
  return best;
}

bool contains_with_margin(const Ring& ring, Vec p, double margin) {
  return contains(ring, p) && distance_to_ring(p, ring) >= margin;
}

bool segments_meet(Vec a, Vec b, Vec c, Vec d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  const double s = cross(b - a, c - a), t = cross(b - a, d - a), u = cross(d - c, a - c), v = cross(d - c, b - c);
  return (s <= 0 || t <= 0) && (s >= 0 || t >= 0) && (u <= 0 || v <= 0) && (u >= 0 || v >= 0);
}

bool meets_ring(const Ring& ring, Vec a, Vec b) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (segments_meet(ring[j], ring[i], a, b)) return true;
  return false;
}

bool is_simple(const Ring& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
    if (a == b || (cross(b - a, c - b) == 0 && dot(b - a, c - b) < 0)) return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && segments_meet(a, b, ring[j], ring[(j + 1) % n])) return false;
  }
  return true;
}

std::optional<double> meeting_on_line(Vec a, Vec b, Vec c, Vec d) {
  const double denominator = cross(b - a, d - c);
  if (denominator * denominator < 1e-6 * dot(b - a, b - a) * dot(d - c, d - c)) return std::nullopt;
  return cross(c - a, d - c) / denominator;
}

double width_of_convex(const Ring& ring, Vec& along) {
  double best = 1e30;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (distance(ring[j], ring[i]) < 1) continue;
    const Vec u = unit(ring[i] - ring[j]);
    double reach = 0;
    for (const Vec p : ring) reach = std::max(reach, cross(u, p - ring[j]));
    if (reach < best) best = reach, along = u;
  }
  return best;
}

Polyline offset_left(const Polyline& line, double by) {
  Polyline out;
  out.reserve(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec before = left_of(unit(line[i ? i : 1] - line[i ? i - 1 : 0]));
    const Vec after = i + 1 < line.size() ? left_of(unit(line[i + 1] - line[i])) : before;
    const Vec middle = unit(before + after);
    out.push_back(line[i] + middle * (by / std::max(0.5, dot(middle, after))));
  }
  return out;
}

double length_of(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

namespace {
Vec point_on(const Polyline& line, double at) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (at <= step || i + 1 == line.size()) return step > 0 ? mix(line[i - 1], line[i], at / step) : line[i];
    at -= step;
  }
  return line.front();
}
}  // namespace

Vec point_along(const Polyline& line, double at, Vec* forward) {
  if (forward) *forward = unit(point_on(line, at + 4.0) - point_on(line, std::max(0.0, at - 4.0)));
  return point_on(line, at);
}

Ring rectangle(Vec centre, Vec along, double half_long, double half_wide) {
  const Vec u = along * half_long, v = left_of(along) * half_wide;
  return {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
}

bool convex_rings_meet(const Ring& a, const Ring& b) {
  for (const auto* rings : {&a, &b}) {
    const Ring& one = *rings;
    const Ring& other = rings == &a ? b : a;
    for (std::size_t i = 0, j = one.size() - 1; i < one.size(); j = i++) {
      bool is_apart = true;
      for (const Vec p : other) is_apart = is_apart && cross(one[i] - one[j], p - one[j]) < 0;
      if (is_apart) return false;
    }
  }
  return true;
}

}  // namespace vicus::town
