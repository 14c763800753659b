#pragma once
#include <string>
#include <vector>

/// Small plots as SVG, for light and dark backgrounds alike.
namespace vicus::measure {

struct PlotPoint {
  double x = 0, y = 0;
  std::string said;  ///< shown when the mouse rests on it
};

/// Points joined by a line in their order: a sweep of one setting.
struct PlotSeries {
  std::string name;
  std::string colour;  ///< "#rrggbb", to be told from black and white alike
  int marker = 0;      ///< 0 ... 3: disc, square, triangle, diamond
  std::vector<PlotPoint> points;
};

enum class PlotUnit { number, bytes, milliseconds };

struct Plot {
  std::string title, x_label, y_label;
  PlotUnit x_unit = PlotUnit::number;
  bool is_log_x = true;
  double most_y = 0;  ///< 0: by the points
  std::vector<PlotSeries> series;
};

/// A whole document; its colours follow the reader's setting (prefers-color-scheme). The Pareto front of all points is
/// drawn beneath them. A legend stands on the right, series by their least y.
/// Needs   x > 0 where is_log_x (assert).
std::string svg_of(const Plot& plot);

/// "12 kB", "1.3 MB".
std::string bytes_text(double bytes);
/// Characters that XML and HTML set apart, as entities.
std::string escaped(const std::string& text);

}  // namespace vicus::measure
