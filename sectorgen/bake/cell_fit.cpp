#include "sectorgen/bake/cell_fit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "city_db/blockmap.hpp"
#include "city_db/blockmap_layout.h"

namespace vicus {
namespace {

constexpr double kFlat = 0.35;  // cells: a step or ridge lower than this needs no line
constexpr double kGood = 1.2;   // cells: a line that is farther off has all splits tried
constexpr std::size_t kMostSplits = 16;
constexpr double kOnSide = 1e-12;  // cells: cut pieces lie exactly on the sides of their cell
constexpr double kQuantum = std::numbers::sqrt2 / 2 / BLOCKMAP_OFFSET_STEPS;

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }  // no overflow here: hypot's care is slow

std::uint16_t steps_of(double up_m, const CellUnits& units) {
  return static_cast<std::uint16_t>(std::clamp(std::floor(up_m / units.step_m + 0.5), 0.0, 65535.0));
}
std::uint8_t stored_slope(double metres_a_cell, const CellUnits& units) {
  return static_cast<std::uint8_t>(std::clamp(
      std::floor(metres_a_cell / units.cell_m * BLOCKMAP_SLOPE_ONE + BLOCKMAP_SLOPE_ZERO + 0.5), 1.0, 255.0));
}

/// The outward normal of a region's border inside the cell is minus that along the cell's sides.
void add_sides(std::span<const CellPoint> points, double& east, double& north) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CellPoint a = points[k], b = points[k + 1 == points.size() ? 0 : k + 1];
    if (std::abs(std::abs(a.x) - 0.5) < kOnSide && std::abs(a.x - b.x) < kOnSide)
      east -= a.x > 0 ? std::abs(b.y - a.y) : -std::abs(b.y - a.y);
    if (std::abs(std::abs(a.y) - 0.5) < kOnSide && std::abs(a.y - b.y) < kOnSide)
      north -= a.y > 0 ? std::abs(b.x - a.x) : -std::abs(b.x - a.x);
  }
}

/// d where the half plane n p <= d covers `area` of the unit square around 0; a, b = |n|.
double offset_of_area(double area, double a, double b) {
  if (a < b) std::swap(a, b);
  double s = 0;
  if (2 * a * area <= b)
    s = std::sqrt(2 * a * b * area);
  else if (2 * a * (1 - area) <= b)
    s = a + b - std::sqrt(2 * a * b * (1 - area));
  else
    s = a * area + b / 2;
  return s - (a + b) / 2;
}

/// A cell of flat ground and nothing else is most cells.
std::optional<CellFit> fit_plain(const CellGround& ground, const CellUnits& units) {
  if (ground.east != 0 || ground.north != 0) return std::nullopt;
  CellFit f;
  f.height = steps_of(ground.up, units);
  f.slope_east = f.slope_north = BLOCKMAP_SLOPE_ZERO;
  f.ground_above = true;
  f.top_m = f.height * units.step_m;
  f.error_m = std::abs(f.top_m - ground.up) + ground.rough_m;
  return f;
}

/// Second moments of a convex polygon around 0.
void add_moments(std::span<const CellPoint> points, double& xx, double& xy, double& yy) {
  const CellPoint a = points[0];
  for (std::size_t k = 2; k < points.size(); ++k) {
    const CellPoint b = points[k - 1], c = points[k];
    const double area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    const double sx = a.x + b.x + c.x, sy = a.y + b.y + c.y;
    xx += area / 12 * (a.x * a.x + b.x * b.x + c.x * c.x + sx * sx);
    xy += area / 12 * (a.x * a.y + b.x * b.y + c.x * c.y + sx * sy);
    yy += area / 12 * (a.y * a.y + b.y * b.y + c.y * c.y + sy * sy);
  }
}

}  // namespace

struct CellFitter::Plane {
  double up = 0, east = 0, north = 0;  ///< at the middle; metres a cell
  double at(CellPoint p) const { return up + east * p.x + north * p.y; }
};

CellFitter::CellFitter(const CellPieces& pieces, const CellUnits& units) : pieces_(pieces), units_(units) {
  assert(units.cell_m > 0 && units.step_m > 0);
}

