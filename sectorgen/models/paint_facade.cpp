#include "sectorgen/models/paint_facade.hpp"

#include <algorithm>
#include <cmath>

#include "sectorgen/models/paint_openings.hpp"

namespace vicus {
namespace {

constexpr double kPixelsPerMetre = 13;

class FacadePainter {
 public:
  FacadePainter(const Facade& facade, Colour colour)
      : facade_(facade),
        figures_(figures_of(facade.style)),
        width_(pattern_width_m(facade)),
        height_(pattern_height_m(facade)),
        wall_(paint_of(colour)),
        canvas_(texture_side(width_ * kPixelsPerMetre), texture_side(height_ * kPixelsPerMetre), width_, height_) {}

  Canvas paint() {
    canvas_.rectangle(0, 0, width_, height_, wall_);
    stain();
    switch (facade_.style) {
      case FacadeStyle::stone:
        rustication();
        plinth();
        string_courses(0.18);
        break;
      case FacadeStyle::brick:
        courses_of_brick();
        plinth();
        string_courses(0.10);
        break;
      case FacadeStyle::plaster:
        plinth();
        if (facade_.floors > 1) course(1, 0.14);
        break;
      case FacadeStyle::church:
        ashlar();
        plinth();
        break;
      case FacadeStyle::modern:
        panels();
        break;
      case FacadeStyle::shed:
        boards();
        break;
    }
    for (const Opening& o : pattern_openings(facade_)) {
      surround(o);
      paint_opening(canvas_, o);
    }
    cornice();
    return std::move(canvas_);
  }

 private:
  /// Stains of rain and dust in three sizes, lighter upwards.
  void stain() {
    canvas_.shade([&](double z) {
      const double base = 0.93 + 0.03 * z / height_;
      return [base, large = NoiseLine(z * 0.3, width_ * 0.45, 1), middle = NoiseLine(z * 0.8, width_ * 1.6, 2),
              small = NoiseLine(z * 7, width_ * 7, 3)](double x) {
        return base + 0.10 * (0.5 * large(x * 0.45) + 0.3 * middle(x * 1.6) + 0.2 * small(x * 7));
      };
    });
  }
  /// Of a floor above the lowest: as the style has it; of own windows half a metre below them.
  double floor_line(int floor) const {
    if (facade_.openings.empty()) return figures_.ground_floor + (floor - 1) * figures_.storey;
    double low = height_;
    for (const Opening& o : facade_.openings)
      if (o.floor == floor) low = std::min(low, o.z0);
    return low - 0.5;
  }
  /// A band along a floor, where no window stands in its way.
  void course(int floor, double thickness) {
    const double z = floor_line(floor) - 0.1;
    const bool is_free = facade_.openings.empty() ||
                         std::none_of(facade_.openings.begin(), facade_.openings.end(),
                                      [&](const Opening& o) { return o.z0 < z + thickness + 0.1 && o.z1 > z - 0.1; });
    if (is_free) band(z, thickness);
  }
  void band(double z, double thickness) {
    canvas_.rectangle(0, z, width_, z + thickness, wall_ * 1.06);
    canvas_.rectangle(0, z - 0.05, width_, z, wall_ * 0.72);
  }
  void plinth() {
    canvas_.rectangle(0, 0, width_, 0.55, wall_ * 0.80);
    canvas_.rectangle(0, 0.55, width_, 0.6, wall_ * 1.05);
  }
  void rustication() {
    const double top = facade_.floors > 1 ? floor_line(1) : std::min(figures_.ground_floor, height_ / 2);
    for (double z = 0; z < top - 0.2; z += 0.42) {
      canvas_.rectangle(0, z, width_, z + 0.035, wall_ * 0.72);
      canvas_.rectangle(0, z + 0.035, width_, z + 0.06, wall_ * 1.08);
    }
  }
  void string_courses(double thickness) {
    for (int floor = 1; floor < facade_.floors; ++floor) {
      const bool is_strong = floor == 1 || floor == facade_.floors - 1;
      course(floor, is_strong ? thickness : thickness / 2);
    }
  }
  void courses_of_brick() {
    for (double z = 0; z < height_; z += 0.3) canvas_.rectangle(0, z, width_, z + 0.06, wall_ * 1.12, 0.5);
  }
  void ashlar() {
    for (double z = 0; z < height_; z += 0.6) canvas_.rectangle(0, z, width_, z + 0.05, wall_ * 0.82, 0.6);
  }
  void panels() {
    for (int floor = 1; floor < facade_.floors; ++floor) {
      const double z = floor_line(floor);
      canvas_.rectangle(0, z - 0.15, width_, z + 0.1, wall_ * 0.90);
    }
    for (int bay = 0; facade_.openings.empty() && bay <= facade_.bays; ++bay)
      canvas_.rectangle(bay * figures_.bay - 0.03, 0, bay * figures_.bay + 0.03, height_, wall_ * 0.86);
  }
  void boards() {
    for (double x = 0; x < width_; x += 0.25) canvas_.rectangle(x, 0, x + 0.05, height_, wall_ * 0.88);
  }

