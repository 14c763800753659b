#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cli/measure_page_parts.hpp"
#include "cli/measure_page_tables.hpp"
#include "cli/measure_pareto.hpp"
#include "cli/measure_plots.hpp"
#include "cli/measure_report.hpp"
#include "cli/measure_summary.hpp"

namespace vicus::measure {
namespace {

constexpr double kBudgets[] = {10e3, 30e3, 100e3, 300e3, 1e6, 3e6};
constexpr double kFlips[] = {0.20, 0.15, 0.10, 0.05, 0.02};
constexpr double kCodecFlips[] = {0.10, 0.05, 0.03, 0.02, 0.01, 0.005};

class Page {
 public:
  Page(const Results& results, const std::function<std::string(const std::string& path)>& picture)
      : results_(results), picture_(picture), all_(summaries_of(results)), plots_(named_plots(results)) {}

  std::string run() {
    const RunFacts& f = results_.facts;
    out_ = page_head("Speed against error: " + f.city);
    add_head();
    for (const char* path : {"walk", "fly", "overview"})
      if (!of_path(all_, path).empty()) add_path(path);
    add_codecs();
    out_ += pops_section(all_);
    out_ += sizes_section(results_);
    add_method();
    out_ += "</main>\n</body>\n</html>\n";
    return std::move(out_);
  }

 private:
  static std::string title_of(const std::string& path) {
    return path == "walk" ? "On foot" : path == "fly" ? "In flight" : "From far above";
  }

  void add_head() {
    const RunFacts& f = results_.facts;
    std::set<std::string> forms;
    for (const Summary& s : all_) forms.insert(s.full());
    out_ += "<header><p class=\"eyebrow\">vicus measure</p><h1>" + escaped(f.city) + ", sent " +
            std::to_string(forms.size()) +
            " ways</h1>\n<p class=\"lead\">A city can be sent whole, street by street, as tiles or as "
            "pictures. Each way costs bytes, memory and time, and each shows something that is not quite the city. "
            "Here all of them "
            "are held against the same truth, at the same places.</p>\n<dl class=\"facts\">" +
            fact(std::to_string(f.houses), "houses") + fact(std::to_string(f.sectors), "sectors") +
            fact(std::to_string(results_.views.size()), "pictures compared") +
            fact(number_text(f.walk_m, 0) + " m", "walked") + fact("3 km", "flown") + "</dl></header>\n";
  }

  void add_path(const std::string& path) {
    const auto rows = of_path(all_, path);
    out_ += "<section><h2>" + title_of(path) + "</h2>\n";
    add_winners(path, rows);
    for (const NamedPlot& plot : plots_)
      if (plot.name == path + "-bytes")
        add_plot(plot,
                 "The grey line is the Pareto front: nothing measured is both smaller and nearer to the truth. Points "
                 "of one colour are one way at several settings. Rest the mouse on a point to read it.");
    add_pictures(path, rows);
    add_equal(path, rows);
    for (const NamedPlot& plot : plots_) {
      if (plot.name == path + "-memory")
        add_plot(plot,
                 "Geometry alone: for each pixel, how far away the other picture has its depth; farther than 3 pixels "
                 "counts 4.");
      if (plot.name == path + "-cpu")
        add_plot(plot,
                 "On one machine's CPU, by rays, so that all ways are drawn alike; a graphics card will order them "
                 "differently.");
    }
    out_ += measures_table(rows);
    out_ += "</section>\n";
  }

  void add_plot(const NamedPlot& plot, const std::string& caption) {
    out_ += "<figure class=\"plot\">" + svg_of(plot.plot) + "<figcaption>" + caption + "</figcaption></figure>\n";
  }

