#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "sectorgen/build_city.hpp"
#include "sectorgen/models/guess_roof.hpp"

/// Guessed roofs against modelled ones: roof_truth [--crs EPSG:N] MODELS [STREETS...]
/// The models (CityJSON, CityGML) tell the truth. Then the same houses are built from footprint and total height alone.
/// Prints how many models were used as they are, how often the guessed form is right, and by how much eaves are off.
namespace vicus {
namespace {

City build(const LoadOptions& load, bool with_models) {
  std::vector<Issue> issues;
  SourceMap map = load_source_map(load, issues);
  if (!with_models) {
    map.models.clear();
    for (auto& f : map.footprints) f.tags.erase("roof:shape"), f.roof_shape = "flat";
  }
  BuildOptions options;
  options.with_textures = options.with_visibility = false;
  BuildReport report;
  return build_city(std::move(map), options, std::move(issues), report);
}

void print_errors(const char* what, std::vector<double> errors) {
  if (errors.empty()) return;
  double sum = 0;
  for (const double e : errors) sum += e;
  const double mean = sum / static_cast<double>(errors.size());
  for (double& e : errors) e = std::abs(e);
  std::sort(errors.begin(), errors.end());
  std::printf("%s: off by %.2f m in the median, %.2f m for nine of ten, %+.2f m on average\n", what,
              errors[errors.size() / 2], errors[errors.size() * 9 / 10], mean);
}

}  // namespace
}  // namespace vicus

int main(int argc, char** argv) try {
  using namespace vicus;
  LoadOptions load;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--crs" && i + 1 < argc)
      load.assumed_system = argv[++i];
    else
      load.inputs.emplace_back(argv[i]);
  if (load.inputs.empty()) return std::fputs("roof_truth [--crs EPSG:N] MODELS [STREETS...]\n", stderr), 2;
  const City truth = build(load, true), guess = build(load, false);
  std::map<std::string, int> unused;
  for (const auto& issue : truth.issues)
    if (issue.code == IssueCode::model_unused) ++unused[issue.message];
  std::map<std::string, const Building*> guesses;
  for (const auto& b : guess.buildings) guesses[b.id] = &b;
  int used = 0, typed = 0, right = 0, pitched_right = 0;
  std::map<std::pair<std::string, std::string>, int> forms;
  std::vector<double> eaves;
  for (const auto& b : truth.buildings) {
    const auto g = guesses.find(b.id);
    if (b.roof_source != RoofSource::model || g == guesses.end()) continue;
    ++used;
    pitched_right += (b.roof_shape == "flat") == (g->second->roof_shape == "flat");
    eaves.push_back(g->second->eave_m - b.eave_m);
    const auto type = b.tags.find("roof:shape");
    if (type == b.tags.end()) continue;
    ++typed;
    right += type->second == g->second->roof_shape;
    ++forms[{type->second, g->second->roof_shape}];
  }
  std::printf("%zu houses, %d with their own roof\n", truth.buildings.size(), used);
  for (const auto& [why, count] : unused) std::printf("  %d: %s\n", count, why.c_str());
  if (used == 0) return 1;
  std::printf("flat or not: guessed right %.1f %%\n", 100.0 * pitched_right / used);
  if (typed > 0) std::printf("form: guessed right %.1f %% of %d\n", 100.0 * right / typed, typed);
  for (const auto& [pair, count] : forms)
    if (10 * count >= typed / 10) std::printf("  %s, guessed %s: %d\n", pair.first.c_str(), pair.second.c_str(), count);
  print_errors("eaves", eaves);
} catch (const vicus::CityError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return error.exit_code;
}
