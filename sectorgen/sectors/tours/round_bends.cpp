#include "sectorgen/sectors/tours/round_bends.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vicus {
namespace {

struct Vec {
  double x = 0, y = 0;
};

Vec towards(PlanPoint a, PlanPoint b) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::hypot(dx, dy);
  return length > 0 ? Vec{dx / length, dy / length} : Vec{};
}

}  // namespace

std::vector<RoundedPoint> round_bends(const Walk& walk) {
  const auto& points = walk.points;
  std::vector<RoundedPoint> rounded;
  double straight = 0;
  const auto add = [&](double x, double y, double at) {
    double walked = 0;
    if (!rounded.empty()) {
      const auto& last = rounded.back();
      const double step = std::hypot(x - last.east_mm, y - last.north_mm);
      if (step == 0) return;
      walked = last.walked_mm + step;
    }
    rounded.push_back({x, y, walked, at});
  };
  add(points.front().x, points.front().y, 0);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const PlanPoint p = points[i];
    const double before = straight_mm(points[i - 1], p), after = straight_mm(p, points[i + 1]);
    straight += before;
    const Vec in = towards(points[i - 1], p), out = towards(p, points[i + 1]);
    const double turn = std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y);
    const double half = std::abs(turn) / 2;
    double radius = walk.radius_mm[i];
    if (half < 1e-6 || half > 1.5 || radius == 0) {
      add(p.x, p.y, straight);
      continue;
    }
    const double reach = std::min(radius * std::tan(half), std::min(before, after) / 2);
    radius = reach / std::tan(half);
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * half * 180 / std::numbers::pi / kArcStep_deg)));
    const double side = turn > 0 ? 1 : -1;
    const Vec begin{p.x - in.x * reach, p.y - in.y * reach},
        centre{begin.x - side * in.y * radius, begin.y + side * in.x * radius};
    for (int s = 0; s <= steps; ++s) {
      const double angle = turn * s / steps;
      const Vec from{begin.x - centre.x, begin.y - centre.y};
      add(centre.x + from.x * std::cos(angle) - from.y * std::sin(angle),
          centre.y + from.x * std::sin(angle) + from.y * std::cos(angle), straight - reach + 2 * reach * s / steps);
    }
  }
  straight += points.size() > 1 ? straight_mm(points[points.size() - 2], points.back()) : 0;
  add(points.back().x, points.back().y, straight);
  if (rounded.size() == 1) rounded.push_back(rounded.front());
  return rounded;
}

}  // namespace vicus
