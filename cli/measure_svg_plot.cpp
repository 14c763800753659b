#include "cli/measure_svg_plot.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "cli/measure_pareto.hpp"

namespace vicus::measure {
namespace {

constexpr double kWidth = 880, kHeight = 470, kLeft = 62, kTop = 44, kRight = 240, kBottom = 56;
constexpr double kPlotWidth = kWidth - kLeft - kRight, kPlotHeight = kHeight - kTop - kBottom;

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", v);
  return text;
}
std::string short_number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", v);
  return text;
}

std::string text_of(double v, PlotUnit unit) {
  if (unit == PlotUnit::bytes) return bytes_text(v);
  if (unit == PlotUnit::milliseconds) return v >= 1000 ? short_number(v / 1000) + " s" : short_number(v) + " ms";
  return short_number(v);
}

/// One axis: values to pixels, and where its ticks stand.
struct Axis {
  double low = 0, high = 1;
  bool is_log = false;
  double share(double v) const { return is_log ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low); }
  std::vector<double> ticks() const {
    std::vector<double> out;
    if (is_log) {
      // As many as fit: whole decades, else more within each.
      for (const std::vector<double>& within : {std::vector<double>{1}, {1, 2, 5}, {1, 1.5, 2, 3, 4, 5, 6, 8}}) {
        out.clear();
        for (double decade = std::pow(10, std::floor(std::log10(low))); decade <= high; decade *= 10)
          for (const double k : within)
            if (decade * k >= low * 0.999 && decade * k <= high * 1.001) out.push_back(decade * k);
        if (out.size() >= 3) break;
      }
      return out;
    }
    const double rough = (high - low) / 5, decade = std::pow(10, std::floor(std::log10(rough)));
    const double step = rough / decade < 1.5   ? decade
                        : rough / decade < 3.5 ? 2 * decade
                        : rough / decade < 7.5 ? 5 * decade
                                               : 10 * decade;
    for (double v = std::ceil(low / step - 1e-9) * step; v <= high + step * 1e-6; v += step)
      out.push_back(std::abs(v) < step * 1e-6 ? 0 : v);
    return out;
  }
};

Axis axis_of(double low, double high, bool is_log) {
  if (low > high) low = is_log ? 1 : 0, high = is_log ? 10 : 1;
  if (is_log) {
    low /= 1.25, high *= 1.25;
    return {low, std::max(high, low * 2), true};
  }
  return {0, high > 0 ? high * 1.06 : 1, false};
}

std::string marker(int kind, double x, double y, double r) {
  const auto polygon = [&](std::initializer_list<std::pair<double, double>> points) {
    std::string text = "<polygon points=\"";
    for (const auto& [dx, dy] : points) text += number(x + r * dx) + "," + number(y + r * dy) + " ";
    text.back() = '"';
    return text;
  };
  switch (kind % 4) {
    case 0:
      return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"" + number(r) + "\"";
    case 1:
      return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case 2:
      return polygon({{0, -1.15}, {1.05, 0.8}, {-1.05, 0.8}});
    default:
      return polygon({{0, -1.25}, {1.25, 0}, {0, 1.25}, {-1.25, 0}});
  }
}

class Drawing {
 public:
  explicit Drawing(const Plot& plot) : plot_(plot) {
    double x0 = 1e300, x1 = -1e300, y1 = 0;
    for (const PlotSeries& s : plot.series)
      for (const PlotPoint& p : s.points) {
        assert(!plot.is_log_x || p.x > 0);
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
      }
    x_ = axis_of(x0, x1, plot.is_log_x);
    y_ = axis_of(0, plot.most_y > 0 ? plot.most_y : y1, false);
  }

