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

constexpr double kFlat = 0.35;         // cells: a step or ridge lower than this needs no line
constexpr double kOnSide = 1e-12;      // cells: cut pieces lie exactly on the sides of their cell
constexpr double kLeastGround = 1e-7;  // cells: what rounding leaves of a covered cell
constexpr double kQuantum = std::numbers::sqrt2 / 2 / BLOCKMAP_OFFSET_STEPS;

/// What a cell is made of: roof pieces and the bare ground.
struct Part {
  double area = 0, x = 0, y = 0, up = 0, east = 0, north = 0;
  const RoofPiece* piece = nullptr;  ///< null: ground
  std::size_t index = 0;
};

struct Plane {
  double up = 0, east = 0, north = 0;  ///< at the middle; metres a cell
  double at(CellPoint p) const { return up + east * p.x + north * p.y; }
};

class Fitter {
 public:
  Fitter(const CellPieces& pieces, std::size_t cell, const CellGround& ground, const CellUnits& units)
      : pieces_(pieces), roofs_(pieces.roofs_of(cell)), ground_(ground), units_(units) {
    double covered = 0, x = 0, y = 0;
    for (std::size_t i = 0; i < roofs_.size(); ++i) {
      const RoofPiece& p = roofs_[i];
      parts_.push_back({p.area, p.x, p.y, p.up, p.east, p.north, &p, i});
      covered += p.area;
      x += p.area * p.x;
      y += p.area * p.y;
    }
    const double bare = 1 - covered;
    if (bare > kLeastGround) {
      const CellPoint middle{std::clamp(-x / bare, -0.5, 0.5), std::clamp(-y / bare, -0.5, 0.5)};
      parts_.push_back({bare, middle.x, middle.y, ground.up_at(middle), ground.east, ground.north, nullptr, 0});
    }
    std::stable_sort(parts_.begin(), parts_.end(), [](const Part& p, const Part& q) { return p.up < q.up; });
  }

  CellFit fit() const {
    CellFit flat = with_plane(0);
    flat.error_m = plane_error(flat);
    if (flat.error_m <= kFlat * units_.cell_m || parts_.size() < 2) return flat;
    CellFit lined = with_plane(best_split());
    add_line(lined);
    lined.error_m = line_error(lined);
    return lined.error_m < flat.error_m ? lined : flat;
  }

