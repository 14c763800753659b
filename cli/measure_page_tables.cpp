#include "cli/measure_page_tables.hpp"

#include <algorithm>
#include <set>

#include "cli/measure_page_parts.hpp"

namespace vicus::measure {
namespace {

constexpr double kSeen = 0.0005;  // less is rounding

}  // namespace

std::string equal_table(const std::string& caption, const std::map<std::string, std::vector<CostError>>& sweeps,
                        const std::vector<double>& flips) {
  std::string out;
  std::set<double> used;
  for (const auto& [name, sweep] : sweeps)
    for (const double flip : flips)
      if (cost_at(sweep, flip)) used.insert(-flip);
  if (used.empty()) return out;
  out += "<div class=\"wide\"><table class=\"equal\"><caption>" + caption +
         " (between measured settings; empty: not reached, or better at every setting)</caption><thead><tr><th></th>";
  for (const double flip : used) out += "<th>" + number_text(-flip, 3) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (const auto& [name, sweep] : sweeps) {
    out += "<tr><td>" + escaped(name) + "</td>";
    for (const double flip : used) {
      const auto cost = cost_at(sweep, -flip);
      out += "<td>" + (cost ? bytes_text(*cost) : "") + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string measures_table(std::vector<Summary> rows) {
  std::string out;
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Summary& a, const Summary& b) { return a.errors.flip < b.errors.flip; });
  out +=
      "<details><summary>Every way and every measure, nearest to the truth first</summary><div "
      "class=\"wide\"><table><thead><tr><th>Way</th><th>Bytes</th><th>Requests</th><th>Whole path</th><th>Memory</th>"
      "<th>FLIP</th><th>p99</th><th>of houses</th><th>SSIM</th><th>PSNR dB</th><th>Silhouette IoU</th><th>Skyline "
      "px</th><th>Geometry mean px</th><th>p99</th><th>max</th><th>Decode ms</th><th>Draw ms</th><th>GPU "
      "ms</th></tr></thead><tbody>\n";
  for (const Summary& s : rows) {
    const ViewErrors& e = s.errors;
    out += "<tr><td>" + escaped(s.full()) + "</td>";
    for (const std::string& cell :
         {bytes_text(s.bytes), number_text(s.requests, 0), bytes_text(s.path_bytes), bytes_text(s.memory_bytes),
          number_text(e.flip, 4), number_text(e.flip_p99, 2), number_text(e.flip_houses, 3), number_text(e.ssim, 3),
          number_text(e.psnr_db, 1), number_text(e.silhouette_iou, 4), number_text(e.skyline_mean_px, 2),
          number_text(e.depth_mean_px, 3), number_text(e.depth_p99_px, 2), number_text(e.depth_max_px, 1),
          number_text(s.decode_cpu_ms, 1), number_text(s.draw_cpu_ms, 0), std::string()})
      out += "<td>" + cell + "</td>";
    out += "</tr>\n";
  }
  return out + "</tbody></table></div></details>\n";
}

std::string pops_section(const std::vector<Summary>& all) {
  std::string out;
  std::vector<const Summary*> rows;
  for (const Summary& s : all)
    if (s.pops > 0) rows.push_back(&s);
  if (rows.empty()) return out;
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Summary* a, const Summary* b) { return a->pop_mean > b->pop_mean; });
  out += "<section><h2>Popping</h2>\n";
  out += paragraph(
      "Where a way changes what it shows, the last frame before is held against the first after. The visitor moved "
      "as well, so the truth's own change between the two frames is taken off: what is left is the pop.");
  out +=
      "<div class=\"wide\"><table><thead><tr><th>Way</th><th>Path</th><th>Changes on it</th><th>Looked "
      "at</th><th>Pop, mean</th><th>largest</th></tr></thead><tbody>\n";
  std::size_t unseen = 0;
  for (const Summary* s : rows) {
    if (s->pop_most < kSeen) {
      ++unseen;
      continue;
    }
    out += "<tr><td>" + escaped(s->full()) + "</td><td>" + s->path + "</td><td>" + std::to_string(s->switches) +
           "</td><td>" + std::to_string(s->pops) + "</td><td>" + number_text(s->pop_mean, 4) + "</td><td>" +
           number_text(s->pop_most, 4) + "</td></tr>\n";
  }
  if (unseen > 0)
    out += "<tr><td>" + std::to_string(unseen) +
           " others</td><td></td><td></td><td></td><td>none seen</td><td></td></tr>\n";
  return out + "</tbody></table></div></section>\n";
}

std::string sizes_section(const Results& results) {
  std::string out;
  std::map<std::pair<std::string, int>, std::set<std::pair<int, int>>> looked_at;
  std::set<std::pair<int, int>> sizes;
  for (const ViewRow& row : results.views) {
    looked_at[{row.path, row.view}].insert({row.width, row.height});
    sizes.insert({row.width, row.height});
  }
  if (sizes.size() < 2) return out;
  Results shared = results;  // only views that were looked at in all sizes, or their means say nothing
  std::erase_if(shared.views, [&](const ViewRow& row) {
    return looked_at[{row.path, row.view}].size() < sizes.size();
  });
  const auto all = summaries_of(shared);
  std::map<std::string, std::map<std::pair<int, int>, const Summary*>> by_form;
  for (const Summary& s : all) by_form[s.path + ": " + s.full()][{s.width, s.height}] = &s;
  out += "<section><h2>Larger pictures</h2>\n";
  out += paragraph(
      "The same ways at each size, on those views that were looked at in all of them. Ways with a tolerance in pixels "
      "send "
      "more where there are more pixels.");
  out += "<details><summary>All ways by size</summary><div class=\"wide\"><table><thead><tr><th></th>";
  for (const auto& [w, h] : sizes)
    out += "<th>" + std::to_string(w) + " x " + std::to_string(h) + ": bytes</th><th>FLIP</th><th>geometry p99 px</th>";
  out += "</tr></thead><tbody>\n";
  for (const auto& [name, by_size] : by_form) {
    out += "<tr><td>" + escaped(name) + "</td>";
    for (const auto& size : sizes) {
      const auto at = by_size.find(size);
      if (at == by_size.end())
        out += "<td></td><td></td><td></td>";
      else
        out += "<td>" + bytes_text(at->second->bytes) + "</td><td>" + number_text(at->second->errors.flip, 4) +
               "</td><td>" + number_text(at->second->errors.depth_p99_px, 2) + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div></details></section>\n";
}

}  // namespace vicus::measure