void CellFitter::collect(std::size_t cell) {
  roofs_ = pieces_.roofs_of(cell);
  walls_ = pieces_.walls_of(cell);
  parts_.clear();
  Part bare;
  bare.area = 1;
  bare.xx = bare.yy = 1.0 / 12;
  for (std::size_t i = 0; i < roofs_.size(); ++i) {
    const RoofPiece& p = roofs_[i];
    Part part;
    part.area = p.area;
    part.x = p.area * p.x;
    part.y = p.area * p.y;
    if (roofs_.size() > 1 || p.area < 1 - kRounding_m / units_.cell_m)
      add_moments(pieces_.points_of(p), part.xx, part.xy, part.yy);
    part.up = p.up_at({0, 0});
    part.east = p.east;
    part.north = p.north;
    part.mean_up = p.up;
    part.piece = &p;
    part.index = i;
    bare.area -= part.area;
    bare.x -= part.x;
    bare.y -= part.y;
    bare.xx -= part.xx;
    bare.xy -= part.xy;
    bare.yy -= part.yy;
    parts_.push_back(part);
  }
  if (bare.area > kRounding_m / units_.cell_m || parts_.empty()) {
    bare.up = ground_.up;
    bare.east = ground_.east;
    bare.north = ground_.north;
    bare.mean_up = ground_.up + (ground_.east * bare.x + ground_.north * bare.y) / bare.area;
    parts_.push_back(bare);
  }
  sort_by_height();
}

/// Stable. A few parts are mostly in order: for them no memory is asked for.
void CellFitter::sort_by_height() {
  constexpr std::size_t kFew = 24;
  if (parts_.size() > kFew) {
    std::stable_sort(parts_.begin(), parts_.end(), [](const Part& p, const Part& q) { return p.mean_up < q.mean_up; });
    return;
  }
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    if (parts_[i].mean_up >= parts_[i - 1].mean_up) continue;
    const Part part = parts_[i];
    std::size_t at = i;
    for (; at > 0 && part.mean_up < parts_[at - 1].mean_up; --at) parts_[at] = parts_[at - 1];
    parts_[at] = part;
  }
}

CellFit CellFitter::fit(std::size_t cell, const CellGround& ground) {
  ground_ = ground;
  if (pieces_.roofs_of(cell).empty())
    if (const auto plain = fit_plain(ground, units_)) return *plain;
  collect(cell);
  CellFit flat = with_plane(0);
  flat.error_m = plane_error(flat);
  if (flat.error_m <= kFlat * units_.cell_m || parts_.size() < 2) return flat;
  const std::size_t likely = best_split();
  CellFit best = with_line(likely);
  for (std::size_t k = 1; best.error_m > kGood * units_.cell_m && k < std::min(parts_.size(), kMostSplits); ++k)
    if (k != likely)
      if (const CellFit other = with_line(k); other.error_m < best.error_m) best = other;
  return best.error_m < flat.error_m ? best : flat;
}

CellFit CellFitter::with_line(std::size_t first) const {
  CellFit out = with_plane(first);
  add_line(out);
  out.error_m = line_error(out);
  return out;
}

/// Otsu: the split of the parts, by height, with the greatest variance between the two classes.
std::size_t CellFitter::best_split() const {
  double area = 0, moment = 0, below = 0, below_moment = 0, most = -1;
  for (const Part& p : parts_) area += p.area, moment += p.area * p.mean_up;
  std::size_t best = 1;
  for (std::size_t k = 1; k < parts_.size(); ++k) {
    below += parts_[k - 1].area;
    below_moment += parts_[k - 1].area * parts_[k - 1].mean_up;
    const double above = area - below, difference = (moment - below_moment) / above - below_moment / below;
    if (const double variance = below * above * difference * difference; variance > most) most = variance, best = k;
  }
  return best;
}

CellFitter::Plane CellFitter::plane_of(const CellFit& f) const {
  return {f.height * units_.step_m, slope_of(f.slope_east) * units_.cell_m, slope_of(f.slope_north) * units_.cell_m};
}

