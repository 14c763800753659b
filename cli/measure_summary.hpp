#pragma once
#include <string>
#include <vector>

#include "cli/measure_report.hpp"

namespace vicus::measure {

/// One representation on one path in one size of pictures: means over its views, the largest of maxima.
struct Summary {
  std::string family, setting, path;
  double tau_px = 0;
  int width = 0, height = 0;
  std::size_t views = 0;
  double bytes = 0, requests = 0;            ///< of a view
  double path_bytes = 0, path_requests = 0;  ///< of all its views together, each file once
  double memory_bytes = 0;
  ViewErrors errors;
  double draw_cpu_ms = 0, decode_cpu_ms = 0;
  int switches = 0;                   ///< of the path
  double pop_mean = 0, pop_most = 0;  ///< excess change at those that were looked at
  std::size_t pops = 0;               ///< how many
  std::string full() const { return setting.empty() ? family : family + ", " + setting; }
};

/// In the order of measuring; by size, then path, then representation.
std::vector<Summary> summaries_of(const Results& results);
/// Of one path in the run's first size.
std::vector<Summary> of_path(const std::vector<Summary>& all, const std::string& path);

}  // namespace vicus::measure