  std::string run() {
    out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) +
           "\" role=\"img\" aria-label=\"" + escaped(plot_.title) + "\">\n<style>" + kStyle + "</style>\n";
    out_ += "<rect class=\"paper\" width=\"100%\" height=\"100%\" rx=\"6\"/>\n";
    text(kLeft, 24, "title", "start", plot_.title);
    add_axes();
    add_front();
    for (const PlotSeries& s : plot_.series) add_series(s);
    add_legend();
    return out_ + "</svg>\n";
  }

 private:
  static constexpr const char* kStyle =
      "svg{font-family:'DejaVu Sans',system-ui,sans-serif;font-size:12px}.paper{fill:#fff}text{fill:#333}"
      ".title{font-size:15px;font-weight:600;fill:#111}.grid{stroke:#e4e4e4}.axis{stroke:#888;fill:none}"
      ".front{fill:none;stroke:#999;stroke-width:5;stroke-opacity:.35;stroke-linejoin:round}.halo{stroke:#fff;stroke-"
      "width:1}"
      "@media(prefers-color-scheme:dark){.paper{fill:#16191d}text{fill:#c9ced6}.title{fill:#f2f4f7}.grid{stroke:#"
      "2b3037}"
      ".axis{stroke:#6b7280}.front{stroke:#9aa3af}.halo{stroke:#16191d}}";

  double px(double v) const { return kLeft + kPlotWidth * x_.share(v); }
  double py(double v) const { return kTop + kPlotHeight * (1 - std::min(1.0, y_.share(v))); }

  void text(double x, double y, const char* kind, const char* anchor, const std::string& said, const char* more = "") {
    out_ += "<text class=\"" + std::string(kind) + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" +
            anchor + "\"" + more + ">" + escaped(said) + "</text>\n";
  }
  void line(const char* kind, double x0, double y0, double x1, double y1) {
    out_ += "<line class=\"" + std::string(kind) + "\" x1=\"" + number(x0) + "\" y1=\"" + number(y0) + "\" x2=\"" +
            number(x1) + "\" y2=\"" + number(y1) + "\"/>\n";
  }

  void add_axes() {
    for (const double v : x_.ticks()) {
      line("grid", px(v), kTop, px(v), kTop + kPlotHeight);
      text(px(v), kTop + kPlotHeight + 18, "tick", "middle", text_of(v, plot_.x_unit));
    }
    for (const double v : y_.ticks()) {
      line("grid", kLeft, py(v), kLeft + kPlotWidth, py(v));
      text(kLeft - 8, py(v) + 4, "tick", "end", short_number(v));
    }
    out_ += "<rect class=\"axis\" x=\"" + number(kLeft) + "\" y=\"" + number(kTop) + "\" width=\"" +
            number(kPlotWidth) + "\" height=\"" + number(kPlotHeight) + "\"/>\n";
    text(kLeft + kPlotWidth / 2, kHeight - 14, "label", "middle", plot_.x_label);
    const double middle = kTop + kPlotHeight / 2;
    text(16, middle, "label", "middle", plot_.y_label,
         (" transform=\"rotate(-90 16 " + number(middle) + ")\"").c_str());
  }

  void add_front() {
    std::vector<CostError> all;
    for (const PlotSeries& s : plot_.series)
      for (const PlotPoint& p : s.points) all.emplace_back(p.x, p.y);
    const auto front = pareto_front(all);
    if (front.size() < 2) return;
    std::string points;
    for (std::size_t i = 0; i < front.size(); ++i) {
      const auto& [x, y] = all[front[i]];
      if (i > 0) points += number(px(x)) + "," + number(py(all[front[i - 1]].second)) + " ";
      points += number(px(x)) + "," + number(py(y)) + " ";
    }
    out_ += "<polyline class=\"front\" points=\"" + points + "\"/>\n";
  }

  void add_series(const PlotSeries& s) {
    const auto& points = s.points;
    if (points.size() > 1) {
      out_ +=
          "<polyline fill=\"none\" stroke=\"" + s.colour + "\" stroke-width=\"1.6\" stroke-opacity=\".8\" points=\"";
      for (const PlotPoint& p : points) out_ += number(px(p.x)) + "," + number(py(p.y)) + " ";
      out_ += "\"/>\n";
    }
    for (const PlotPoint& p : points)
      out_ += marker(s.marker, px(p.x), py(p.y), 4.6) + " class=\"halo\" fill=\"" + s.colour + "\"><title>" +
              escaped(p.said) + "</title>" + (s.marker % 4 == 0 ? "</circle>" : "</polygon>") + "\n";
  }

  void add_legend() {
    std::vector<const PlotSeries*> order;
    for (const PlotSeries& s : plot_.series)
      if (!s.points.empty()) order.push_back(&s);
    const auto least = [](const PlotSeries* s) {
      double y = 1e300;
      for (const PlotPoint& p : s->points) y = std::min(y, p.y);
      return y;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](const PlotSeries* a, const PlotSeries* b) { return least(a) > least(b); });
    const double step = std::min(20.0, kPlotHeight / static_cast<double>(std::max<std::size_t>(1, order.size())));
    double y = kTop + 8;
    for (const PlotSeries* s : order) {
      out_ += marker(s->marker, kWidth - kRight + 20, y - 4, 4.6) + " fill=\"" + s->colour + "\"/>\n";
      text(kWidth - kRight + 32, y, "legend", "start", s->name);
      y += step;
    }
  }

  const Plot& plot_;
  Axis x_, y_;
  std::string out_;
};

}  // namespace

std::string bytes_text(double bytes) {
  char text[32];
  const double kb = bytes / 1000, mb = kb / 1000;
  if (bytes < 1000)
    std::snprintf(text, sizeof text, "%.0f B", bytes);
  else if (mb < 1)
    std::snprintf(text, sizeof text, kb < 10 ? "%.2g kB" : "%.0f kB", kb);
  else
    std::snprintf(text, sizeof text, mb < 10 ? "%.2g MB" : "%.0f MB", mb);
  return text;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string svg_of(const Plot& plot) { return Drawing(plot).run(); }

}  // namespace vicus::measure
