#include "x3d_export/svg_paper.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "x3d_export/colours.hpp"
#include "x3d_export/text.hpp"

namespace vicus {
namespace {

constexpr double kLeastWidth_px = 700;  // the title and the legend need so much
constexpr double kLegendHeight_px = 96, kEntryWidth_px = 115, kRow_px = 17;

std::string px(double value) {
  std::string out;
  append_number(out, value, 2);
  return out;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "='" + value + "'";
}

}  // namespace

std::string hsl_colour(double hue_deg, double saturation, double lightness) {
  const double chroma = (1 - std::abs(2 * lightness - 1)) * saturation;
  const auto channel = [&](double offset_deg) {
    const double sextant = std::fmod(hue_deg + offset_deg, 360.0) / 60;
    const double ramp = std::clamp(std::abs(sextant - 3) - 1, 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * (lightness + chroma * (ramp - 0.5))));
  };
  return hex_of({channel(0), channel(240), channel(120)});
}

SvgPaper::SvgPaper(const PlanBox& box, double side_px) : box_(box) {
  assert(!box.is_empty());
  const double width_mm = std::max(1.0, double(box.max.x) - box.min.x),
               height_mm = std::max(1.0, double(box.max.y) - box.min.y);
  px_per_mm_ = side_px / std::max(width_mm, height_mm);
  width_px_ = std::max(kLeastWidth_px, width_mm * px_per_mm_);
  height_px_ = height_mm * px_per_mm_;
  legend_y_ = height_px_ + 44;
}

void SvgPaper::point(PlanPoint p) {
  append_number(out_, (double(p.x) - box_.min.x) * px_per_mm_, 2);
  out_ += ' ';
  append_number(out_, (double(box_.max.y) - p.y) * px_per_mm_, 2);
}

void SvgPaper::begin_map() {
  out_ += "<clipPath id='map'><rect width='" + px(width_px_) + "' height='" + px(height_px_) + "'/></clipPath>\n";
  out_ += "<g clip-path='url(#map)' stroke-linejoin='round'>\n";
}

void SvgPaper::end_map() { out_ += "</g>\n"; }

void SvgPaper::polygon(const Polygon& polygon, const std::string& fill, const std::string& stroke, double opacity) {
  out_ += "<path d='";
  const auto ring = [this](const Ring& points) {
    char command = 'M';
    for (const auto& p : points) {
      out_ += command;
      point(p);
      command = 'L';
    }
    out_ += 'Z';
  };
  ring(polygon.outer);
  for (const auto& hole : polygon.holes) ring(hole);
  out_ += "'" + attribute("fill", fill.empty() ? "none" : fill) + " fill-rule='evenodd'";
  if (!stroke.empty()) out_ += attribute("stroke", stroke) + " stroke-width='0.5'";
  if (opacity < 1) out_ += attribute("opacity", px(opacity));
  out_ += "/>\n";
}

void SvgPaper::line(const std::vector<PlanPoint>& points, const std::string& colour, double width_px,
                    const std::string& dashes) {
  out_ += "<path d='";
  char command = 'M';
  for (const auto& p : points) {
    out_ += command;
    point(p);
    command = 'L';
  }
  out_ += "' fill='none'" + attribute("stroke", colour) + attribute("stroke-width", px(width_px));
  if (!dashes.empty()) out_ += attribute("stroke-dasharray", dashes);
  out_ += "/>\n";
}

void SvgPaper::text(double x, double y, double size_px, const std::string& text, const std::string& more) {
  out_ += "<text" + attribute("x", px(x)) + attribute("y", px(y)) + attribute("font-size", px(size_px)) +
          " font-family='sans-serif' fill='#222'" + more + ">" + xml_escaped(text) + "</text>\n";
}

void SvgPaper::label(PlanPoint at, const std::string& what, double size_px, double below_px) {
  const double x = (double(at.x) - box_.min.x) * px_per_mm_, y = (double(box_.max.y) - at.y) * px_per_mm_ + below_px;
  // Twice, rim first: paint-order is not known everywhere.
  text(x, y, size_px, what, " text-anchor='middle' stroke='#fff' stroke-width='2' stroke-opacity='0.8'");
  text(x, y, size_px, what, " text-anchor='middle'");
}

void SvgPaper::legend_entry(const std::string& shape, const std::string& what) {
  if (legend_x_ + kEntryWidth_px > width_px_) {
    legend_x_ = 0;
    legend_y_ += kRow_px;
  }
  out_ += shape;
  text(legend_x_ + 38, legend_y_ + 4, 11, what);
  legend_x_ += kEntryWidth_px;
}

void SvgPaper::legend_line(const std::string& what, const std::string& colour) {
  if (legend_x_ + kEntryWidth_px > width_px_) {
    legend_x_ = 0;
    legend_y_ += kRow_px;
  }
  legend_entry("<path d='M" + px(legend_x_ + 12) + " " + px(legend_y_) + "h20'" + attribute("stroke", colour) +
                   " stroke-width='2.5'/>\n",
               what);
}

void SvgPaper::legend_box(const std::string& what, const std::string& colour) {
  if (legend_x_ + kEntryWidth_px > width_px_) {
    legend_x_ = 0;
    legend_y_ += kRow_px;
  }
  legend_entry("<rect" + attribute("x", px(legend_x_ + 12)) + attribute("y", px(legend_y_ - 6)) +
                   " width='20' height='11' stroke='#888' stroke-width='0.5'" + attribute("fill", colour) + "/>\n",
               what);
}

void SvgPaper::title(const std::string& title, const std::string& attribution) {
  text(12, height_px_ + 22, 16, title);
  text(12, legend_y_ + 2 * kRow_px - 4, 10, attribution);
}

std::string SvgPaper::finish() {
  // The scale bar: the longest of 1, 2, 5 x 10^n metres within 200 px, on the right of the title's line.
  double bar_m = 1;
  for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0, 20000.0})
    if (step * kMmPerMetre * px_per_mm_ <= 200) bar_m = step;
  const double bar_px = bar_m * kMmPerMetre * px_per_mm_, x = width_px_ - bar_px - 20, y = height_px_ + 24;
  out_ += "<path d='M" + px(x) + " " + px(y - 6) + "v6h" + px(bar_px) + "v-6' fill='none' stroke='#222'/>\n";
  text(x - 8, y, 12, px(bar_m) + " m", " text-anchor='end'");
  const double height = std::max(height_px_ + kLegendHeight_px, legend_y_ + 2 * kRow_px + 8);
  return "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg' width='" + px(width_px_) +
         "' height='" + px(height) + "' viewBox='0 0 " + px(width_px_) + " " + px(height) +
         "'>\n<rect width='100%' height='100%' fill='#fff'/>\n" + out_ + "</svg>\n";
}

}  // namespace vicus
