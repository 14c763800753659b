#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "city_db/store.hpp"
#include "sectorgen/geo/source_map.hpp"
#include "sectorgen/models/roof_build.hpp"
#include "sectorgen/models/solid_check.hpp"

/// Roofs of every form on every footprint of a map or of a built city: roof_bench FORM[,FORM...] MAP|CITY.gpkg [FAULTS]
/// One line per form: how many came out as asked, perturbed, hipped instead, flat; microseconds; seconds in all.
/// FAULTS: prints as many footprints that failed, with the reason.
int main(int argc, char** argv) {
  using namespace vicus;
  if (argc < 3) return std::fputs("roof_bench FORM[,FORM...] MAP|CITY.gpkg [FAULTS]\n", stderr), 2;
  std::vector<Polygon> plans;
  const std::string path = argv[2];
  if (path.ends_with(".gpkg")) {
    for (auto& b : read_city(path).buildings) plans.push_back(std::move(b.footprint));
  } else {
    LoadOptions load;
    load.inputs = {path};
    std::vector<Issue> issues;
    for (auto& f : load_source_map(load, issues).footprints) plans.push_back(std::move(f.area));
  }
  if (plans.empty()) return std::fputs("no footprints\n", stderr), 1;
  std::printf("%zu footprints\n%-12s %8s %8s %8s %8s %6s %6s %6s %8s %8s %9s\n", plans.size(), "form", "asked",
              "perturb", "other", "flat", "p50us", "p90us", "p99us", "max us", "total s", "facets");
  int faults = argc > 3 ? std::atoi(argv[3]) : 0;
  std::string forms = argv[1];
  for (std::size_t from = 0; from < forms.size();) {
    const std::size_t to = std::min(forms.find(',', from), forms.size());
    const std::string name = forms.substr(from, to - from);
    from = to + 1;
    RoofRequest request;
    request.form = roof_form_of(name).value();
    std::map<RoofRung, int> rungs;
    std::map<std::string, int> reasons;
    std::vector<double> us;
    double total = 0, off = 0;
    std::size_t facets = 0;
    for (std::size_t i = 0; i < plans.size(); ++i) {
      request.seed = i;
      const auto start = std::chrono::steady_clock::now();
      const BuiltRoof built = build_roof(plans[i], 12, request);
      us.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
      total += us.back() * 1e-6;
      ++rungs[built.rung];
      if (!built.fault.empty()) ++reasons[built.fault];
      facets += built.roof.facets.size();
      for (const auto& facet : built.roof.facets) off = std::max(off, off_plane_m(built.roof, facet));
      if (const auto fault = fault_of_roof(plans[i], 12, built.roof))
        std::printf("UNSOUND %zu: %s\n", i, fault->c_str());
      if (built.rung != RoofRung::asked && faults > 0 && (built.rung == RoofRung::flat || plans[i].outer.size() < 8)) {
        --faults;
        std::printf("flat %zu (%s): ", i, built.fault.c_str());
        for (const auto p : plans[i].outer) std::printf("%d,%d ", p.x, p.y);
        for (const auto& h : plans[i].holes) {
          std::printf(" hole ");
          for (const auto p : h) std::printf("%d,%d ", p.x, p.y);
        }
        std::printf("\n");
      }
    }
    std::sort(us.begin(), us.end());
    const auto at = [&](double q) { return us[static_cast<std::size_t>(q * static_cast<double>(us.size() - 1))]; };
    std::printf("%-12s %8d %8d %8d %8d %6.0f %6.0f %6.0f %8.0f %8.2f %9zu  worst planarity %.2f mm\n", name.c_str(),
                rungs[RoofRung::asked], rungs[RoofRung::perturbed], rungs[RoofRung::other_form], rungs[RoofRung::flat],
                at(.5), at(.9), at(.99), us.back(), total, facets, off * 1000);
    for (const auto& [reason, count] : reasons) std::printf("    first fault %6d  %s\n", count, reason.c_str());
    std::fflush(stdout);
  }
}