  void surround(const Opening& o) {
    const bool is_rich = facade_.style == FacadeStyle::stone;
    if (facade_.style == FacadeStyle::modern || facade_.style == FacadeStyle::shed || o.kind == OpeningKind::shop)
      return;
    const double t = is_rich ? 0.17 : 0.12;
    const Paint light = facade_.style == FacadeStyle::brick ? mix(wall_, {0.85, 0.82, 0.75}, 0.55) : wall_ * 1.07;
    canvas_.rectangle(o.x0 - t, o.z0, o.x1 + t, o.z1 + t, light);
    canvas_.rectangle(o.x1 + t, o.z0, o.x1 + t + 0.04, o.z1 + t, wall_ * 0.8, 0.6);
    const bool is_window = o.z0 > 0.15;
    if (!is_window) return;
    canvas_.rectangle(o.x0 - t - 0.05, o.z0 - 0.12, o.x1 + t + 0.05, o.z0, light);
    canvas_.rectangle(o.x0 - t - 0.05, o.z0 - 0.18, o.x1 + t + 0.05, o.z0 - 0.12, wall_ * 0.75, 0.8);
    if (!is_rich || o.floor < 1 || o.floor > 2) return;
    canvas_.rectangle(o.x0 - t - 0.1, o.z1 + t + 0.06, o.x1 + t + 0.1, o.z1 + t + 0.18, wall_ * 1.1);
    canvas_.rectangle(o.x0 - t - 0.1, o.z1 + t, o.x1 + t + 0.1, o.z1 + t + 0.06, wall_ * 0.75);
  }

  void cornice() {
    const double h = figures_.cornice;
    if (facade_.style == FacadeStyle::shed || facade_.style == FacadeStyle::modern) {
      canvas_.rectangle(0, height_ - 0.12, width_, height_, wall_ * 0.7);
      return;
    }
    canvas_.rectangle(0, height_ - 0.8 * h, width_, height_, wall_ * 1.07);
    canvas_.rectangle(0, height_ - 0.9 * h, width_, height_ - 0.8 * h, wall_ * 0.58);
    if (facade_.style == FacadeStyle::stone)
      for (double x = 0.1; x < width_; x += 0.34)
        canvas_.rectangle(x, height_ - 0.7 * h, x + 0.17, height_ - 0.42 * h, wall_ * 0.78);
    canvas_.rectangle(0, height_ - 0.08, width_, height_, wall_ * 0.62);
  }

  const Facade& facade_;
  const StyleFigures& figures_;
  double width_, height_;
  Paint wall_;
  Canvas canvas_;
};

}  // namespace

Canvas paint_facade(const Facade& facade, Colour wall) { return FacadePainter(facade, wall).paint(); }

}  // namespace vicus