 private:
  /// Otsu: the split of the parts, by height, with the greatest variance between the two classes.
  std::size_t best_split() const {
    double area = 0, moment = 0, below = 0, below_moment = 0, most = -1;
    for (const Part& p : parts_) area += p.area, moment += p.area * p.up;
    std::size_t best = 1;
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      below += parts_[k - 1].area;
      below_moment += parts_[k - 1].area * parts_[k - 1].up;
      const double above = area - below, difference = (moment - below_moment) / above - below_moment / below;
      if (const double variance = below * above * difference * difference; variance > most) most = variance, best = k;
    }
    return best;
  }

  std::uint16_t steps(double up_m) const {
    return static_cast<std::uint16_t>(std::clamp(std::floor(up_m / units_.step_m + 0.5), 0.0, 65535.0));
  }
  std::uint8_t slope(double metres_a_cell) const {
    return static_cast<std::uint8_t>(std::clamp(
        std::floor(metres_a_cell / units_.cell_m * BLOCKMAP_SLOPE_ONE + BLOCKMAP_SLOPE_ZERO + 0.5), 1.0, 255.0));
  }
  Plane plane_of(const CellFit& f) const {
    return {f.height * units_.step_m, slope_of(f.slope_east) * units_.cell_m, slope_of(f.slope_north) * units_.cell_m};
  }

  /// The plane of the parts from `first` on, and the foot of those before.
  CellFit with_plane(std::size_t first) const {
    CellFit out;
    double area = 0, east = 0, north = 0, below = 0, foot = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const Part& p = parts_[k];
      if (k < first) {
        below += p.area;
        foot += p.area * p.up;
        continue;
      }
      area += p.area;
      east += p.area * p.east;
      north += p.area * p.north;
      if (p.piece)
        out.above |= 1u << std::min<std::size_t>(p.index, 31);
      else
        out.ground_above = true;
    }
    out.slope_east = slope(east / area);
    out.slope_north = slope(north / area);
    const Plane rounded = plane_of(out);
    double up = 0;
    for (std::size_t k = first; k < parts_.size(); ++k)
      up += parts_[k].area / area * (parts_[k].up - rounded.east * parts_[k].x - rounded.north * parts_[k].y);
    out.height = steps(up);
    if (below > 0) out.foot = steps(foot / below);
    return out;
  }

  bool covers(const CellFit& f, CellPoint at, bool only_above) const {
    for (std::size_t i = 0; i < roofs_.size(); ++i) {
      if (only_above && !is_above(f, i)) continue;
      const auto points = pieces_.points_of(roofs_[i]);
      bool is_inside = true;
      for (std::size_t k = 0; k < points.size() && is_inside; ++k) {
        const CellPoint a = points[k], b = points[k + 1 == points.size() ? 0 : k + 1];
        is_inside = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x) >= 0;
      }
      if (is_inside) return true;
    }
    return false;
  }

  /// Corners of the bare ground: those of the cell that no roof covers, and the corners of the roofs.
  template <class Take>
  void ground_corners(const CellFit& f, Take take) const {
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        if (!covers(f, {x, y}, false)) take(CellPoint{x, y});
    for (const RoofPiece& piece : roofs_)
      for (const CellPoint p : pieces_.points_of(piece))
        if (touches_ground(f, p)) take(p);
  }
  /// Is there bare ground right beside the point? Eight looks around it; a wedge narrower than 45 degrees may be missed.
  bool touches_ground(const CellFit& f, CellPoint p) const {
    constexpr double kNear = 1e-6, kDiagonal = kNear * std::numbers::sqrt2 / 2;
    for (const auto& [dx, dy] : {std::pair{kNear, 0.0}, {kDiagonal, kDiagonal}, {0.0, kNear}, {-kDiagonal, kDiagonal},
                                 {-kNear, 0.0}, {-kDiagonal, -kDiagonal}, {0.0, -kNear}, {kDiagonal, -kDiagonal}}) {
      const CellPoint q{p.x + dx, p.y + dy};
      if (std::abs(q.x) <= 0.5 && std::abs(q.y) <= 0.5 && !covers(f, q, false)) return true;
    }
    return false;
  }

  /// How far the plane passes from what stands in the cell, which has no line.
  double plane_error(CellFit& f) const {
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

  void add_line(CellFit& f) const {
    double east = 0, north = 0, area = 0, mx = 0, my = 0;
    for (const Part& part : parts_) {
      const bool above = part.piece ? is_above(f, part.index) : f.ground_above;
      if (!above) continue;
      area += part.area;
      mx += part.area * part.x;
      my += part.area * part.y;
      if (part.piece) add_sides(pieces_.points_of(*part.piece), east, north);
    }
    if (f.ground_above) {  // the rest of each side is ground
      east = north = 0;
      for (const Part& part : parts_)
        if (part.piece && !is_above(f, part.index)) add_sides(pieces_.points_of(*part.piece), east, north);
      east = -east;
      north = -north;
    }
    double length = std::hypot(east, north);
    if (length < 1e-3) {  // a house in the middle of the cell, or ground around a yard: away from what is above
      east = -mx;
      north = -my;
      length = std::hypot(east, north);
      if (length < 1e-9) east = length = 1, north = 0;
    }
    double turn = std::atan2(north, east) / (2 * std::numbers::pi) * 256;
    if (turn < 0) turn += 256;
    f.angle = static_cast<std::uint8_t>(static_cast<int>(turn + 0.5) & 255);
    const CellLine line = line_of(f.angle, 1);
    const double offset = offset_of_area(std::clamp(area, 0.0, 1.0), std::abs(line.east), std::abs(line.north));
    const double most = (std::abs(line.east) + std::abs(line.north)) / 2 - 1.5 * kQuantum;  // stays in the cell
    const double kept = std::clamp(offset, -most, most);
    f.offset = static_cast<std::uint8_t>(
        std::clamp(std::floor(kept / kQuantum + BLOCKMAP_OFFSET_ZERO + 0.5), 1.0, 255.0));
  }

  /// The outward normal of a region's border inside the cell is minus that along the cell's sides.
  static void add_sides(std::span<const CellPoint> points, double& east, double& north) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const CellPoint a = points[k], b = points[k + 1 == points.size() ? 0 : k + 1];
      if (std::abs(std::abs(a.x) - 0.5) < kOnSide && std::abs(a.x - b.x) < kOnSide)
        east -= a.x > 0 ? std::abs(b.y - a.y) : -std::abs(b.y - a.y);
      if (std::abs(std::abs(a.y) - 0.5) < kOnSide && std::abs(a.y - b.y) < kOnSide)
        north -= a.y > 0 ? std::abs(b.x - a.x) : -std::abs(b.x - a.x);
    }
  }

  /// d where the half plane n p <= d covers `area` of the unit square around 0; a, b = |n|.
  static double offset_of_area(double area, double a, double b) {
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

  struct Chord {
    CellPoint a, b;
    double distance(CellPoint p) const {
      const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
      const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
      return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
    }
  };
  static Chord chord_of(const CellLine& line) {
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
    return {at(low), at(high)};
  }

  double line_error(CellFit& f) const {
    const CellLine line = line_of(f.angle, f.offset);
    const Chord chord = chord_of(line);
    const Plane plane = plane_of(f);
    const double foot = f.foot * units_.step_m, rise = std::hypot(plane.east, plane.north);
    const double low = std::min({foot, plane.at(chord.a), plane.at(chord.b)});
    const double high = std::max({foot, plane.at(chord.a), plane.at(chord.b)});
    double error = 0, slab = 0;
    // One part by its corners: beside its plane on its own side, else beside the wall over the line.
    const auto judge = [&](bool above, auto corners, auto up_at, double rough) {
      double own = 0, wall = 0, wrong = 0;
      corners([&](CellPoint p) {
        const double side = line.east * p.x + line.north * p.y - line.distance, up = up_at(p);
        const double beyond = above ? std::max(0.0, side) : std::max(0.0, -side);
        const double residual = std::abs(up - (above ? plane.at(p) : foot)) + rough;
        const double aside = beyond > 0 ? chord.distance(p) : 0;
        own = std::max(own, std::hypot(aside * units_.cell_m, residual + rise * aside));
        wall = std::max(wall, std::hypot(chord.distance(p) * units_.cell_m,
                                         std::max({0.0, up - high + rise, low - up}) + rough));
        wrong = std::max(wrong, beyond);
      });
      error = std::max(error, std::min(own, wall));
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
            f.ground_above, [&](auto take) { ground_corners(f, take); }, [&](CellPoint p) { return ground_.up_at(p); },
            ground_.rough_m);
    }
    f.top_m = std::max(foot, plane.up + (std::abs(plane.east) + std::abs(plane.north)) / 2);
    // Back from the line's wall to the true one: it passes within the slab that both sides overlap in.
    return std::max(error, slab * units_.cell_m);
  }

  const CellPieces& pieces_;
  std::span<const RoofPiece> roofs_;
  const CellGround& ground_;
  const CellUnits& units_;
  std::vector<Part> parts_;
};

/// A cell of one plane and nothing else is most cells: no search.
std::optional<CellFit> fit_plain(const CellGround& ground, const CellUnits& units) {
  const double steps = std::floor(ground.up / units.step_m + 0.5);
  if (ground.east != 0 || ground.north != 0 || steps < 0 || steps > 65535) return std::nullopt;
  CellFit f;
  f.height = static_cast<std::uint16_t>(steps);
  f.slope_east = f.slope_north = BLOCKMAP_SLOPE_ZERO;
  f.ground_above = true;
  f.top_m = f.height * units.step_m;
  f.error_m = std::abs(f.top_m - ground.up) + ground.rough_m;
  return f;
}

}  // namespace

CellFit fit_cell(const CellPieces& pieces, std::size_t cell, const CellGround& ground, const CellUnits& units) {
  assert(units.cell_m > 0 && units.step_m > 0);
  if (pieces.roofs_of(cell).empty())
    if (const auto plain = fit_plain(ground, units)) return *plain;
  return Fitter(pieces, cell, ground, units).fit();
}

}  // namespace vicus
