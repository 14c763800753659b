#pragma once
#include <string>

#include "city_db/city.hpp"

/// The sheet a map is drawn on: SVG elements, plan to pixels, legend below the map.
namespace vicus {

/// "#rrggbb"; hue in degrees, saturation and lightness 0 ... 1.
std::string hsl_colour(double hue_deg, double saturation, double lightness);

class SvgPaper {
 public:
  /// Needs   box not empty (assert). The longer side of the box gets `side_px`.
  SvgPaper(const PlanBox& box, double side_px);

  void begin_map();
  void end_map();
  /// An empty colour is none.
  void polygon(const Polygon& polygon, const std::string& fill, const std::string& stroke, double opacity = 1);
  void line(const std::vector<PlanPoint>& points, const std::string& colour, double width_px,
            const std::string& dashes);
  /// Text with a white rim, centred `below_px` below the point.
  void label(PlanPoint at, const std::string& text, double size_px, double below_px);
  void legend_line(const std::string& what, const std::string& colour);
  void legend_box(const std::string& what, const std::string& colour);
  void title(const std::string& title, const std::string& attribution);
  /// The whole document, with scale bar.
  std::string finish();

 private:
  void point(PlanPoint p);
  void text(double x, double y, double size_px, const std::string& text, const std::string& more = {});
  void legend_entry(const std::string& shape, const std::string& what);

  PlanBox box_;
  double px_per_mm_, width_px_, height_px_;
  double legend_x_ = 0, legend_y_ = 0;
  std::string out_;
};

}  // namespace vicus
