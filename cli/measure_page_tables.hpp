#pragma once
#include <map>
#include <string>
#include <vector>

#include "cli/measure_pareto.hpp"
#include "cli/measure_summary.hpp"

/// Tables of the report's page, as HTML; empty where there is nothing to say.
namespace vicus::measure {

/// Bytes at which each sweep reaches an error (cost_at); only errors that some sweep reaches.
std::string equal_table(const std::string& caption, const std::map<std::string, std::vector<CostError>>& sweeps,
                        const std::vector<double>& flips);
/// Every measure of every way, nearest to the truth first, folded.
std::string measures_table(std::vector<Summary> rows);
/// What is seen where something changes, largest first; where nothing is seen, how many.
std::string pops_section(const std::vector<Summary>& all);
/// The same ways in every size of pictures, over the views that were looked at in all sizes.
std::string sizes_section(const Results& results);

}  // namespace vicus::measure