/// The plane of least squares through the parts from `first` on, and the foot of those before.
CellFit CellFitter::with_plane(std::size_t first) const {
  CellFit out;
  double below = 0, foot = 0;
  double least_east = 1e9, most_east = -1e9, least_north = 1e9, most_north = -1e9;
  double a = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, z = 0, zx = 0, zy = 0, east = 0, north = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& p = parts_[k];
    if (k < first) {
      below += p.area;
      foot += p.area * p.mean_up;
      continue;
    }
    a += p.area, x += p.x, y += p.y, xx += p.xx, xy += p.xy, yy += p.yy;
    z += p.up * p.area + p.east * p.x + p.north * p.y;
    zx += p.up * p.x + p.east * p.xx + p.north * p.xy;
    zy += p.up * p.y + p.east * p.xy + p.north * p.yy;
    east += p.area * p.east;
    north += p.area * p.north;
    least_east = std::min(least_east, p.east), most_east = std::max(most_east, p.east);
    least_north = std::min(least_north, p.north), most_north = std::max(most_north, p.north);
    if (p.piece)
      out.above |= 1u << std::min<std::size_t>(p.index, 31);
    else
      out.ground_above = true;
  }
  east /= a;
  north /= a;
  if (parts_.size() - first > 1) {  // around the centroid: two unknowns
    const double mx = x / a, my = y / a, vxx = xx - x * mx, vxy = xy - x * my, vyy = yy - y * my;
    const double vzx = zx - z * mx, vzy = zy - z * my, determinant = vxx * vyy - vxy * vxy;
    if (determinant > 1e-4 * (vxx + vyy) * (vxx + vyy)) {
      // A continuous roof leans no more than its steepest part; what leans more is a step between two roofs.
      east = std::clamp((vzx * vyy - vzy * vxy) / determinant, least_east, most_east);
      north = std::clamp((vzy * vxx - vzx * vxy) / determinant, least_north, most_north);
    }
  }
  out.slope_east = stored_slope(east, units_);
  out.slope_north = stored_slope(north, units_);
  const Plane rounded = plane_of(out);
  out.height = steps_of((z - rounded.east * x - rounded.north * y) / a, units_);
  if (below > 0) out.foot = steps_of(foot / below, units_);
  return out;
}

bool CellFitter::covers(CellPoint at) const {
  for (const RoofPiece& piece : roofs_) {
    const auto points = pieces_.points_of(piece);
    bool is_inside = true;
    for (std::size_t k = 0; k < points.size() && is_inside; ++k) {
      const CellPoint a = points[k], b = points[k + 1 == points.size() ? 0 : k + 1];
      is_inside = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x) >= 0;
    }
    if (is_inside) return true;
  }
  return false;
}

/// Corners of the bare ground: those of the cell that no roof covers, and the ends of walls that rise from it.
template <class Take>
void CellFitter::ground_corners(Take take) const {
  constexpr double kInside = 0.5 - 1e-9;
  for (const double x : {-kInside, kInside})
    for (const double y : {-kInside, kInside})
      if (!covers({x, y})) take(CellPoint{x, y});
  const double outside = kRounding_m / units_.cell_m;
  for (const WallPiece& w : walls_) {
    const double dx = w.b.x - w.a.x, dy = w.b.y - w.a.y, length = length_of(dx, dy);
    if (length < 1e-9) continue;
    const CellPoint beside{(w.a.x + w.b.x) / 2 + dy / length * outside, (w.a.y + w.b.y) / 2 - dx / length * outside};
    if (std::abs(beside.x) > 0.5 || std::abs(beside.y) > 0.5 || covers(beside)) continue;
    take(w.a);
    take(w.b);
  }
}

/// How far the plane passes from what stands in the cell, which has no line.
double CellFitter::plane_error(CellFit& f) const {
  const Plane plane = plane_of(f);
  double error = 0;
  for (const Part& part : parts_) {
    if (part.piece) {
      for (const CellPoint p : pieces_.points_of(*part.piece))
        error = std::max(error, std::abs(part.piece->up_at(p) - plane.at(p)));
    } else {
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          error = std::max(error, std::abs(ground_.up_at({x, y}) - plane.at({x, y})) + ground_.rough_m);
    }
  }
  f.top_m = plane.up + (std::abs(plane.east) + std::abs(plane.north)) / 2;
  return error;
}

void CellFitter::add_line(CellFit& f) const {
  double east = 0, north = 0, area = 0, mx = 0, my = 0;
  for (const Part& part : parts_) {
    if (!(part.piece ? is_above(f, part.index) : f.ground_above)) continue;
    area += part.area;
    mx += part.x;
    my += part.y;
    if (part.piece) add_sides(pieces_.points_of(*part.piece), east, north);
  }
  if (f.ground_above) {  // the rest of each side is ground
    east = north = 0;
    for (const Part& part : parts_)
      if (part.piece && !is_above(f, part.index)) add_sides(pieces_.points_of(*part.piece), east, north);
    east = -east;
    north = -north;
  }
  double length = length_of(east, north);
  if (length < 1e-3) {  // a house in the middle of the cell, or ground around a yard: away from what is above
    east = -mx;
    north = -my;
    length = length_of(east, north);
    if (length < 1e-9) east = 1, north = 0;
  }
  double turn = std::atan2(north, east) / (2 * std::numbers::pi) * 256;
  if (turn < 0) turn += 256;
  f.angle = static_cast<std::uint8_t>(static_cast<int>(turn + 0.5) & 255);
  const CellLine line = line_of(f.angle, 1);
  const double offset = offset_of_area(std::clamp(area, 0.0, 1.0), std::abs(line.east), std::abs(line.north));
  const double most = (std::abs(line.east) + std::abs(line.north)) / 2 - 1.5 * kQuantum;  // stays in the cell
  const double kept = std::clamp(offset, -most, most);
  f.offset =
      static_cast<std::uint8_t>(std::clamp(std::floor(kept / kQuantum + BLOCKMAP_OFFSET_ZERO + 0.5), 1.0, 255.0));
}

