#include <algorithm>
#include <map>

#include "cli/measure_plots.hpp"
#include "cli/measure_summary.hpp"

namespace vicus::measure {
namespace {

struct Look {
  const char* colour;
  int marker;
};

/// Sector files blue, glTF violet, our tiles green, those of the papers orange, pictures red.
Look look_of(const std::string& family) {
  static const std::map<std::string, Look> kLooks = {{"full model", {"#5b7fb8", 1}},
                                                     {"LOD1", {"#7fb2e5", 0}},
                                                     {"LOD2", {"#559bd8", 0}},
                                                     {"LOD3", {"#2f7fc4", 0}},
                                                     {"LOD4", {"#1f66b0", 0}},
                                                     {"far sectors", {"#4aa3b5", 2}},
                                                     {"as the page", {"#3763d4", 3}},
                                                     {"gate impostors", {"#d64550", 3}},
                                                     {"GLB, Draco", {"#8e5cc9", 0}},
                                                     {"GLB, meshopt", {"#c05cb9", 2}},
                                                     {"both tiles", {"#0f8a5f", 3}},
                                                     {"prisms", {"#58a618", 1}},
                                                     {"BlockMap+ 32", {"#9bc53d", 0}},
                                                     {"BlockMap+ 64", {"#6fb34b", 0}},
                                                     {"BlockMap+ 128", {"#36a36b", 0}},
                                                     {"BlockMap+ 256", {"#178f85", 0}},
                                                     {"BlockMap 2007 32:192", {"#e9a23b", 2}},
                                                     {"BlockMap 2007 64:256", {"#e07b28", 2}},
                                                     {"BlockMap 2009 128:512", {"#c8553d", 1}}};
  const auto known = kLooks.find(family);
  return known != kLooks.end() ? known->second : Look{"#888888", 1};
}

Plot plot_from(const std::vector<Summary>& rows, const std::function<double(const Summary&)>& x,
               const std::function<double(const Summary&)>& y) {
  Plot plot;
  for (const Summary& s : rows) {
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const PlotSeries& known) { return known.name == s.family; });
    if (series == plot.series.end()) {
      const Look look = look_of(s.family);
      series = plot.series.insert(plot.series.end(), {s.family, look.colour, look.marker, {}});
    }
    if (!(x(s) > 0)) continue;
    char flip[32];
    std::snprintf(flip, sizeof flip, "%.3f", s.errors.flip);
    series->points.push_back({x(s), y(s), s.full() + ": " + bytes_text(s.bytes) + ", FLIP " + flip});
  }
  return plot;
}

std::string path_title(const std::string& path) {
  return path == "walk" ? "Walking" : path == "fly" ? "Flying" : "Overview";
}

Plot codec_plot(const std::vector<CodecRow>& rows, const std::string& content) {
  static const char* const kColours[] = {"#3763d4", "#8e5cc9", "#c05cb9", "#178f85", "#e07b28"};
  Plot plot;
  plot.title = "Codecs: " + content;
  plot.x_label = "bytes";
  plot.y_label = "mean FLIP against the same, not coded";
  plot.x_unit = PlotUnit::bytes;
  for (const CodecRow& row : rows) {
    if (row.content != content) continue;
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const PlotSeries& known) { return known.name == row.codec; });
    if (series == plot.series.end()) {
      const std::size_t n = plot.series.size();
      series = plot.series.insert(plot.series.end(), {row.codec, kColours[n % 5], static_cast<int>(n % 4), {}});
    }
    char flip[32];
    std::snprintf(flip, sizeof flip, "%.4f", row.flip);
    series->points.push_back(
        {row.bytes, row.flip, row.codec + ", " + row.setting + ": " + bytes_text(row.bytes) + ", FLIP " + flip});
  }
  return plot;
}

}  // namespace

std::vector<std::string> contents_of(const std::vector<CodecRow>& rows) {
  std::vector<std::string> out;
  for (const CodecRow& row : rows)
    if (std::find(out.begin(), out.end(), row.content) == out.end()) out.push_back(row.content);
  return out;
}

std::vector<NamedPlot> named_plots(const Results& results) {
  std::vector<NamedPlot> out;
  const auto all = summaries_of(results);
  for (const char* path : {"walk", "fly", "overview"}) {
    const auto rows = of_path(all, path);
    if (rows.empty()) continue;
    const std::string where = path_title(path) + " through " + results.facts.city;
    const auto flip = [](const Summary& s) { return s.errors.flip; };
    const auto add = [&](const std::string& name, Plot plot, const char* x_label, const char* y_label, PlotUnit unit) {
      plot.title = where;
      plot.x_label = x_label;
      plot.y_label = y_label;
      plot.x_unit = unit;
      out.push_back({std::string(path) + "-" + name, std::move(plot)});
    };
    add("bytes",
        plot_from(
            rows, [](const Summary& s) { return s.bytes; }, flip),
        "bytes sent for a view, mean", "error: mean FLIP", PlotUnit::bytes);
    if (std::string_view(path) == "overview") continue;
    add("memory",
        plot_from(
            rows, [](const Summary& s) { return s.memory_bytes; },
            [](const Summary& s) { return s.errors.depth_p99_px; }),
        "memory to draw a view, mean", "geometry: 99th percentile, px (4: farther)", PlotUnit::bytes);
    add("cpu",
        plot_from(
            rows, [](const Summary& s) { return s.draw_cpu_ms + s.decode_cpu_ms; }, flip),
        "CPU time to decode and draw a view by rays, mean", "error: mean FLIP", PlotUnit::milliseconds);
  }
  for (const std::string& content : contents_of(results.codecs))
    out.push_back({"codecs-" + content.substr(0, content.find(' ')), codec_plot(results.codecs, content)});
  return out;
}

std::vector<std::pair<std::string, std::string>> plots_of(const Results& results) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const NamedPlot& plot : named_plots(results)) out.emplace_back("plots/" + plot.name + ".svg", svg_of(plot.plot));
  return out;
}

}  // namespace vicus::measure