  /// The best of a budget, and where it is no longer the same.
  void add_winners(const std::string& path, const std::vector<Summary>& rows) {
    std::vector<CostError> points;
    for (const Summary& s : rows) points.emplace_back(s.bytes, s.errors.flip);
    const auto front = pareto_front(points);
    if (front.empty()) return;
    const Summary &cheapest = rows[front.front()], &best = rows[front.back()];
    out_ += paragraph("The smallest, <b>" + escaped(cheapest.full()) + "</b>, takes " + bytes_text(cheapest.bytes) +
                      " a view and is " + number_text(cheapest.errors.flip, 3) +
                      " from the truth in mean FLIP (0: the same, 1: as different as can be). The nearest, <b>" +
                      escaped(best.full()) + "</b>, takes " + bytes_text(best.bytes) + " for " +
                      number_text(best.errors.flip, 3) + ". " + std::to_string(front.size()) + " of the " +
                      std::to_string(rows.size()) + " ways measured " +
                      (path == "walk"  ? "on foot"
                       : path == "fly" ? "in flight"
                                       : "here") +
                      " are beaten by no other.");
    out_ +=
        "<table class=\"budget\"><caption>What to take, by the bytes that a view may "
        "cost</caption><thead><tr><th>Budget</th><th>Take</th><th>Bytes</th><th>FLIP</th><th>Requests</th></tr></"
        "thead><tbody>\n";
    std::string before;
    for (const double budget : kBudgets) {
      const Summary* take = nullptr;
      for (const std::size_t i : front)
        if (rows[i].bytes <= budget) take = &rows[i];
      if (take == nullptr || take->full() == before) continue;
      before = take->full();
      out_ += "<tr><td>" + bytes_text(budget) + "</td><td>" + escaped(take->full()) + "</td><td>" +
              bytes_text(take->bytes) + "</td><td>" + number_text(take->errors.flip, 3) + "</td><td>" +
              number_text(take->requests, 0) + "</td></tr>\n";
    }
    out_ += "</tbody></table>\n";
  }

  /// Truth, then of each family the setting with the least error, those on the front first.
  void add_pictures(const std::string& path, const std::vector<Summary>& rows) {
    constexpr std::size_t kMost = 8;
    std::map<std::string, const Summary*> by_family;
    for (const Summary& s : rows) {
      const Summary*& known = by_family[s.family];
      if (known == nullptr || s.errors.flip < known->errors.flip) known = &s;
    }
    std::vector<const Summary*> order;
    for (const auto& [family, s] : by_family) order.push_back(s);
    std::stable_sort(order.begin(), order.end(),
                     [](const Summary* a, const Summary* b) { return a->bytes < b->bytes; });
    const auto is_shown = [](const Summary* s) {  // families that look alike are shown once
      return s->family != "full model" && s->family != "GLB, meshopt" && s->family != "LOD2" && s->family != "LOD4" &&
             s->family != "both tiles" && s->family != "BlockMap 2007 32:192" && s->family != "BlockMap+ 32" &&
             s->family != "BlockMap+ 256";
    };
    std::erase_if(order, [&](const Summary* s) { return !is_shown(s); });
    if (order.size() > kMost) order.resize(kMost);
    std::set<int> views;
    for (const ViewRow& row : results_.views)
      if (row.path == path && !picture_(picture_path(path, row.view, "truth", "")).empty()) views.insert(row.view);
    for (const int view : views) {
      out_ += "<figure><div class=\"pictures\">" + image(picture_path(path, view, "truth", ""), "<b>the truth</b>");
      for (const Summary* s : order) {
        const ViewRow* row = row_of(*s, view);
        if (row == nullptr) continue;
        out_ += image(picture_path(path, view, s->family, s->setting),
                      escaped(s->full()) + "<br>" + bytes_text(static_cast<double>(row->bytes)) + ", FLIP " +
                          number_text(row->errors.flip, 3));
      }
      out_ += "</div><figcaption>View " + std::to_string(view + 1) +
              ", each way at the setting with its least error, by bytes.</figcaption></figure>\n";
    }
  }

  const ViewRow* row_of(const Summary& s, int view) const {
    for (const ViewRow& row : results_.views)
      if (row.view == view && row.path == s.path && row.family == s.family && row.setting == s.setting &&
          row.width == s.width)
        return &row;
    return nullptr;
  }

  std::string image(const std::string& path, const std::string& caption) const {
    const std::string bytes = picture_(path);
    if (bytes.empty()) return "";
    return "<figure><img loading=\"lazy\" alt=\"\" src=\"data:image/webp;base64," + base64(bytes) + "\"><figcaption>" +
           caption + "</figcaption></figure>\n";
  }

