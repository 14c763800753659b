#include "cli/measure_summary.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace vicus::measure {
namespace {

void add_errors(ViewErrors& sum, const ViewErrors& e) {
  sum.depth_mean_px += e.depth_mean_px, sum.depth_p99_px += e.depth_p99_px;
  sum.silhouette_iou += e.silhouette_iou, sum.skyline_mean_px += e.skyline_mean_px;
  sum.psnr_db += e.psnr_db, sum.ssim += e.ssim;
  sum.flip += e.flip, sum.flip_p99 += e.flip_p99, sum.flip_houses += e.flip_houses;
  sum.depth_max_px = std::max(sum.depth_max_px, e.depth_max_px);
  sum.skyline_max_px = std::max(sum.skyline_max_px, e.skyline_max_px);
}

void divide(ViewErrors& e, double n) {
  for (double* v : {&e.depth_mean_px, &e.depth_p99_px, &e.silhouette_iou, &e.skyline_mean_px, &e.psnr_db, &e.ssim,
                    &e.flip, &e.flip_p99, &e.flip_houses})
    *v /= n;
}

}  // namespace

std::vector<Summary> summaries_of(const Results& results) {
  using Key = std::tuple<int, int, std::string, std::string, std::string>;
  std::map<Key, std::size_t> places;
  std::vector<Summary> out;
  const auto at = [&](const auto& row) {
    return places.find({row.width, row.height, row.path, row.family, row.setting});
  };
  for (const ViewRow& row : results.views) {
    const auto [place, is_new] =
        places.emplace(Key{row.width, row.height, row.path, row.family, row.setting}, out.size());
    if (is_new) {
      Summary s;
      s.family = row.family, s.setting = row.setting, s.path = row.path, s.tau_px = row.tau_px;
      s.width = row.width, s.height = row.height;
      s.errors.silhouette_iou = s.errors.ssim = 0;
      out.push_back(s);
    }
    Summary& s = out[place->second];
    ++s.views;
    s.bytes += static_cast<double>(row.bytes), s.requests += static_cast<double>(row.requests);
    s.path_bytes += static_cast<double>(row.new_bytes), s.path_requests += static_cast<double>(row.new_requests);
    s.memory_bytes += row.memory_bytes;
    add_errors(s.errors, row.errors);
  }
  for (const TimeRow& row : results.times)
    if (const auto place = at(row); place != places.end()) {
      out[place->second].draw_cpu_ms += row.draw_cpu_ms;
      out[place->second].decode_cpu_ms += row.decode_cpu_ms;
    }
  for (const PopRow& row : results.pops)
    if (const auto place = at(row); place != places.end()) {
      Summary& s = out[place->second];
      s.switches = row.switches;
      s.pop_mean += row.excess();
      s.pop_most = std::max(s.pop_most, row.excess());
      ++s.pops;
    }
  for (Summary& s : out) {
    const auto n = static_cast<double>(s.views);
    s.bytes /= n, s.requests /= n, s.memory_bytes /= n, s.draw_cpu_ms /= n, s.decode_cpu_ms /= n;
    divide(s.errors, n);
    if (s.pops > 0) s.pop_mean /= static_cast<double>(s.pops);
  }
  return out;
}

std::vector<Summary> of_path(const std::vector<Summary>& all, const std::string& path) {
  std::vector<Summary> out;
  for (const Summary& s : all)
    if (s.path == path && s.width == all.front().width && s.height == all.front().height) out.push_back(s);
  return out;
}

}  // namespace vicus::measure