/// The part of the line inside the cell.
struct CellFitter::Chord {
  CellPoint a, b;

  explicit Chord(const CellLine& line) {
    double low = -2, high = 2;  // along the tangent (-north, east)
    const auto cut = [&](double start, double step) {
      if (std::abs(step) < 1e-12) return;
      const double s = (-0.5 - start) / step, t = (0.5 - start) / step;
      low = std::max(low, std::min(s, t));
      high = std::min(high, std::max(s, t));
    };
    cut(line.east * line.distance, -line.north);
    cut(line.north * line.distance, line.east);
    const auto at = [&](double t) {
      return CellPoint{line.east * line.distance - line.north * t, line.north * line.distance + line.east * t};
    };
    a = at(low);
    b = at(high);
  }
  double distance(CellPoint p) const {
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
    return length_of(p.x - a.x - t * dx, p.y - a.y - t * dy);
  }
};

double CellFitter::line_error(CellFit& f) const {
  const CellLine line = line_of(f.angle, f.offset);
  const Chord chord(line);
  const Plane plane = plane_of(f);
  const double foot = f.foot * units_.step_m, rise = length_of(plane.east, plane.north);
  // What the wall over every point of the line spans for certain.
  const double low = std::max(foot, std::min({foot, plane.at(chord.a), plane.at(chord.b)}));
  const double high = std::max(low, std::min(plane.at(chord.a), plane.at(chord.b)));
  double error2 = 0, slab = 0;
  const auto square_of = [](double v) { return v * v; };
  // One part by its corners: beside its plane on its own side, else beside the wall over the line.
  const auto judge = [&](bool above, auto corners, auto up_at, double rough) {
    double own2 = 0, wall2 = 0, wrong = 0;
    corners([&](CellPoint p) {
      const double side = line.east * p.x + line.north * p.y - line.distance, up = up_at(p);
      const double beyond = above ? std::max(0.0, side) : std::max(0.0, -side), aside = chord.distance(p);
      const double off = beyond > 0 ? aside : 0;
      const double residual = std::abs(up - (above ? plane.at(p) : foot)) + rough;
      own2 = std::max(own2, square_of(off * units_.cell_m) + square_of(residual + rise * off));
      wall2 =
          std::max(wall2, square_of(aside * units_.cell_m) + square_of(std::max({0.0, up - high, low - up}) + rough));
      wrong = std::max(wrong, beyond);
    });
    error2 = std::max(error2, std::min(own2, wall2));
    slab = std::max(slab, std::min(wrong, 1.0));
  };
  for (const Part& part : parts_) {
    if (part.piece)
      judge(
          is_above(f, part.index),
          [&](auto take) {
            for (const CellPoint p : pieces_.points_of(*part.piece)) take(p);
          },
          [&](CellPoint p) { return part.piece->up_at(p); }, 0.0);
    else
      judge(
          f.ground_above, [&](auto take) { ground_corners(take); }, [&](CellPoint p) { return ground_.up_at(p); },
          ground_.rough_m);
  }
  f.top_m = std::max(foot, plane.up + (std::abs(plane.east) + std::abs(plane.north)) / 2);
  // Back from the line's wall to the true one: it passes within the slab that both sides overlap in.
  f.back_m = slab * units_.cell_m;
  return std::max(std::sqrt(error2), f.back_m);
}

void CellFitter::true_corners(std::size_t cell, const CellGround& ground,
                              const std::function<void(CellPoint, double)>& take) {
  ground_ = ground;
  collect(cell);
  for (const Part& part : parts_) {
    if (part.piece)
      for (const CellPoint p : pieces_.points_of(*part.piece)) take(p, part.piece->up_at(p));
    else
      ground_corners([&](CellPoint p) { take(p, ground_.up_at(p)); });
  }
}

}  // namespace vicus