  /// Bytes at equal FLIP of all families with several settings.
  void add_equal(const std::string&, const std::vector<Summary>& rows) {
    std::map<std::string, std::vector<CostError>> sweeps;
    for (const Summary& s : rows) sweeps[s.family].emplace_back(s.bytes, s.errors.flip);
    std::erase_if(sweeps, [](const auto& sweep) { return sweep.second.size() < 2; });
    out_ += equal_table("Bytes of a view at equal FLIP", sweeps, {std::begin(kFlips), std::end(kFlips)});
  }

  void add_codecs() {
    if (results_.codecs.empty()) return;
    out_ += "<section><h2>Codecs at equal FLIP</h2>\n";
    out_ += paragraph(
        "A codec's own quality number says nothing about another's. So each codes the same content over all of its "
        "range, is shown, and what it shows is held against the same content not coded. Bytes are then compared where "
        "the error is the same.");
    for (const std::string& content : contents_of(results_.codecs)) {
      std::map<std::string, std::vector<CostError>> sweeps;
      for (const CodecRow& row : results_.codecs)
        if (row.content == content) sweeps[row.codec].emplace_back(row.bytes, row.flip);
      for (const NamedPlot& plot : plots_)
        if (plot.plot.title == "Codecs: " + content)
          add_plot(plot, content == "street geometry"
                             ? "The near sectors of three places of the walk; steps of positions from 1 mm to 1 m; "
                               "bytes without images."
                             : "The tiles of three places of the flight; bytes of planes and pictures.");
      std::erase_if(sweeps, [](const auto& sweep) { return sweep.second.size() < 2; });
      out_ += equal_table("Bytes at equal FLIP: " + content, sweeps, {std::begin(kCodecFlips), std::end(kCodecFlips)});
    }
    out_ += "</section>\n";
  }

  void add_method() {
    const RunFacts& f = results_.facts;
    std::map<std::string, std::map<std::pair<int, int>, std::set<int>>> views;
    for (const ViewRow& row : results_.views) views[row.path][{row.width, row.height}].insert(row.view);
    out_ +=
        "<section><h2>How it was measured</h2>\n<ul>\n<li><b>Truth</b>: every facade in level 4, ray-traced "
        "(Embree), " +
        std::to_string(f.samples) + " rays a pixel; the same light for all.</li>\n<li><b>Key views</b>: ";
    std::string list;
    for (const auto& [path, by_size] : views)
      for (const auto& [size, numbers] : by_size)
        list += (list.empty() ? "" : "; ") + path + " " + std::to_string(numbers.size()) + " at " +
                std::to_string(size.first) + " x " + std::to_string(size.second);
    out_ += list + ". Walk: " + escaped(f.walk_name) + ", " + number_text(f.walk_m, 0) +
            " m, eye 1.7 m up. Flight: 3 km on a circle of " + number_text(f.fly_radius_m, 0) +
            " m, 150 m up, 30 degrees down.</li>\n"
            "<li><b>Bytes</b>: all files that show a view, as the server sends them (brotli; images as PNG), each "
            "once. From the street those of L<sub>1</sub>, from the air all sectors.</li>\n"
            "<li><b>Memory</b>: what a graphics card holds: 96 bytes a triangle, images as RGBA with mipmaps, tiles as "
            "textures.</li>\n"
            "<li><b>Errors</b>: FLIP (Andersson et al. 2020), SSIM and PSNR of the part that is not sky, silhouettes "
            "and skyline against the sky, projected error of depth.</li>\n"
            "<li><b>Time</b>: CPU, drawn by rays, on " +
            escaped(f.processor) + ", " + std::to_string(f.cores) + " cores, load " + number_text(f.load, 1) +
            " at the end. <b>GPU time was not measured</b>: there was no graphics card; its column is empty.</li>\n"
            "<li><b>Repeat</b>: vicus " +
            escaped(f.version) + ", seed " + std::to_string(f.seed) +
            ". Beside this page lie views.csv, times.csv, pops.csv, codecs.csv and the plots.</li>\n</ul></section>\n";
  }

  const Results& results_;
  const std::function<std::string(const std::string& path)>& picture_;
  std::vector<Summary> all_;
  std::vector<NamedPlot> plots_;
  std::string out_;
};

}  // namespace

std::string page_of(const Results& results, const std::function<std::string(const std::string& path)>& picture) {
  return Page(results, picture).run();
}

}  // namespace vicus::measure
