#pragma once
#include <string>
#include <vector>

#include "cli/measure_report.hpp"
#include "cli/measure_svg_plot.hpp"

namespace vicus::measure {

struct NamedPlot {
  std::string name;  ///< "walk-bytes", "fly-memory", "codecs-street", ...
  Plot plot;
};
/// All plots of a report.
std::vector<NamedPlot> named_plots(const Results& results);

/// What was coded, each once.
std::vector<std::string> contents_of(const std::vector<CodecRow>& rows);

}  // namespace vicus::measure
