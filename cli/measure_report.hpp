#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/measure_results.hpp"

/// The report of one run: plots and one page that holds everything.
namespace vicus::measure {

/// What was run, and where.
struct RunFacts {
  std::string city, version, walk_name, processor;
  std::uint64_t seed = 0;
  int samples = 0;
  std::size_t houses = 0, sectors = 0;
  unsigned cores = 0;
  double walk_m = 0, fly_radius_m = 0, load = 0;  ///< load: of the machine, when the run ended
};
RunFacts facts_of_machine();
std::string json_of(const RunFacts& facts);
/// Fails   CityError: no JSON of json_of.
RunFacts facts_from_json(const std::string& text);

struct Results {
  RunFacts facts;
  std::vector<ViewRow> views;
  std::vector<TimeRow> times;
  std::vector<PopRow> pops;
  std::vector<CodecRow> codecs;
};

/// Path of a kept picture below the report's folder.
std::string picture_path(const std::string& path, int view, const std::string& family, const std::string& setting);

/// Path below the report's folder, SVG text; light and dark by the reader's own setting.
std::vector<std::pair<std::string, std::string>> plots_of(const Results& results);

/// One HTML file that needs no other. `picture`: bytes of a WebP by its path, empty where there is none.
std::string page_of(const Results& results, const std::function<std::string(const std::string& path)>& picture);

/// Of each path the Pareto front of bytes and mean FLIP, as JSON.
std::string best_json(const Results& results);

}  // namespace vicus::measure
